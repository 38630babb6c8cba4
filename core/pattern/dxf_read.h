#pragma once
// Pattern pieces from DXF files, as pattern CAD (AAMA/ASTM), drafting programs and converters write them.

#include <cstddef>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/outline.h"
#include "core/pattern/pattern.h"

namespace toile {

struct DxfSettings {
  /// Millimetres per drawing unit. Unset: what $INSUNITS says, else 1.
  std::optional<double> mm_per_unit;
  double chain_tolerance_mm = 0.1;  ///< ends of lines this close are joined
  double arc_tolerance_mm =
      0.02;  ///< arcs become chords that stay this close (and at most 5 mm or 7.5° each)

  // Limits against files that would eat the machine; beyond them reading stops with dxf.too_large.
  std::size_t max_bytes = std::size_t{64} << 20;
  std::size_t max_entities = 200'000;
  std::size_t max_vertices = 200'000;  ///< in the file, and again once arcs are drawn out
  std::size_t max_loops = 2'000;
  double max_coordinate_mm = 1e6;  ///< a kilometre
};

/// One closed outline of the drawing, in millimetres and in the drawing's coordinates.
struct DxfPiece {
  std::string name;                      ///< unique within the drawing
  std::vector<Vec2> outline;             ///< closed, first point not repeated, in the file's order
  std::vector<std::vector<Vec2>> holes;  ///< likewise
  std::vector<Vec2> breaks;              ///< where entities of the file meet, when several make the outline
  std::optional<Vec2> grain;             ///< unit vector of the grain line (AAMA layer 7), y up
  std::string layer;
  int line = 0;  ///< of the outline's first entity in the file, from 1
};

struct DxfDrawing {
  std::vector<DxfPiece> pieces;    ///< in the file's order
  double mm_per_unit = 1;          ///< as used
  std::vector<std::string> notes;  ///< "line 12: …": what was passed over, and why
};

/// Reads the pieces of an ASCII DXF file, R10 to today's.
///
/// Outlines are POLYLINE, LWPOLYLINE (both with bulges), LINE, ARC, CIRCLE and SPLINE, in ENTITIES or in the
/// BLOCKs that ENTITIES insert (without inserts and entities: each block once). Open ones of one layer are
/// chained end to end, in any order and direction. A loop within another of its layer is a hole. Where lines
/// stand on AAMA layers, 14 (sew) is taken before 1 (cut), loops on 11 are holes, and the other layers are
/// passed over. Names: "Piece Name: …" in the block, else a text in the piece or up to 20 mm beside it, else
/// the block's name, else piece1, piece2, …
///
/// Errors, with the line in `where`: dxf.empty, dxf.binary, dxf.not_dxf, dxf.truncated, dxf.bad_number,
/// dxf.coordinate_range, dxf.missing_coordinate, dxf.open_outline (with both ends of the gap), dxf.zero_area,
/// dxf.self_crossing (with the place), dxf.no_outline, dxf.unknown_block, dxf.too_large, dxf.bad_group_code.
Result<DxfDrawing> read_dxf(std::string_view text, const DxfSettings& settings = {});
/// Reads the stream to its end, but no more than settings.max_bytes.
Result<DxfDrawing> read_dxf(std::istream& in, const DxfSettings& settings = {});

/// The piece as a panel of its own name, in the drawing's coordinates: outline counter-clockwise with edges
/// e0, e1, …, holes clockwise with edges h0e0, … Corners as loop_from_polyline says; to have an edge end
/// wherever two entities of the file meet, pass piece.breaks. The fabric is left empty. Errors: those of
/// loop_from_polyline, with the piece in `where`.
Result<Panel> panel_from_piece(const DxfPiece& piece, std::span<const Vec2> forced_corners = {},
                               const OutlineSettings& settings = {});

}  // namespace toile
