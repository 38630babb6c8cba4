#pragma once
// maps.json: what the cloth is measured for at each of its vertices. proto/schema/maps.schema.json has each
// key.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/cloth_map.h"
#include "core/base/result.h"
#include "core/json/tree.h"
#include "core/sewing/garment_mesh.h"

namespace toile::exports {

inline constexpr const char* kMapFile = "maps.json";

/// One line of JSON. `panel_names`: one a panel; each map has one value a vertex.
std::string write_maps(const sewing::GarmentMesh& garment, const std::vector<std::string>& panel_names,
                       std::span<const analysis::ClothMap> maps);

/// Errors: map.damaged (no JSON, not of this form, or maps of different lengths), with the place in `where`.
Result<std::vector<analysis::ClothMap>> parse_maps(std::string_view text);

json::JsonValue map_schema();

}  // namespace toile::exports
