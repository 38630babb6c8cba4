#include "core/project/resolve/pieces.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/outline.h"
#include "core/pattern/validate.h"

namespace toile::resolve {
namespace {

Result<pattern::Panel> panel_from_file(const project::ProjectDxf& from, OpenedFiles& files,
                                       const std::string& where) {
  const Result<const dxf::DxfDrawing*> drawing = files.drawing(from);
  if (!drawing) {
    const bool is_of_layers = drawing.error().code == "dxf.unknown_layer";
    return json::error_at(json::pointer_to(where, is_of_layers ? "layers" : "dxf"), drawing.error());
  }
  std::vector<std::string> names;
  for (const dxf::DxfPiece& piece : (*drawing)->pieces) {
    if (piece.name == from.piece) {
      Result<pattern::Panel> panel = dxf::panel_from_piece(piece, from.corners);
      if (!panel) return json::error_at(where, panel.error());
      return panel;
    }
    names.push_back(piece.name);
  }
  return Error{
      "project.unknown_piece",
      in_quotes(from.dxf) + " has no piece " + in_quotes(from.piece) + "; " + advice(from.piece, names),
      json::pointer_to(where, "piece")};
}

Result<pattern::PanelEdge> edge_of(const project::ProjectEdge& given) {
  if (!given.points.empty()) return pattern::edge_from_points(given.id, given.points);
  pattern::PanelEdge edge;
  edge.id = given.id;
  for (const auto& [p0, p1, p2, p3] : given.curves) edge.curves.push_back({p0, p1, p2, p3});
  return edge;
}

Result<pattern::Loop> loop_of(const std::vector<project::ProjectEdge>& given, const std::string& where) {
  std::vector<pattern::PanelEdge> edges;
  for (std::size_t i = 0; i < given.size(); ++i) {
    Result<pattern::PanelEdge> edge = edge_of(given[i]);
    if (!edge) return json::error_at(json::pointer_to(where, i), edge.error());
    edges.push_back(std::move(*edge));
  }
  Result<pattern::Loop> loop = pattern::loop_from_edges(std::move(edges));
  if (!loop) return json::error_at(where, loop.error());
  return loop;
}

Result<pattern::Panel> inline_panel(const project::ProjectPiece& piece, const std::string& where) {
  pattern::Loop outline = TRY(loop_of(piece.outline, json::pointer_to(where, "outline")));
  pattern::Panel panel;
  panel.outline = std::move(outline);
  for (std::size_t i = 0; i < piece.holes.size(); ++i) {
    pattern::Loop hole = TRY(loop_of(piece.holes[i], json::pointer_to(json::pointer_to(where, "holes"), i)));
    panel.holes.push_back(pattern::reversed(hole));  // loops come counter-clockwise, holes run clockwise
  }
  return panel;
}

/// Gives edges the document's names for them.
Status rename_edges(const project::ProjectPiece& piece, pattern::Panel& panel, const std::string& where) {
  std::vector<pattern::PanelEdge*> edges;
  std::vector<std::string> ids;  // before any renaming, so that names may be swapped
  const auto add = [&](pattern::Loop& loop) {
    for (pattern::PanelEdge& edge : loop.edges) {
      edges.push_back(&edge);
      ids.push_back(edge.id);
    }
  };
  add(panel.outline);
  for (pattern::Loop& hole : panel.holes) add(hole);
  for (const auto& [from, to] : piece.edge_names) {
    const auto found = std::find(ids.begin(), ids.end(), from);
    if (found == ids.end()) {
      return Error{"project.unknown_edge",
                   "the piece has no edge " + in_quotes(from) + "; " + advice(from, ids),
                   json::pointer_to(json::pointer_to(where, "edge_names"), from)};
    }
    edges[static_cast<std::size_t>(found - ids.begin())]->id = to;
  }
  return {};
}

/// The document's lines behind those of the file, which go out of the way of ids that are taken.
void add_lines(const project::ProjectPiece& piece, pattern::Panel& panel) {
  std::set<std::string> taken;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) taken.insert(edge->id);
  for (const project::ProjectLine& line : piece.lines) taken.insert(line.id);
  for (pattern::InnerLine& line : panel.lines) {
    const std::string wanted = line.id;
    for (int n = 2; !taken.insert(line.id).second; ++n) line.id = wanted + "_" + std::to_string(n);
  }
  for (const project::ProjectLine& line : piece.lines)
    panel.lines.push_back({line.id, line.points, line.drawn});
}

Status set_grain(const project::ProjectPiece& piece, pattern::Panel& panel, const std::string& where) {
  if (!piece.grain) return {};
  panel.grain = normalized(*piece.grain);
  if (length(*piece.grain) > 0) return {};
  return Error{"project.out_of_range", "the grain must have a direction", json::pointer_to(where, "grain")};
}

Status check_texture(const project::ProjectPiece& piece, const std::string& where) {
  if (!piece.texture) return {};
  const Status name = check_file_name(piece.texture->image);
  return name ? name
              : json::error_at(json::pointer_to(json::pointer_to(where, "texture"), "image"), name.error());
}

Result<pattern::Panel> panel_of(const project::ProjectPiece& piece, OpenedFiles& files,
                                const std::string& where) {
  if (piece.from && !piece.holes.empty()) {
    return Error{"project.two_ways", "the holes of a piece from a file stand in the file",
                 json::pointer_to(where, "holes")};
  }
  if (piece.from && !piece.notches.empty()) {
    return Error{"project.two_ways", "the notches of a piece from a file stand in the file",
                 json::pointer_to(where, "notches")};
  }
  pattern::Panel panel = TRY(piece.from ? panel_from_file(*piece.from, files, json::pointer_to(where, "from"))
                                        : inline_panel(piece, where));
  panel.id = piece.id;
  panel.fabric = piece.fabric;
  panel.layer = piece.layer;
  if (piece.physical) panel.spacing = metres_from_mm(piece.physical->particle_distance_mm.value_or(0));
  for (const project::ProjectNotch& n : piece.notches)
    panel.notches.push_back({n.at, n.depth_mm, normalized(n.inwards.value_or(Vec2{}))});
  TRY(rename_edges(piece, panel, where));
  add_lines(piece, panel);
  TRY(set_grain(piece, panel, where));
  TRY(check_texture(piece, where));
  if (Status valid = pattern::validate(panel); !valid) return json::error_at(where, valid.error());
  return panel;
}

}  // namespace

Result<std::vector<pattern::Panel>> panels_of(const std::vector<project::ProjectPiece>& pieces,
                                              OpenedFiles& files) {
  std::vector<pattern::Panel> panels;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pattern::Panel panel = TRY(panel_of(pieces[i], files, json::pointer_to("/pieces", i)));
    panels.push_back(std::move(panel));
  }
  return panels;
}

Status follow_used_lines(const sewing::Notions& notions, pattern::Pattern& pattern) {
  const auto follow = [&](Index panel, const std::vector<Index>& lines, const std::string& where) -> Status {
    pattern::Panel& piece = pattern.panels[std::size_t(panel)];
    bool drawn = false;
    for (const Index line : lines)
      drawn = std::exchange(piece.lines[std::size_t(line)].drawn, false) || drawn;
    if (!drawn) return {};
    const Status valid = pattern::validate(piece);
    return valid ? valid : json::error_at(where, valid.error());
  };
  for (std::size_t i = 0; i < notions.elastics.size(); ++i) {
    const sewing::Elastic& elastic = notions.elastics[i];
    if (Status s = follow(elastic.panel, elastic.lines, json::pointer_to("/elastics", i)); !s) return s;
  }
  for (std::size_t i = 0; i < notions.creases.size(); ++i) {
    const sewing::Crease& crease = notions.creases[i];
    if (Status s = follow(crease.panel, crease.lines, json::pointer_to("/folds", i)); !s) return s;
  }
  return {};
}

}  // namespace toile::resolve
