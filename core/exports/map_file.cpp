#include "core/exports/map_file.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/rounded.h"
#include "core/exports/map_fields.h"
#include "core/json/fields/reader.h"
#include "core/json/fields/schema.h"
#include "core/json/fields/writer.h"

namespace toile::exports {
namespace {

/// As many as a million vertices have.
constexpr json::JsonLimits kLimits{.bytes = std::size_t{64} << 20};
constexpr int kDecimals = 3;  // floats have more digits than were measured

}  // namespace

std::string write_maps(const sewing::GarmentMesh& garment, const std::vector<std::string>& panel_names,
                       std::span<const analysis::ClothMap> maps) {
  MapFile file;
  for (std::size_t p = 0; p + 1 < garment.first_vertex.size(); ++p)
    file.pieces.push_back(
        {panel_names[p], garment.first_vertex[p], garment.first_vertex[p + 1] - garment.first_vertex[p]});
  for (const analysis::ClothMap& map : maps) {
    const analysis::MapTrait& trait = analysis::trait_of(map.kind);
    MapValues out{std::string(trait.word), std::string(trait.title), std::string(trait.unit), {}};
    out.values.reserve(map.values.size());
    for (const float value : map.values) out.values.push_back(rounded(static_cast<double>(value), kDecimals));
    file.maps.push_back(std::move(out));
  }
  return json::write_json_line(fields::json_of(file)) + "\n";
}

Result<std::vector<analysis::ClothMap>> parse_maps(std::string_view text) {
  const auto damaged = [](const Error& error) {
    return Error{"map.damaged", error.message, error.where, ErrorKind::kInput};
  };
  const Result<json::JsonValue> tree = json::parse_json(text, kLimits);
  if (!tree) return damaged(tree.error());
  MapFile file;
  std::optional<Error> error;
  fields::read(fields::FieldPlace{*tree, "", error}, file, fields::kAnything);
  if (error) return damaged(*error);
  std::vector<analysis::ClothMap> maps;
  for (std::size_t m = 0; m < file.maps.size(); ++m) {
    const std::string where = json::pointer_to("/maps", m);
    const auto kind = analysis::map_kind_from(file.maps[m].map);
    if (!kind) return damaged({"", kind.error().message, json::pointer_to(where, "map")});
    if (file.maps[m].values.size() != file.maps.front().values.size())
      return damaged({"", "maps of one cloth have as many values", json::pointer_to(where, "values")});
    analysis::ClothMap map{*kind, {}};
    map.values.reserve(file.maps[m].values.size());
    for (const double value : file.maps[m].values) map.values.push_back(static_cast<float>(value));
    maps.push_back(std::move(map));
  }
  return maps;
}

json::JsonValue map_schema() {
  fields::Definitions definitions;
  const json::JsonValue schema = fields::schema_of(MapFile{}, fields::kAnything, definitions);
  return fields::schema_file("Toile maps", "", schema, definitions);
}

}  // namespace toile::exports
