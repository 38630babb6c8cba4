#pragma once
// The middle layer of DXF reading: sections, blocks and entities as the file holds them, in its own units.

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf/report.h"
#include "core/pattern/dxf/settings.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {

struct DxfVertex {
  Vec2 at;
  double bulge = 0;  ///< tan of a quarter of the angle of the arc to the next vertex; 0 is a straight line
};

/// A line of the drawing. Which fields count is said beside `Kind`.
struct DxfCurve {
  enum class Kind {
    kPolyline,  ///< vertices, closed
    kArc,       ///< vertices[0] the centre, radius, start and end angle (degrees); closed: a circle
    kEllipse,   ///< vertices[0] the centre, [1] the major axis, radius the axes' ratio, start and end
                ///< (radians)
    kSpline,    ///< vertices the control points, degree, knots, weights (empty: all 1)
    kThrough,   ///< vertices lie on a smooth curve; closed
  };
  Kind kind = Kind::kPolyline;
  std::string layer;
  int line = 0;
  std::size_t entity = 0;  ///< its number in the log
  bool closed = false;
  bool is_run = false;    ///< a POLYLINE or LWPOLYLINE: several strokes that belong together
  bool mirrored = false;  ///< drawn on the plane's back: x counts the other way
  std::vector<DxfVertex> vertices;
  double radius = 0, start = 0, end = 0;
  int degree = 0;
  std::vector<double> knots, weights;

  /// Whether it runs straight from vertex to vertex.
  bool is_straight() const;
};

struct DxfText {
  std::string text, layer;
  Vec2 at;
  double height = 0;
  int line = 0;
  std::size_t entity = 0;
};

/// A POINT. On AAMA layer 4 a notch: depth in group 30, angle in 50.
struct DxfMark {
  std::string layer;
  Vec2 at;
  double depth = 0;             ///< drawing units
  std::optional<double> angle;  ///< degrees
  int line = 0;
  std::size_t entity = 0;
};

struct DxfInsert {
  std::string block, layer;
  Vec2 at, scale{1, 1};
  double rotation = 0;  ///< degrees
  bool mirrored = false;
  int line = 0;
  std::size_t entity = 0;
};

struct DxfBlock {
  std::string name;
  Vec2 base;
  int line = 0;
  std::vector<DxfCurve> curves = {};
  std::vector<DxfText> texts = {};
  std::vector<DxfMark> marks = {};
  std::vector<DxfInsert> inserts = {};

  bool is_empty() const { return curves.empty() && texts.empty() && marks.empty() && inserts.empty(); }
};

/// A number of the header with its line.
struct DxfVariable {
  double value = 0;
  int line = 0;
};

struct DxfFile {
  std::string version;  ///< $ACADVER, such as AC1015; empty when it is not told
  std::optional<DxfVariable> insunits, measurement;
  DxfBlock entities;
  std::vector<DxfBlock> blocks;
  DxfLog log;
  std::optional<Error> fault;  ///< the first entity that could not be read
};

/// Reads the whole text. An entity that cannot be read is left out, told of in the log and in `fault`.
/// Errors: dxf.empty, dxf.not_dxf, dxf.truncated, dxf.too_large, dxf.bad_group_code.
Result<DxfFile> parse_dxf(std::istream& in, const DxfSettings& settings);

}  // namespace toile::dxf
