#pragma once
// What reading a pattern file gave, as JSON: for people who look at an import, and for programs.

#include <string>
#include <vector>

#include "core/json/tree.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/pattern.h"

namespace toile::create {

/// {unit {name, mm_per_unit, confidence, evidence}, style, sizes, size, sample_size, layers, pieces, seams,
/// report}.
///
/// Each piece: {name, size, area_mm2 (without its holes), width_mm, height_mm, edges, notches, holes (their
/// numbers), grain_deg (0 to 180 from the x axis; null when the file has none), quantity, mirrored (how many
/// of them are turned over), unfolded, outline ("sew" or "cut"), layer, line, edge_list [{id, length_mm,
/// start,
/// end, curves}], notch_list [{at, depth_mm, angle_deg}], and category, material, annotation where they are
/// told; fault {code, message, where} when it cannot be cut. report: {counts, entities [{type, layer, block,
/// fate, reason, piece, count, lines}], warnings [{line, piece, at, text, count}]}. `seams` is what the
/// caller knows.
json::JsonValue import_json(const dxf::DxfDrawing& drawing, const std::vector<json::JsonValue>& seams = {});

/// [{name, read_as (role_word of core/pattern/dxf/layers.h, or "shape"), given, count, kinds [{type,
/// count}]}].
json::JsonValue layers_json(const std::vector<dxf::DxfLayerUse>& layers);

/// The same for a GarmentCode specification, which has no layers: pieces {name, area_mm2, width_mm,
/// height_mm, edges, grain_deg, quantity, mirrored, unfolded, edge_list}, the unit without mm_per_unit, and a
/// report with counts {panels, edges, stitches} and the notes as warnings.
json::JsonValue specification_json(const pattern::Pattern& pattern, const std::vector<json::JsonValue>& seams,
                                   const std::vector<std::string>& notes);

/// Width, height and area of a piece as import_json tells them.
struct PieceMeasures {
  double width_mm = 0, height_mm = 0, area_mm2 = 0;
};
PieceMeasures measures_of(const pattern::Panel& panel);

/// Angle of the grain line from the x axis, 0 to 180 degrees.
double grain_degrees(Vec2 grain);

}  // namespace toile::create
