#pragma once
// The middle layer of DXF reading: sections, blocks and entities as the file holds them, in its own units.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf_notes.h"
#include "core/pattern/dxf_read.h"

namespace toile {

struct DxfVertex {
  Vec2 at;
  double bulge = 0;  ///< tan of a quarter of the angle of the arc to the next vertex; 0 is a straight line
};

/// A line of the drawing. Which fields count is said beside `Kind`.
struct DxfCurve {
  enum class Kind {
    polyline,  ///< vertices, closed
    arc,       ///< vertices[0] the centre, radius, start and end angle (degrees); closed: a circle
    spline,    ///< vertices the control points, degree, knots, weights (empty: all 1), closed
  };
  Kind kind = Kind::polyline;
  std::string layer;
  int line = 0;
  bool closed = false;
  bool mirrored = false;  ///< drawn on the plane's back: x counts the other way
  std::vector<DxfVertex> vertices;
  double radius = 0, start = 0, end = 0;
  int degree = 0;
  std::vector<double> knots, weights;
};

struct DxfText {
  std::string text;
  Vec2 at;
  int line = 0;
};

struct DxfInsert {
  std::string block;
  Vec2 at, scale{1, 1};
  double rotation = 0;  ///< degrees
  bool mirrored = false;
  int line = 0;
};

struct DxfBlock {
  std::string name;
  Vec2 base;
  std::vector<DxfCurve> curves;
  std::vector<DxfText> texts;
};

struct DxfFile {
  double mm_per_unit = 1;
  DxfBlock entities;
  std::vector<DxfInsert> inserts;
  std::vector<DxfBlock> blocks;
  DxfNotes notes;
};

/// Reads the whole text. Errors as read_dxf.
Result<DxfFile> parse_dxf(std::string_view text, const DxfSettings& settings);

}  // namespace toile
