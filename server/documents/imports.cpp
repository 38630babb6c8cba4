#include "server/documents/imports.h"

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/names.h"
#include "core/base/processors.h"
#include "core/base/rounded.h"
#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/validate.h"
#include "core/project/create/create.h"
#include "core/project/create/import_report.h"
#include "server/documents/assets.h"

namespace toile::documents {
namespace {

Result<dxf::DxfSettings> settings_of(const ImportWishes& wishes) {
  dxf::DxfSettings settings;
  settings.max_bytes = kMostDxfBytes;
  if (!wishes.size.empty()) settings.size = wishes.size;
  for (const auto& [layer, word] : wishes.layers) {
    const Result<dxf::DxfRole> role = dxf::role_named(word);
    if (!role) return json::error_at(json::pointer_to("/layers", layer), role.error());
    settings.layers[layer] = *role;
  }
  if (wishes.unit.empty()) return settings;
  if (wishes.unit == "mm") settings.mm_per_unit = 1;
  if (wishes.unit == "cm") settings.mm_per_unit = 10;
  if (wishes.unit == "inch") settings.mm_per_unit = 25.4;
  if (settings.mm_per_unit) return settings;
  return Error{"documents.unit", "unit is \"mm\", \"cm\" or \"inch\"", "/unit"};
}

/// The piece as a project document takes it from this file.
json::JsonValue source_of(const dxf::DxfPiece& piece, const dxf::DxfDrawing& drawing,
                          const std::string& file) {
  std::vector<json::JsonMember> from{{"dxf", file}, {"piece", piece.name}};
  const std::string& unit = drawing.unit.name;
  if (unit == "mm" || unit == "cm" || unit == "inch") from.push_back({"units", unit});
  if (!drawing.size.empty()) from.push_back({"size", drawing.size});
  std::vector<json::JsonMember> layers;
  for (const auto& [layer, word] : create::given_layers(drawing)) layers.push_back({layer, word});
  if (!layers.empty()) from.push_back({"layers", std::move(layers)});
  return from;
}

json::JsonValue drawn_json(const std::vector<Vec2>& points) {
  const auto fine = [](double v) { return rounded(v, 2); };
  std::vector<json::JsonValue> out;
  out.reserve(points.size());
  for (const Vec2 p : points) out.push_back(std::vector<json::JsonValue>{fine(p.x), fine(p.y)});
  return out;
}

/// What a picture of the piece needs: outline, holes and grain. Empty when it cannot be cut.
void add_picture(const Result<pattern::Panel>& panel, std::vector<json::JsonMember>& piece) {
  constexpr double kFlat = 0.2;  // mm
  std::vector<json::JsonValue> holes;
  if (panel) {
    for (const pattern::Loop& hole : panel->holes) holes.push_back(drawn_json(pattern::flatten(hole, kFlat)));
  }
  piece.push_back(
      {"points", drawn_json(panel ? pattern::flatten(panel->outline, kFlat) : std::vector<Vec2>{})});
  piece.push_back({"hole_points", std::move(holes)});
}

/// Edges as lines, so that a proposal of a seam can be shown where it is.
void add_edge_points(const pattern::Panel& panel, std::vector<json::JsonMember>& piece) {
  constexpr double kFlat = 0.5;  // mm
  const std::vector<const pattern::PanelEdge*> edges = pattern::edges_of(panel);
  for (json::JsonMember& member : piece) {
    if (member.key != "edge_list") continue;
    auto& list = std::get<std::vector<json::JsonValue>>(member.value.data);
    for (std::size_t i = 0; i < list.size() && i < edges.size(); ++i) {
      auto& edge = std::get<std::vector<json::JsonMember>>(list[i].data);
      edge.push_back({"points", drawn_json(pattern::flatten(*edges[i], kFlat))});
    }
  }
}

/// What goes into the report's pieces beside their figures.
struct Pictured {
  Result<pattern::Panel> panel;
  std::optional<json::JsonValue> from;  ///< none: the document has the outline itself
};

std::vector<json::JsonValue> with_pictures(const json::JsonValue& pieces,
                                           const std::vector<Pictured>& pictures) {
  std::vector<json::JsonValue> out;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    std::vector<json::JsonMember> piece = *(*pieces.array())[i].object();
    if (pictures[i].panel) add_edge_points(*pictures[i].panel, piece);
    if (pictures[i].from) piece.push_back({"from", *pictures[i].from});
    add_picture(pictures[i].panel, piece);
    out.emplace_back(std::move(piece));
  }
  return out;
}

/// The report with what a page needs besides, and a document to begin with, without seams.
json::JsonValue report_of(const json::JsonValue& report, const std::vector<Pictured>& pictures,
                          const store::AssetRow& asset, const std::optional<create::NewProject>& made) {
  std::vector<json::JsonMember> members{{"asset", asset.id}, {"file", asset.name}};
  for (json::JsonMember member : *report.object()) {
    if (member.key == "pieces") member.value = with_pictures(member.value, pictures);
    members.push_back(std::move(member));
  }
  json::JsonValue document;
  if (made) {
    project::Project project = made->project;
    project.seams.clear();
    project.bodies.front().file.clear();
    project.bodies.front().mannequin = project::ProjectMannequin{};
    if (const Result<json::JsonValue> tree = json::parse_json(project::write_project_line(project)); tree)
      document = *tree;
  }
  members.push_back({"document", std::move(document)});
  return members;
}

create::NewProjectSettings project_of(const store::AssetRow& asset) {
  create::NewProjectSettings settings;
  settings.name = asset.name.substr(0, asset.name.rfind('.'));
  settings.pattern_file = asset.name;
  return settings;
}

Result<json::JsonValue> import_dxf(const std::string& bytes, const ImportWishes& wishes,
                                   const store::AssetRow& asset) {
  const dxf::DxfSettings settings = TRY(settings_of(wishes));
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(bytes, settings);
  if (!drawing) {
    const bool is_of_layers = drawing.error().code == "dxf.unknown_layer";
    return json::error_at(is_of_layers ? "/layers" : clipped(asset.name), drawing.error());
  }
  std::optional<create::NewProject> made;
  if (Result<create::NewProject> project =
          create::new_project(*drawing, project_of(asset), on_all_processors());
      project)
    made = std::move(*project);  // else the report tells of each piece that cannot be cut
  std::vector<Pictured> pictures;
  for (const dxf::DxfPiece& piece : drawing->pieces)
    pictures.push_back({dxf::panel_from_piece(piece), source_of(piece, *drawing, asset.name)});
  const std::vector<json::JsonValue> seams =
      made ? create::seams_json(*made) : std::vector<json::JsonValue>{};
  return report_of(create::import_json(*drawing, seams), pictures, asset, made);
}

/// A specification says its unit and has one size.
Result<json::JsonValue> import_specification(const std::string& bytes, const ImportWishes& wishes,
                                             const store::AssetRow& asset) {
  if (!wishes.unit.empty()) return Error{"documents.unit", "a specification says its unit itself", "/unit"};
  if (!wishes.size.empty()) return Error{"documents.size", "a specification has one size", "/size"};
  if (!wishes.layers.empty()) return Error{"documents.layers", "a specification has no layers", "/layers"};
  Result<create::NewProject> made = create::new_project(bytes, project_of(asset), on_all_processors());
  if (!made) return json::error_at(clipped(asset.name), made.error());
  std::vector<Pictured> pictures;
  for (const pattern::Panel& panel : made->pattern.panels) pictures.push_back({panel, std::nullopt});
  const json::JsonValue report =
      create::specification_json(made->pattern, create::seams_json(*made), made->notes);
  return report_of(report, pictures, asset, std::move(*made));
}

}  // namespace

Result<std::string> import_pattern(Documents& documents, const store::RequestContext& context,
                                   const std::string& asset, const ImportWishes& wishes) {
  const store::AssetRow row = TRY(documents.store().asset(context, asset));
  if (row.kind != "dxf" && row.kind != "specification") {
    return Error{"documents.wrong_kind", in_quotes(row.name) + " is no pattern file", "/asset"};
  }
  const std::string bytes = TRY(documents.store().asset_bytes(context, asset));
  const json::JsonValue report =
      TRY(row.kind == "dxf" ? import_dxf(bytes, wishes, row) : import_specification(bytes, wishes, row));
  return json::write_json_line(report) + "\n";
}

Result<std::string> pattern_layers(Documents& documents, const store::RequestContext& context,
                                   const std::string& asset) {
  const store::AssetRow row = TRY(documents.store().asset(context, asset));
  if (row.kind != "dxf") return Error{"documents.wrong_kind", in_quotes(row.name) + " is no DXF file", ""};
  const std::string bytes = TRY(documents.store().asset_bytes(context, asset));
  dxf::DxfSettings settings;
  settings.max_bytes = kMostDxfBytes;
  const Result<std::vector<dxf::DxfLayerUse>> layers = dxf::read_dxf_layers(bytes, settings);
  if (!layers) return json::error_at(clipped(row.name), layers.error());
  return json::write_json_line(std::vector<json::JsonMember>{
             {"asset", row.id}, {"file", row.name}, {"layers", create::layers_json(*layers)}}) +
         "\n";
}

}  // namespace toile::documents
