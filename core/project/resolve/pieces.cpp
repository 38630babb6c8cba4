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

namespace toile {
namespace {

Result<Panel> panel_from_file(const ProjectDxf& from, OpenedFiles& files, const std::string& where) {
  const Result<const DxfDrawing*> drawing = files.drawing(from);
  if (!drawing) return error_at(pointer_to(where, "dxf"), drawing.error());
  std::vector<std::string> names;
  for (const DxfPiece& piece : (*drawing)->pieces) {
    if (piece.name == from.piece) {
      Result<Panel> panel = panel_from_piece(piece, from.corners);
      if (!panel) return error_at(where, panel.error());
      return panel;
    }
    names.push_back(piece.name);
  }
  return Error{
      "project.unknown_piece",
      in_quotes(from.dxf) + " has no piece " + in_quotes(from.piece) + "; " + advice(from.piece, names),
      pointer_to(where, "piece")};
}

Result<PanelEdge> edge_of(const ProjectEdge& given) {
  if (!given.points.empty()) return edge_from_points(given.id, given.points);
  PanelEdge edge;
  edge.id = given.id;
  for (const auto& [p0, p1, p2, p3] : given.curves) edge.curves.push_back({p0, p1, p2, p3});
  return edge;
}

Result<Loop> loop_of(const std::vector<ProjectEdge>& given, const std::string& where) {
  std::vector<PanelEdge> edges;
  for (std::size_t i = 0; i < given.size(); ++i) {
    Result<PanelEdge> edge = edge_of(given[i]);
    if (!edge) return error_at(pointer_to(where, i), edge.error());
    edges.push_back(std::move(*edge));
  }
  Result<Loop> loop = loop_from_edges(std::move(edges));
  if (!loop) return error_at(where, loop.error());
  return loop;
}

Result<Panel> inline_panel(const ProjectPiece& piece, const std::string& where) {
  Loop outline = TRY(loop_of(piece.outline, pointer_to(where, "outline")));
  Panel panel;
  panel.outline = std::move(outline);
  for (std::size_t i = 0; i < piece.holes.size(); ++i) {
    Loop hole = TRY(loop_of(piece.holes[i], pointer_to(pointer_to(where, "holes"), i)));
    panel.holes.push_back(reversed(hole));  // loops come counter-clockwise, holes run clockwise
  }
  return panel;
}

/// Gives edges the document's names for them.
Status rename_edges(const ProjectPiece& piece, Panel& panel, const std::string& where) {
  std::vector<PanelEdge*> edges;
  std::vector<std::string> ids;  // before any renaming, so that names may be swapped
  const auto add = [&](Loop& loop) {
    for (PanelEdge& edge : loop.edges) {
      edges.push_back(&edge);
      ids.push_back(edge.id);
    }
  };
  add(panel.outline);
  for (Loop& hole : panel.holes) add(hole);
  for (const auto& [from, to] : piece.edge_names) {
    const auto found = std::find(ids.begin(), ids.end(), from);
    if (found == ids.end()) {
      return Error{"project.unknown_edge",
                   "the piece has no edge " + in_quotes(from) + "; " + advice(from, ids),
                   pointer_to(pointer_to(where, "edge_names"), from)};
    }
    edges[static_cast<std::size_t>(found - ids.begin())]->id = to;
  }
  return {};
}

/// The document's lines behind those of the file, which go out of the way of ids that are taken.
void add_lines(const ProjectPiece& piece, Panel& panel) {
  std::set<std::string> taken;
  for (const PanelEdge* edge : edges_of(panel)) taken.insert(edge->id);
  for (const ProjectLine& line : piece.lines) taken.insert(line.id);
  for (InnerLine& line : panel.lines) {
    const std::string wanted = line.id;
    for (int n = 2; !taken.insert(line.id).second; ++n) line.id = wanted + "_" + std::to_string(n);
  }
  for (const ProjectLine& line : piece.lines) panel.lines.push_back({line.id, line.points, line.drawn});
}

Status set_grain(const ProjectPiece& piece, Panel& panel, const std::string& where) {
  if (!piece.grain) return {};
  panel.grain = normalized(*piece.grain);
  if (length(*piece.grain) > 0) return {};
  return Error{"project.out_of_range", "the grain must have a direction", pointer_to(where, "grain")};
}

Status check_texture(const ProjectPiece& piece, const std::string& where) {
  if (!piece.texture) return {};
  const Status name = check_file_name(piece.texture->image);
  return name ? name : error_at(pointer_to(pointer_to(where, "texture"), "image"), name.error());
}

Result<Panel> panel_of(const ProjectPiece& piece, OpenedFiles& files, const std::string& where) {
  if (piece.from && !piece.holes.empty()) {
    return Error{"project.two_ways", "the holes of a piece from a file stand in the file",
                 pointer_to(where, "holes")};
  }
  if (piece.from && !piece.notches.empty()) {
    return Error{"project.two_ways", "the notches of a piece from a file stand in the file",
                 pointer_to(where, "notches")};
  }
  Panel panel = TRY(piece.from ? panel_from_file(*piece.from, files, pointer_to(where, "from"))
                               : inline_panel(piece, where));
  panel.id = piece.id;
  panel.fabric = piece.fabric;
  panel.layer = piece.layer;
  if (piece.physical) panel.spacing = metres_from_mm(piece.physical->particle_distance_mm.value_or(0));
  for (const ProjectNotch& n : piece.notches)
    panel.notches.push_back({n.at, n.depth_mm, normalized(n.inwards.value_or(Vec2{}))});
  TRY(rename_edges(piece, panel, where));
  add_lines(piece, panel);
  TRY(set_grain(piece, panel, where));
  TRY(check_texture(piece, where));
  if (Status valid = validate(panel); !valid) return error_at(where, valid.error());
  return panel;
}

}  // namespace

ProjectFabric with_physical(ProjectFabric fabric, const ProjectPhysical& own) {
  const auto take = [](double& value, const std::optional<double>& given) { value = given.value_or(value); };
  take(fabric.areal_mass_g_m2, own.areal_mass_g_m2);
  take(fabric.stretch_warp_n_m, own.stretch_warp_n_m);
  take(fabric.stretch_weft_n_m, own.stretch_weft_n_m);
  take(fabric.stretch_coupling_n_m, own.stretch_coupling_n_m);
  take(fabric.stretch_shear_n_m, own.stretch_shear_n_m);
  take(fabric.bend_warp_un_m, own.bend_warp_un_m);
  take(fabric.bend_weft_un_m, own.bend_weft_un_m);
  take(fabric.bend_bias_un_m, own.bend_bias_un_m);
  take(fabric.thickness_mm, own.thickness_mm);
  take(fabric.friction, own.friction);
  return fabric;
}

Result<std::vector<Panel>> panels_of(const std::vector<ProjectPiece>& pieces, OpenedFiles& files) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Panel panel = TRY(panel_of(pieces[i], files, pointer_to("/pieces", i)));
    panels.push_back(std::move(panel));
  }
  return panels;
}

Status follow_used_lines(const Notions& notions, Pattern& pattern) {
  const auto follow = [&](Index panel, const std::vector<Index>& lines, const std::string& where) -> Status {
    Panel& piece = pattern.panels[std::size_t(panel)];
    bool drawn = false;
    for (const Index line : lines)
      drawn = std::exchange(piece.lines[std::size_t(line)].drawn, false) || drawn;
    if (!drawn) return {};
    const Status valid = validate(piece);
    return valid ? valid : error_at(where, valid.error());
  };
  for (std::size_t i = 0; i < notions.elastics.size(); ++i) {
    const Elastic& elastic = notions.elastics[i];
    if (Status s = follow(elastic.panel, elastic.lines, pointer_to("/elastics", i)); !s) return s;
  }
  for (std::size_t i = 0; i < notions.creases.size(); ++i) {
    const Crease& crease = notions.creases[i];
    if (Status s = follow(crease.panel, crease.lines, pointer_to("/folds", i)); !s) return s;
  }
  return {};
}

}  // namespace toile
