#include "server/documents/imports.h"

#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/names.h"
#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/validate.h"
#include "core/project/create/create.h"
#include "core/project/create/import_report.h"
#include "server/documents/assets.h"

namespace toile {
namespace {

Result<DxfSettings> settings_of(const ImportWishes& wishes) {
  DxfSettings settings;
  settings.max_bytes = kMostDxfBytes;
  if (!wishes.size.empty()) settings.size = wishes.size;
  if (wishes.unit.empty()) return settings;
  if (wishes.unit == "mm") settings.mm_per_unit = 1;
  if (wishes.unit == "cm") settings.mm_per_unit = 10;
  if (wishes.unit == "inch") settings.mm_per_unit = 25.4;
  if (settings.mm_per_unit) return settings;
  return Error{"documents.unit", "unit is \"mm\", \"cm\" or \"inch\"", "/unit"};
}

/// The piece as a project document takes it from this file.
JsonValue source_of(const DxfPiece& piece, const DxfDrawing& drawing, const std::string& file) {
  std::vector<JsonMember> from{{"dxf", file}, {"piece", piece.name}};
  const std::string& unit = drawing.unit.name;
  if (unit == "mm" || unit == "cm" || unit == "inch") from.push_back({"units", unit});
  if (!drawing.size.empty()) from.push_back({"size", drawing.size});
  return from;
}

JsonValue points_json(const std::vector<Vec2>& points) {
  const auto fine = [](double v) { return std::round(v * 100) / 100 + 0.0; };
  std::vector<JsonValue> out;
  for (const Vec2 p : points) out.push_back(std::vector<JsonValue>{fine(p.x), fine(p.y)});
  return out;
}

/// What a picture of the piece needs: outline, holes and grain. Empty when it cannot be cut.
void add_picture(const Result<Panel>& panel, std::vector<JsonMember>& piece) {
  constexpr double kFlat = 0.2;  // mm
  std::vector<JsonValue> holes;
  if (panel) {
    for (const Loop& hole : panel->holes) holes.push_back(points_json(flatten(hole, kFlat)));
  }
  piece.push_back({"points", points_json(panel ? flatten(panel->outline, kFlat) : std::vector<Vec2>{})});
  piece.push_back({"hole_points", std::move(holes)});
}

/// Edges as lines, so that a proposal of a seam can be shown where it is.
void add_edge_points(const Panel& panel, std::vector<JsonMember>& piece) {
  constexpr double kFlat = 0.5;  // mm
  const std::vector<const PanelEdge*> edges = edges_of(panel);
  for (JsonMember& member : piece) {
    if (member.key != "edge_list") continue;
    auto& list = std::get<std::vector<JsonValue>>(member.value.data);
    for (std::size_t i = 0; i < list.size() && i < edges.size(); ++i) {
      auto& edge = std::get<std::vector<JsonMember>>(list[i].data);
      edge.push_back({"points", points_json(flatten(*edges[i], kFlat))});
    }
  }
}

/// What goes into the report's pieces beside their figures.
struct Pictured {
  Result<Panel> panel;
  std::optional<JsonValue> from;  ///< none: the document has the outline itself
};

std::vector<JsonValue> with_pictures(const JsonValue& pieces, const std::vector<Pictured>& pictures) {
  std::vector<JsonValue> out;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    std::vector<JsonMember> piece = *(*pieces.array())[i].object();
    if (pictures[i].panel) add_edge_points(*pictures[i].panel, piece);
    if (pictures[i].from) piece.push_back({"from", *pictures[i].from});
    add_picture(pictures[i].panel, piece);
    out.emplace_back(std::move(piece));
  }
  return out;
}

/// The report with what a page needs besides, and a document to begin with, without seams.
JsonValue report_of(const JsonValue& report, const std::vector<Pictured>& pictures, const AssetRow& asset,
                    const std::optional<NewProject>& made) {
  std::vector<JsonMember> members{{"asset", asset.id}, {"file", asset.name}};
  for (JsonMember member : *report.object()) {
    if (member.key == "pieces") member.value = with_pictures(member.value, pictures);
    members.push_back(std::move(member));
  }
  JsonValue document;
  if (made) {
    Project project = made->project;
    project.seams.clear();
    project.bodies.front().file.clear();
    project.bodies.front().mannequin = ProjectMannequin{};
    if (const Result<JsonValue> tree = parse_json(write_project_line(project)); tree) document = *tree;
  }
  members.push_back({"document", std::move(document)});
  return members;
}

NewProjectSettings project_of(const AssetRow& asset) {
  NewProjectSettings settings;
  settings.name = asset.name.substr(0, asset.name.rfind('.'));
  settings.pattern_file = asset.name;
  return settings;
}

/// Pieces that cannot be cut are left out: the report tells of each.
DxfDrawing without_faults(DxfDrawing drawing) {
  std::erase_if(drawing.pieces, [](const DxfPiece& piece) {
    const Result<Panel> panel = panel_from_piece(piece);
    return !panel || !validate(*panel);
  });
  return drawing;
}

Result<JsonValue> import_dxf(const std::string& bytes, const ImportWishes& wishes, const AssetRow& asset) {
  const DxfSettings settings = TRY(settings_of(wishes));
  const Result<DxfDrawing> drawing = read_dxf(bytes, settings);
  if (!drawing) return error_at(clipped(asset.name), drawing.error());
  std::optional<NewProject> made;
  const DxfDrawing good = without_faults(*drawing);
  if (!good.pieces.empty()) {
    if (Result<NewProject> project = new_project(good, project_of(asset)); project) made = *project;
  }
  std::vector<Pictured> pictures;
  for (const DxfPiece& piece : drawing->pieces)
    pictures.push_back({panel_from_piece(piece), source_of(piece, *drawing, asset.name)});
  const std::vector<JsonValue> seams = made ? seams_json(*made) : std::vector<JsonValue>{};
  return report_of(import_json(*drawing, seams), pictures, asset, made);
}

/// A specification says its unit and has one size.
Result<JsonValue> import_specification(const std::string& bytes, const ImportWishes& wishes,
                                       const AssetRow& asset) {
  if (!wishes.unit.empty()) return Error{"documents.unit", "a specification says its unit itself", "/unit"};
  if (!wishes.size.empty()) return Error{"documents.size", "a specification has one size", "/size"};
  Result<NewProject> made = new_project(bytes, project_of(asset));
  if (!made) return error_at(clipped(asset.name), made.error());
  std::vector<Pictured> pictures;
  for (const Panel& panel : made->pattern.panels) pictures.push_back({panel, std::nullopt});
  const JsonValue report = specification_json(made->pattern, seams_json(*made), made->notes);
  return report_of(report, pictures, asset, std::move(*made));
}

}  // namespace

Result<std::string> import_pattern(Documents& documents, const RequestContext& context,
                                   const std::string& asset, const ImportWishes& wishes) {
  const AssetRow row = TRY(documents.store().asset(context, asset));
  if (row.kind != "dxf" && row.kind != "specification") {
    return Error{"documents.wrong_kind", in_quotes(row.name) + " is no pattern file", "/asset"};
  }
  const std::string bytes = TRY(documents.store().asset_bytes(context, asset));
  const Result<JsonValue> report =
      row.kind == "dxf" ? import_dxf(bytes, wishes, row) : import_specification(bytes, wishes, row);
  if (!report) return report.error();
  return write_json_line(*report) + "\n";
}

}  // namespace toile
