#include "server/documents/imports.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/dxf_read.h"
#include "proto/cpp/import_report.h"
#include "proto/cpp/json_codec.h"
#include "proto/cpp/names.h"
#include "proto/cpp/project_new.h"
#include "proto/cpp/project_pieces.h"
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

JsonValue points_of(const DxfPiece& piece) {
  constexpr double kFlat = 0.2;  // mm
  std::vector<JsonValue> points;
  const Result<Panel> panel = panel_from_piece(piece);
  if (!panel) return points;
  for (const Vec2 p : flatten(panel->outline, kFlat)) points.push_back(std::vector<JsonValue>{p.x, p.y});
  return points;
}

/// None while a piece cannot be cut: the report tells of it.
std::vector<JsonValue> proposed_seams(const DxfDrawing& drawing) {
  const Result<NewProject> made = new_project(drawing, {});
  return made ? seams_json(*made) : std::vector<JsonValue>{};
}

/// The report with what a page needs besides: each piece's place in a document, and its form.
JsonValue report_of(const DxfDrawing& drawing, const AssetRow& asset) {
  const JsonValue report = import_json(drawing, proposed_seams(drawing));
  std::vector<JsonMember> members{{"asset", asset.id}};
  for (JsonMember member : *report.object()) {
    if (member.key == "pieces") {
      std::vector<JsonValue> pieces;
      for (std::size_t i = 0; i < drawing.pieces.size(); ++i) {
        std::vector<JsonMember> piece = *(*member.value.array())[i].object();
        piece.push_back({"from", source_of(drawing.pieces[i], drawing, asset.name)});
        piece.push_back({"points", points_of(drawing.pieces[i])});
        pieces.emplace_back(std::move(piece));
      }
      member.value = std::move(pieces);
    }
    members.push_back(std::move(member));
  }
  return members;
}

}  // namespace

Result<std::string> import_pattern(Store& store, const OwnerId& owner, const std::string& asset,
                                   const ImportWishes& wishes) {
  const Result<DxfSettings> settings = settings_of(wishes);
  if (!settings) return settings.error();
  const Result<AssetRow> row = store.asset(owner, asset);
  if (!row) return row.error();
  if (row->kind != "dxf") {
    return Error{"documents.wrong_kind", in_quotes(row->name) + " is no pattern file", "/asset"};
  }
  const Result<std::string> bytes = store.asset_bytes(owner, asset);
  if (!bytes) return bytes.error();
  const Result<DxfDrawing> drawing = read_dxf(*bytes, *settings);
  if (!drawing) return error_at(clipped(row->name), drawing.error());
  return write_json_line(report_of(*drawing, *row)) + "\n";
}

}  // namespace toile
