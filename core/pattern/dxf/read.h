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
#include "core/pattern/dxf/layers.h"
#include "core/pattern/dxf/report.h"
#include "core/pattern/dxf/settings.h"
#include "core/pattern/outline.h"
#include "core/pattern/pattern.h"

namespace toile::dxf {

/// One piece of the drawing, in millimetres and in the drawing's coordinates.
struct DxfPiece {
  std::string name;                      ///< unique within the drawing
  std::vector<Vec2> outline;             ///< closed, first point not repeated, in the file's order
  std::vector<std::vector<Vec2>> holes;  ///< likewise
  std::vector<Vec2> breaks;              ///< where entities of the file meet, when several make the outline
  std::optional<Vec2> grain;             ///< unit vector of the grain line (AAMA layer 7), y up
  std::string layer;
  int line = 0;  ///< of the outline's first entity in the file, from 1

  bool breaks_are_edges = false;  ///< the outline stands as runs: each is an edge of its own
  std::string size;               ///< of a graded file, empty otherwise
  int quantity = 1;               ///< how often it is cut, those turned over included
  int mirrored = 0;               ///< how many of them are turned over: as told, else every second one
  bool counted = false;           ///< the file says how often it is cut
  std::string category, material, annotation;
  bool unfolded = false;    ///< the file holds a half, to be cut on the fold
  bool on_sew_line = true;  ///< false: on the cut line, with its seam allowance if it has one
  std::vector<pattern::Notch> notches;
  /// Where curves of the outline end: AAMA layer 2, and where an arc or a spline meets another entity at an
  /// angle.
  std::vector<Vec2> turn_points;
  std::vector<Vec2> drills;                  ///< AAMA layer 13
  std::vector<std::vector<Vec2>> internals;  ///< lines within the piece; closed ones repeat their first point
};

/// Why a unit that was asked for is hardly meant.
struct DxfUnitDoubt {
  std::string own;         ///< the unit that the file would be taken to be in
  double largest_mm = 0;   ///< the largest piece, in the unit that was asked for
  double largest_own = 0;  ///< likewise in the file's own, millimetres
};

/// The unit of the drawing, and why.
struct DxfUnit {
  std::string name = "mm";  ///< mm, cm, m, inch, foot; "other" when the settings give another one
  double mm = 1;            ///< millimetres
  double confidence = 1;    ///< 0 to 1; 1 when the settings gave it
  std::vector<std::string> evidence;
  std::optional<DxfUnitDoubt> doubt;
};

struct DxfDrawing {
  std::vector<DxfPiece> pieces;  ///< in the file's order
  double mm_per_unit = 1;        ///< as used
  DxfUnit unit;
  std::string style;               ///< "Style Name: …"
  std::vector<std::string> sizes;  ///< of a graded file, in its order
  std::string size;                ///< the one that was taken
  std::string sample_size;
  std::vector<DxfLayerUse> layers;
  DxfReport report;
  std::vector<std::string> notes;  ///< the report's warnings, "line 12: …"
};

/// Reads the pieces of a DXF file, text or binary, R10 to today's, in one pass and bounded memory.
///
/// Outlines are POLYLINE, LWPOLYLINE (both with bulges), LINE, ARC, CIRCLE, ELLIPSE and SPLINE, in ENTITIES
/// or in the BLOCKs that ENTITIES insert, nested ones too (without inserts and entities: each block once).
/// Open ones of one layer are chained end to end, in any order and direction. A loop that follows a cut line
/// at the widths of seam allowances is its sew line (allowance.h), whatever its layer; another one within it
/// is a hole or, on a layer for such, a line. Where lines stand on AAMA layers, 14 (sew) is asked before
/// others and 1 is the cut line; the others have the meaning of their numbers (layers.h), all unless
/// settings.layers says otherwise; a half with a mirror line (6) along its outline is unfolded, and so
/// is one that a text says to be cut on the fold, about its likeliest edge, with a warning. Of a graded
/// file (a BLOCK for each piece and size) one size is taken. Names: "Piece Name: …", else a text in the piece
/// or up to 20 mm beside it, else the block's name, else piece1, piece2, …
///
/// What cannot be read is left out and told of in the report, as long as any piece is left. Errors, with the
/// line in `where`: dxf.empty, dxf.not_dxf, dxf.truncated, dxf.too_large, dxf.bad_group_code,
/// dxf.unknown_size, dxf.unknown_layer; and, when no piece could be read, the first reason: dxf.bad_number,
/// dxf.coordinate_range, dxf.missing_coordinate, dxf.open_outline (with both ends of the gap), dxf.zero_area,
/// dxf.self_crossing (with the place), dxf.unknown_block, dxf.no_outline.
Result<DxfDrawing> read_dxf(std::string_view text, const DxfSettings& settings = {});
/// Reads the stream to its end, but no more than settings.max_bytes.
Result<DxfDrawing> read_dxf(std::istream& in, const DxfSettings& settings = {});

/// The layers of a file, also of one whose outlines cannot be found: then they may tell why. Errors: those of
/// read_dxf but for what is wrong with outlines.
Result<std::vector<DxfLayerUse>> read_dxf_layers(std::string_view text, const DxfSettings& settings = {});

/// Whether the error of read_dxf may only come of layers that are not the usual ones: it is one of outlines,
/// and lines stand on several layers. Who says what these are may be helped.
bool layers_may_help(std::string_view text, const Error& error);

/// The piece as a panel of its own name, in the drawing's coordinates: outline counter-clockwise with edges
/// e0, e1, …, holes clockwise with edges h0e0, … Without forced corners edges end where the outline turns
/// sharply and where the file's own runs meet; with them, at exactly those places. Curves end at notches and
/// turn points; notches move onto the outline. Lines within it come as lines i0, i1, … that are only drawn.
/// The fabric is left empty. Errors: those of
/// loop_from_polyline, with the piece in `where`.
Result<pattern::Panel> panel_from_piece(const DxfPiece& piece, std::span<const Vec2> forced_corners = {},
                                        const pattern::OutlineSettings& settings = {});

}  // namespace toile::dxf
