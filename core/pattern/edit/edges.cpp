#include "core/pattern/edit/edges.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/edit/places.h"
#include "core/pattern/edit/shape.h"
#include "core/pattern/outline.h"

namespace toile::edit {
namespace {

pattern::Panel& panel_at(pattern::Pattern& pattern, Index panel) {
  return pattern.panels[std::size_t(panel)];
}

Index edge_count(const pattern::Panel& panel) { return Index(pattern::edges_of(panel).size()); }

/// Shares after `count` edges were put in behind edge `after`.
EdgeShares with_room(Index edges, Index after, Index count) {
  EdgeShares shares = same_edges(edges);
  for (Index e = after + 1; e < edges; ++e) shares[std::size_t(e)].front().edge += count;
  return shares;
}

/// The edge in two at a place within it.
std::pair<pattern::PanelEdge, pattern::PanelEdge> parted(const pattern::PanelEdge& edge, CurvePlace place) {
  pattern::PanelEdge first{edge.id, {}}, second{edge.id, {}};
  for (std::size_t k = 0; k < edge.curves.size(); ++k) {
    if (k == place.curve && place.t > 0) {
      const auto [a, b] = pattern::split(edge.curves[k], place.t);
      first.curves.push_back(a);
      second.curves.push_back(b);
    } else {
      (k < place.curve ? first : second).curves.push_back(edge.curves[k]);
    }
  }
  return {std::move(first), std::move(second)};
}

void append(pattern::PanelEdge& edge, const pattern::PanelEdge& more) {
  edge.curves.insert(edge.curves.end(), more.curves.begin(), more.curves.end());
}

/// The names under which `panel` has any of the loop's edges now no more.
RenamedParts gone(const pattern::Loop& loop) {
  RenamedParts parts;
  for (const pattern::PanelEdge& edge : loop.edges) parts.push_back({edge.id, {}});
  return parts;
}

Result<pattern::PanelEdge> edge_of(const DrawnEdge& drawn) {
  if (!drawn.points.empty()) return pattern::edge_from_points(drawn.id, drawn.points);
  pattern::PanelEdge edge{drawn.id, {}};
  for (const auto& [p0, p1, p2, p3] : drawn.curves) edge.curves.push_back({p0, p1, p2, p3});
  return edge;
}

struct Mouth {
  CurvePlace from, to;
  double at_from = 0, at_to = 1;  ///< fractions
};

Result<Mouth> mouth_of(const pattern::PanelEdge& edge, const AddDart& dart, const std::string& where) {
  const double whole = pattern::arc_length(edge), half = whole > 0 ? dart.width_mm / 2 / whole : 0;
  if (!(dart.width_mm >= 1 && dart.depth_mm >= 1)) {
    return Error{"edit.out_of_range", "A dart is at least 1 mm wide and 1 mm deep.", where};
  }
  Mouth mouth;
  mouth.at_from = dart.at - half;
  mouth.at_to = dart.at + half;
  const Result<CurvePlace> from = place_on_edge(edge, mouth.at_from, where);
  if (!from) return Error{"edit.out_of_range", "The dart reaches beyond the edge.", where};
  const Result<CurvePlace> to = place_on_edge(edge, mouth.at_to, where);
  if (!to) return Error{"edit.out_of_range", "The dart reaches beyond the edge.", where};
  mouth.from = *from;
  mouth.to = *to;
  return mouth;
}

/// The edge before a dart, its legs, and the edge behind it. The second part is found by splitting once more,
/// from the other end, so that both keep the outer curves exactly.
std::vector<pattern::PanelEdge> darted(const pattern::PanelEdge& edge, const Mouth& mouth,
                                       const AddDart& dart, const std::string& rest_id) {
  pattern::PanelEdge before = parted(edge, mouth.from).first, behind = parted(edge, mouth.to).second;
  behind.id = rest_id;
  const Vec2 a = before.curves.back().p3, b = behind.curves.front().p0;
  // Cloth lies on the left of every edge.
  const Vec2 apex = (a + b) * 0.5 + perpendicular(normalized(b - a)) * dart.depth_mm;
  return {std::move(before),
          {dart.id + "_a", {pattern::line_segment(a, apex)}},
          {dart.id + "_b", {pattern::line_segment(apex, b)}},
          std::move(behind)};
}

/// Whether an item of a seam lies wholly between the two places: it would go with the cloth that a dart cuts
/// away.
bool sewn_within(const pattern::Pattern& pattern, Index panel, Index edge, const Mouth& mouth) {
  constexpr double kTouch = 1e-9;
  const auto within = [&](const pattern::SeamEdge& item) {
    return item.panel == panel && item.edge == edge && item.from >= mouth.at_from - kTouch &&
           item.to <= mouth.at_to + kTouch;
  };
  return std::any_of(pattern.seams.begin(), pattern.seams.end(), [&](const pattern::Seam& seam) {
    return std::any_of(seam.a.begin(), seam.a.end(), within) ||
           std::any_of(seam.b.begin(), seam.b.end(), within);
  });
}

bool whole(const pattern::SeamEdge& item) { return !item.reversed && item.from == 0 && item.to == 1; }

/// Forgets notches that lie on no edge any more.
void drop_loose_notches(pattern::Panel& panel) {
  constexpr double kOn = 0.5, kFlat = 0.02;  // mm
  std::vector<std::vector<Vec2>> lines;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel))
    lines.push_back(pattern::flatten(*edge, kFlat));
  const auto on = [&](const std::vector<Vec2>& line, Vec2 p) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      if (geometry::distance_to_segment(p, line[i], line[i + 1]) <= kOn) return true;
    return false;
  };
  std::erase_if(panel.notches, [&](const pattern::Notch& notch) {
    return std::none_of(lines.begin(), lines.end(), [&](const auto& line) { return on(line, notch.at); });
  });
}

/// Leads the edge's end to a point by a straight line, or by a nudge where a line would be none.
void close_gap(pattern::PanelEdge& edge, Vec2 to) {
  const Vec2 end = edge.curves.back().p3;
  if (length(to - end) > pattern::kJointTolerance) {
    edge.curves.push_back(pattern::line_segment(end, to));
  } else {
    edge.curves.back().p3 = to;
  }
}

Error no_dart(const pattern::Seam& seam) {
  return {"edit.no_dart", "This seam does not join two whole edges that follow each other in one piece.",
          "seam " + seam.id};
}

/// The first leg of the dart that a seam closes: the second follows it in its loop.
Result<EdgePlace> first_leg(const pattern::Panel& panel, const pattern::Seam& seam) {
  const std::vector<const pattern::PanelEdge*> edges = pattern::edges_of(panel);
  for (const auto& [one, other] :
       {std::pair(seam.a[0].edge, seam.b[0].edge), {seam.b[0].edge, seam.a[0].edge}}) {
    const EdgePlace a = TRY(find_edge(panel, edges[std::size_t(one)]->id));
    const EdgePlace b = TRY(find_edge(panel, edges[std::size_t(other)]->id));
    const std::size_t n = loop_at(panel, a.loop).edges.size();
    if (a.loop == b.loop && n >= (a.loop > 0 ? 2u : 3u) && (a.edge + 1) % n == b.edge) return a;
  }
  return no_dart(seam);
}

}  // namespace

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const SplitEdge& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const EdgePlace at = TRY(find_edge(piece, edit.edge));
  std::vector<pattern::PanelEdge>& edges = loop_at(piece, at.loop).edges;
  const CurvePlace place = TRY(place_on_edge(edges[at.edge], edit.at, edge_text(piece.id, edit.edge)));
  auto [first, second] = parted(edges[at.edge], place);
  second.id = edit.id.empty() ? free_part_id(piece, edit.edge) : edit.id;
  const double a = pattern::arc_length(first), share = a / (a + pattern::arc_length(second));

  EdgeShares shares = with_room(edge_count(piece), at.index, 1);
  shares[std::size_t(at.index)] = {{0, share, at.index, 0, 1}, {share, 1, at.index + 1, 0, 1}};
  RenamedParts parts{{edit.edge, {edit.edge, second.id}}};
  edges[at.edge] = std::move(first);
  edges.insert(edges.begin() + std::ptrdiff_t(at.edge) + 1, std::move(second));
  carry_seams(pattern, panel, shares);
  return parts;
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const JoinEdges& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const EdgePlace at = TRY(find_edge(piece, edit.edge));
  const EdgePlace next = TRY(find_edge(piece, edit.next));
  std::vector<pattern::PanelEdge>& edges = loop_at(piece, at.loop).edges;
  const std::size_t n = edges.size();
  if (next.loop != at.loop || n < 2 || (at.edge + 1) % n != next.edge) {
    return Error{"edit.not_neighbours", "Edge " + edit.next + " does not follow this one.",
                 edge_text(piece.id, edit.edge)};
  }
  const double a = pattern::arc_length(edges[at.edge]),
               share = a / (a + pattern::arc_length(edges[next.edge]));
  EdgeShares shares = same_edges(edge_count(piece));
  for (std::size_t e = std::size_t(next.index) + 1; e < shares.size(); ++e) shares[e].front().edge -= 1;
  const Index now = at.index - (next.index < at.index ? 1 : 0);  // the loop's last edge with its first
  shares[std::size_t(at.index)] = {{0, 1, now, 0, share}};
  shares[std::size_t(next.index)] = {{0, 1, now, share, 1}};
  append(edges[at.edge], edges[next.edge]);
  edges.erase(edges.begin() + std::ptrdiff_t(next.edge));
  carry_seams(pattern, panel, shares);
  return RenamedParts{{edit.next, {edit.edge}}};
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const AddDart& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const EdgePlace at = TRY(find_edge(piece, edit.edge));
  std::vector<pattern::PanelEdge>& edges = loop_at(piece, at.loop).edges;
  const std::string where = edge_text(piece.id, edit.edge);
  const Mouth mouth = TRY(mouth_of(edges[at.edge], edit, where));
  if (sewn_within(pattern, panel, at.index, mouth)) {
    return Error{"edit.sewn", "The dart would cut away a sewn part of the edge.", where};
  }
  const std::string rest = free_part_id(piece, edit.edge);
  std::vector<pattern::PanelEdge> four = darted(edges[at.edge], mouth, edit, rest);
  EdgeShares shares = with_room(edge_count(piece), at.index, 3);
  shares[std::size_t(at.index)] = {{0, mouth.at_from, at.index, 0, 1}, {mouth.at_to, 1, at.index + 3, 0, 1}};
  const auto place = edges.erase(edges.begin() + std::ptrdiff_t(at.edge));
  edges.insert(place, std::make_move_iterator(four.begin()), std::make_move_iterator(four.end()));
  drop_loose_notches(piece);
  carry_seams(pattern, panel, shares);
  pattern.seams.push_back({edit.id, {{panel, at.index + 1}}, {{panel, at.index + 2}}, false});
  return RenamedParts{{edit.edge, {edit.edge, rest}}};
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const AddInnerDart& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const std::string where = piece_text(piece.id) + ", dart " + edit.id;
  const Vec2 axis = edit.to - edit.from;
  if (!(edit.width_mm >= 1 && length(axis) >= 1 && edit.at >= 0.05 && edit.at <= 0.95))
    return Error{"edit.out_of_range",
                 "A dart is at least 1 mm wide and long, and widest between 0.05 and 0.95 of its length.",
                 where};
  const Vec2 middle = edit.from + axis * edit.at,
             half = perpendicular(normalized(axis)) * (edit.width_mm / 2);
  const auto side = [](const std::string& id, Vec2 a, Vec2 b, Vec2 c) {
    return pattern::PanelEdge{id, {pattern::line_segment(a, b), pattern::line_segment(b, c)}};
  };
  // Up along the left and down along the right: clockwise, as holes run.
  piece.holes.push_back({{side(edit.id + "_a", edit.from, middle + half, edit.to),
                          side(edit.id + "_b", edit.to, middle - half, edit.from)}});
  const Index last = edge_count(piece) - 1;
  pattern.seams.push_back({edit.id, {{panel, last - 1}}, {{panel, last}}, false});
  return RenamedParts{};
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const RenameEdge& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const EdgePlace at = TRY(find_edge(piece, edit.edge));
  loop_at(piece, at.loop).edges[at.edge].id = edit.to;
  return edit.to == edit.edge ? RenamedParts{} : RenamedParts{{edit.edge, {edit.to}}};
}

Result<Index> piece_of_dart(const pattern::Pattern& pattern, const RemoveDart& edit) {
  const std::size_t at = TRY(find_seam(pattern, edit.seam));
  const pattern::Seam& seam = pattern.seams[at];
  const bool dart = seam.a.size() == 1 && seam.b.size() == 1 && whole(seam.a[0]) && whole(seam.b[0]) &&
                    seam.a[0].panel == seam.b[0].panel && !seam.same_direction;
  if (!dart) return no_dart(seam);
  return seam.a[0].panel;
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const RemoveDart& edit) {
  const std::size_t at = TRY(find_seam(pattern, edit.seam));
  pattern::Panel& piece = panel_at(pattern, panel);
  const EdgePlace leg = TRY(first_leg(piece, pattern.seams[at]));
  std::vector<pattern::PanelEdge>& edges = loop_at(piece, leg.loop).edges;
  if (edges.size() == 2) return edit_edges(pattern, panel, RemoveHole{piece.id, edges[0].id});
  const std::size_t n = edges.size(), second = (leg.edge + 1) % n, behind = (second + 1) % n;
  const std::size_t before = (leg.edge + n - 1) % n;
  const Index first_of_loop = leg.index - Index(leg.edge);
  close_gap(edges[before], edges[behind].curves.front().p0);
  RenamedParts parts{{edges[leg.edge].id, {}}, {edges[second].id, {}}};

  EdgeShares shares = same_edges(edge_count(piece));
  const Index removed[] = {first_of_loop + Index(leg.edge), first_of_loop + Index(second)};
  for (std::vector<EdgeShare>& share : shares) {
    const Index own = share.front().edge;
    for (const Index r : removed) share.front().edge -= r < own ? 1 : 0;
  }
  for (const Index r : removed) shares[std::size_t(r)].clear();
  edges.erase(edges.begin() + std::ptrdiff_t(std::max(leg.edge, second)));
  edges.erase(edges.begin() + std::ptrdiff_t(std::min(leg.edge, second)));
  carry_seams(pattern, panel, shares);
  return parts;
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const AddHole& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const auto in_hole = [&](Error error) {
    error.where = piece_text(piece.id) + ", hole" + (error.where.empty() ? "" : ", " + error.where);
    return error;
  };
  std::vector<pattern::PanelEdge> edges;
  for (const DrawnEdge& drawn : edit.edges) {
    Result<pattern::PanelEdge> edge = edge_of(drawn);
    if (!edge) return in_hole(edge.error());
    edges.push_back(std::move(*edge));
  }
  Result<pattern::Loop> hole = pattern::loop_from_edges(std::move(edges));
  if (!hole) return in_hole(hole.error());
  piece.holes.push_back(pattern::reversed(*hole));  // loops come counter-clockwise, holes run clockwise
  return RenamedParts{};
}

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const RemoveHole& edit) {
  pattern::Panel& piece = panel_at(pattern, panel);
  const EdgePlace at = TRY(find_edge(piece, edit.edge));
  if (at.loop == 0) {
    return Error{"edit.unknown_edge", "This edge belongs to the outline and to no hole.",
                 edge_text(piece.id, edit.edge)};
  }
  const pattern::Loop& hole = loop_at(piece, at.loop);
  const Index first = at.index - Index(at.edge), count = Index(hole.edges.size());
  EdgeShares shares = same_edges(edge_count(piece));
  for (std::size_t e = std::size_t(first); e < shares.size(); ++e) {
    if (Index(e) < first + count) {
      shares[e].clear();
    } else {
      shares[e].front().edge -= count;
    }
  }
  RenamedParts parts = gone(hole);
  piece.holes.erase(piece.holes.begin() + std::ptrdiff_t(at.loop) - 1);
  carry_seams(pattern, panel, shares);
  return parts;
}

}  // namespace toile::edit
