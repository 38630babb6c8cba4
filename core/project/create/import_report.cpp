#include "core/project/create/import_report.h"

#include <cmath>
#include <string>

#include "core/base/aabb.h"
#include "core/base/rounded.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile::create {
namespace {

using Members = std::vector<json::JsonMember>;

json::JsonValue count_of(std::size_t n) { return static_cast<double>(n); }

/// Thousandths are enough to read.

json::JsonValue place(Vec2 p) { return std::vector<json::JsonValue>{rounded(p.x, 3), rounded(p.y, 3)}; }

json::JsonValue texts(const std::vector<std::string>& list) {
  std::vector<json::JsonValue> values;
  values.reserve(list.size());
  for (const std::string& text : list) values.emplace_back(text);
  return values;
}

json::JsonValue edges_json(const pattern::Panel& panel) {
  std::vector<json::JsonValue> edges;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel))
    edges.push_back(Members{{"id", edge->id},
                            {"length_mm", rounded(pattern::arc_length(*edge), 3)},
                            {"start", place(edge->curves.front().p0)},
                            {"end", place(edge->curves.back().p3)},
                            {"curves", count_of(edge->curves.size())}});
  return edges;
}

json::JsonValue notches_json(const std::vector<pattern::Notch>& notches) {
  std::vector<json::JsonValue> list;
  for (const pattern::Notch& n : notches) {
    const bool turned = !(n.inwards == Vec2{});
    const double angle = degrees_from_radians(std::atan2(n.inwards.y, n.inwards.x));
    list.push_back(Members{{"at", place(n.at)},
                           {"depth_mm", rounded(n.depth, 3)},
                           {"angle_deg", turned ? json::JsonValue(rounded(angle, 3)) : json::JsonValue()}});
  }
  return list;
}

json::JsonValue lines_json(const std::vector<pattern::InnerLine>& lines) {
  std::vector<json::JsonValue> list;
  for (const pattern::InnerLine& line : lines) {
    std::vector<json::JsonValue> points;
    for (const Vec2 p : line.points) points.push_back(place(p));
    list.push_back(Members{{"id", line.id}, {"points", std::move(points)}});
  }
  return list;
}

json::JsonValue fault_json(const Error& error) {
  return Members{{"code", error.code}, {"message", error.message}, {"where", error.where}};
}

json::JsonValue piece_json(const dxf::DxfPiece& piece) {
  const Result<pattern::Panel> panel = dxf::panel_from_piece(piece);
  Members members{{"name", piece.name}, {"size", piece.size}};
  if (panel) {
    const PieceMeasures m = measures_of(*panel);
    members.insert(members.end(), {{"area_mm2", rounded(m.area_mm2, 3)},
                                   {"width_mm", rounded(m.width_mm, 3)},
                                   {"height_mm", rounded(m.height_mm, 3)},
                                   {"edges", count_of(panel->outline.edges.size())},
                                   {"notches", count_of(panel->notches.size())},
                                   {"holes", count_of(panel->holes.size())},
                                   {"lines", count_of(panel->lines.size())}});
  }
  members.insert(members.end(),
                 {{"grain_deg", piece.grain ? json::JsonValue(rounded(grain_degrees(*piece.grain), 3))
                                            : json::JsonValue()},
                  {"quantity", double(piece.quantity)},
                  {"mirrored", double(piece.mirrored)},
                  {"unfolded", piece.unfolded},
                  {"outline", std::string(piece.on_sew_line ? "sew" : "cut")},
                  {"layer", piece.layer},
                  {"line", double(piece.line)}});
  const auto add_text = [&](const char* key, const std::string& text) {
    if (!text.empty()) members.push_back({key, text});
  };
  add_text("category", piece.category);
  add_text("material", piece.material);
  add_text("annotation", piece.annotation);
  if (panel) {
    members.push_back({"edge_list", edges_json(*panel)});
    members.push_back({"notch_list", notches_json(panel->notches)});
    members.push_back({"line_list", lines_json(panel->lines)});
  } else {
    members.push_back({"fault", fault_json(panel.error())});
  }
  return members;
}

std::string fate_name(dxf::DxfFate fate) {
  return fate == dxf::DxfFate::kKept ? "kept" : fate == dxf::DxfFate::kConverted ? "converted" : "dropped";
}

json::JsonValue entities_json(const dxf::DxfReport& report) {
  std::vector<json::JsonValue> groups;
  for (const dxf::DxfEntityGroup& g : report.groups) {
    std::vector<json::JsonValue> lines;
    for (const int line : g.lines) lines.emplace_back(double(line));
    groups.push_back(Members{{"type", g.type},
                             {"layer", g.layer},
                             {"block", g.block},
                             {"fate", fate_name(g.fate)},
                             {"reason", g.reason},
                             {"piece", g.piece},
                             {"count", count_of(g.lines.size())},
                             {"lines", std::move(lines)}});
  }
  return groups;
}

json::JsonValue report_json(const dxf::DxfReport& report) {
  std::vector<json::JsonValue> warnings;
  for (const dxf::DxfWarning& w : report.warnings)
    warnings.push_back(Members{{"line", double(w.line)},
                               {"piece", w.piece},
                               {"at", w.at ? place(*w.at) : json::JsonValue()},
                               {"text", w.text},
                               {"count", count_of(w.count)}});
  const Members counts{{"records", count_of(report.records)},     {"structure", count_of(report.structure)},
                       {"elsewhere", count_of(report.elsewhere)}, {"vertices", count_of(report.vertices)},
                       {"entities", count_of(report.entities)},   {"kept", count_of(report.kept)},
                       {"converted", count_of(report.converted)}, {"dropped", count_of(report.dropped)}};
  return Members{{"counts", counts}, {"entities", entities_json(report)}, {"warnings", std::move(warnings)}};
}

}  // namespace

PieceMeasures measures_of(const pattern::Panel& panel) {
  constexpr double kTolerance = 0.05;  // mm
  const std::vector<Vec2> outline = pattern::flatten(panel.outline, kTolerance);
  const Vec2 size = bounding_box(outline).size();
  double area = pattern::signed_area(panel.outline);
  for (const pattern::Loop& hole : panel.holes) area -= std::abs(pattern::signed_area(hole));
  return {size.x, size.y, area};
}

double grain_degrees(Vec2 grain) {
  const double angle = degrees_from_radians(std::atan2(grain.y, grain.x));
  return angle < 0 ? angle + 180 : angle >= 180 ? angle - 180 : angle;
}

json::JsonValue layers_json(const std::vector<dxf::DxfLayerUse>& layers) {
  std::vector<json::JsonValue> list;
  for (const dxf::DxfLayerUse& layer : layers) {
    std::vector<json::JsonValue> kinds;
    for (const auto& [type, count] : layer.kinds)
      kinds.push_back(Members{{"type", type}, {"count", count_of(count)}});
    list.push_back(Members{{"name", layer.name},
                           {"read_as", std::string(dxf::read_as(layer))},
                           {"given", layer.given},
                           {"count", count_of(layer.entities)},
                           {"kinds", std::move(kinds)}});
  }
  return list;
}

namespace {

json::JsonValue unit_json(const dxf::DxfUnit& unit) {
  Members members{{"name", unit.name},
                  {"mm_per_unit", unit.mm},
                  {"confidence", rounded(unit.confidence, 3)},
                  {"evidence", texts(unit.evidence)}};
  if (unit.doubt)
    members.push_back({"doubt", Members{{"own", unit.doubt->own},
                                        {"largest_mm", rounded(unit.doubt->largest_mm, 1)},
                                        {"largest_own_mm", rounded(unit.doubt->largest_own, 1)}}});
  return members;
}

}  // namespace

json::JsonValue import_json(const dxf::DxfDrawing& drawing, const std::vector<json::JsonValue>& seams) {
  std::vector<json::JsonValue> pieces;
  for (const dxf::DxfPiece& piece : drawing.pieces) pieces.push_back(piece_json(piece));
  return Members{{"unit", unit_json(drawing.unit)},      {"style", drawing.style},
                 {"sizes", texts(drawing.sizes)},        {"size", drawing.size},
                 {"sample_size", drawing.sample_size},   {"layers", layers_json(drawing.layers)},
                 {"pieces", std::move(pieces)},          {"seams", seams},
                 {"report", report_json(drawing.report)}};
}

namespace {

json::JsonValue kept_json(const char* type, std::size_t count) {
  return Members{{"type", std::string(type)}, {"layer", std::string()},
                 {"block", std::string()},    {"fate", std::string("kept")},
                 {"reason", std::string()},   {"piece", std::string()},
                 {"count", count_of(count)},  {"lines", std::vector<json::JsonValue>{}}};
}

json::JsonValue panel_json(const pattern::Panel& panel) {
  const PieceMeasures m = measures_of(panel);
  return Members{{"name", panel.id},
                 {"area_mm2", rounded(m.area_mm2, 3)},
                 {"width_mm", rounded(m.width_mm, 3)},
                 {"height_mm", rounded(m.height_mm, 3)},
                 {"edges", count_of(panel.outline.edges.size())},
                 {"grain_deg", rounded(grain_degrees(panel.grain), 3)},
                 {"quantity", 1.0},
                 {"mirrored", 0.0},
                 {"unfolded", false},
                 {"edge_list", edges_json(panel)}};
}

/// What the reader passed over, with its JSON pointer in the text.
json::JsonValue note_json(const std::string& note) {
  return Members{
      {"line", 0.0}, {"piece", std::string()}, {"at", json::JsonValue()}, {"text", note}, {"count", 1.0}};
}

}  // namespace

json::JsonValue specification_json(const pattern::Pattern& pattern, const std::vector<json::JsonValue>& seams,
                                   const std::vector<std::string>& notes) {
  std::vector<json::JsonValue> pieces, warnings, entities;
  std::size_t edges = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    edges += panel.outline.edges.size();
    pieces.push_back(panel_json(panel));
  }
  for (const std::string& note : notes) warnings.push_back(note_json(note));
  const std::size_t panels = pattern.panels.size(), stitches = pattern.seams.size();
  if (panels > 0) entities.push_back(kept_json("panel", panels));
  if (edges > 0) entities.push_back(kept_json("edge", edges));
  if (stitches > 0) entities.push_back(kept_json("stitch", stitches));
  const Members counts{
      {"panels", count_of(panels)}, {"edges", count_of(edges)}, {"stitches", count_of(stitches)}};
  const Members unit{{"name", std::string("mm")},
                     {"confidence", 1.0},
                     {"evidence", texts({"the specification says how many of its units make a metre"})}};
  return Members{
      {"unit", unit},
      {"style", std::string()},
      {"sizes", std::vector<json::JsonValue>{}},
      {"size", std::string()},
      {"sample_size", std::string()},
      {"layers", std::vector<json::JsonValue>{}},
      {"pieces", std::move(pieces)},
      {"seams", seams},
      {"report",
       Members{{"counts", counts}, {"entities", std::move(entities)}, {"warnings", std::move(warnings)}}}};
}

}  // namespace toile::create
