#include "core/pattern/validate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/outline.h"

namespace toile::pattern {
namespace {

using Failure = std::optional<Error>;

constexpr double kFlatness = 0.02;              // mm, of the polylines that stand for curves here
constexpr std::size_t kMostPoints = 2'000'000;  // of one piece so drawn; more is no pattern
constexpr double kFarthest = 1e6;               // mm
constexpr double kUnitSlack = 1e-6;             // on the length of the grain

bool sound(const CubicBezier& c) {
  const auto near = [](Vec2 p) { return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest; };
  return near(c.p0) && near(c.p1) && near(c.p2) && near(c.p3);
}

Failure check_edge(const PanelEdge& edge, const std::string& where) {
  if (edge.id.empty()) return Error{"pattern.missing_id", "An edge has no id.", where};
  if (edge.curves.empty()) return Error{"pattern.empty_edge", "The edge has no curves.", where};
  for (const CubicBezier& c : edge.curves) {
    if (!is_finite(c.p0) || !is_finite(c.p1) || !is_finite(c.p2) || !is_finite(c.p3))
      return Error{"pattern.not_finite", "A coordinate is not a finite number.", where};
    if (!sound(c))
      return Error{"pattern.too_large", "A coordinate is beyond a kilometre.", where, ErrorKind::kTooLarge};
  }
  return std::nullopt;
}

/// Every curve starts where the one before ends, all the way round.
Failure check_closed(const Loop& loop, const std::string& piece) {
  const PanelEdge* last_edge = &loop.edges.back();
  Vec2 end = last_edge->curves.back().p3;
  for (const PanelEdge& edge : loop.edges) {
    for (const CubicBezier& c : edge.curves) {
      if (c.p0 != end)
        return Error{"pattern.open_outline",
                     "A curve starts at " + place_text(c.p0) + ", but the one before it ends at " +
                         place_text(end) + ".",
                     piece + ", edge " + edge.id};
      end = c.p3;
    }
  }
  return std::nullopt;
}

Failure check_edges(const Panel& panel, const std::string& piece) {
  std::set<std::string> ids;
  std::size_t points = 0;
  const std::vector<const PanelEdge*> edges = edges_of(panel);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const PanelEdge& edge = *edges[i];
    const std::string where = piece + ", edge " + (edge.id.empty() ? std::to_string(i) : edge.id);
    if (auto error = check_edge(edge, where)) return error;
    if (!ids.insert(edge.id).second)
      return Error{"pattern.duplicate_id", "Two edges of the piece are both called '" + edge.id + "'.",
                   where};
    for (const CubicBezier& c : edge.curves) points += flat_steps(c, kFlatness);
    if (points > kMostPoints)
      return Error{"pattern.too_large", "The piece has more curves than a pattern needs.", where,
                   ErrorKind::kTooLarge};
  }
  return std::nullopt;
}

/// The name of a loop, as it follows "piece front".
std::string loop_text(std::size_t loop) { return loop == 0 ? "" : ", hole " + std::to_string(loop - 1); }

/// The edge of a flattened loop on which its segment lies.
const PanelEdge& edge_at(const Loop& loop, std::size_t segment) {
  for (const PanelEdge& edge : loop.edges)
    for (const CubicBezier& c : edge.curves) {
      const std::size_t steps = flat_steps(c, kFlatness);
      if (segment < steps) return edge;
      segment -= steps;
    }
  return loop.edges.back();
}

struct AreaFault {
  bool flat;  ///< it encloses nothing; else it runs the wrong way round
  Error error;
};

std::optional<AreaFault> area_fault(const std::vector<const Loop*>& loops, const std::string& piece) {
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const double area = signed_area(*loops[l]) * (l == 0 ? 1 : -1);
    const std::string where = piece + loop_text(l);
    if (std::abs(area) < kLeastArea)
      return AreaFault{true, {"pattern.zero_area", "The outline encloses no area.", where}};
    if (area < 0)
      return AreaFault{false,
                       {"pattern.clockwise",
                        l == 0 ? "The outline runs clockwise; pieces run counter-clockwise."
                               : "The hole runs counter-clockwise; holes run clockwise.",
                        where}};
  }
  return std::nullopt;
}

Failure check_crossings(const std::vector<const Loop*>& loops, const std::string& piece) {
  std::vector<std::vector<Vec2>> flat;
  flat.reserve(loops.size());
  for (const Loop* loop : loops) flat.push_back(flatten(*loop, kFlatness));
  if (const std::optional<geometry::Crossing> c = geometry::find_crossing(flat)) {
    const PanelEdge &a = edge_at(*loops[c->loop_a], c->segment_a),
                    &b = edge_at(*loops[c->loop_b], c->segment_b);
    return Error{"pattern.self_crossing",
                 "Edges " + a.id + " and " + b.id + " cross or touch at " + place_text(c->point) + ".",
                 piece + ", edge " + a.id};
  }
  // Nothing crosses: one point tells where the whole hole lies.
  for (std::size_t h = 1; h < flat.size(); ++h) {
    bool free = geometry::contains(flat[0], flat[h][0]);
    for (std::size_t other = 1; other < flat.size(); ++other)
      free = free && (other == h || !geometry::contains(flat[other], flat[h][0]));
    if (!free)
      return Error{"pattern.hole_outside", "The hole does not lie in the cloth of its piece.",
                   piece + loop_text(h)};
  }
  return std::nullopt;
}

/// How far a line may be from the outline and yet end on it.
constexpr double kOnOutline = 0.5;  // mm

bool in_cloth(const std::vector<std::vector<Vec2>>& loops, Vec2 p) {
  bool inside = geometry::contains(loops[0], p);
  for (std::size_t h = 1; h < loops.size(); ++h) inside = inside && !geometry::contains(loops[h], p);
  return inside;
}

double distance_to_loops(const std::vector<std::vector<Vec2>>& loops, Vec2 p) {
  double nearest = kFarthest;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      nearest = std::min(nearest, geometry::distance_to_segment(p, loop[i], loop[(i + 1) % loop.size()]));
    }
  }
  return nearest;
}

Failure check_line(const InnerLine& line, const std::vector<std::vector<Vec2>>& loops,
                   const std::string& where) {
  const auto bad = [&](const std::string& why) { return Error{"pattern.bad_line", why, where}; };
  if (line.points.size() < 2) return bad("The line needs two points.");
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec2 p = line.points[i];
    if (!is_finite(p)) return Error{"pattern.not_finite", "A coordinate is not a finite number.", where};
    if (line.drawn) continue;
    if (i > 0 && length(p - line.points[i - 1]) < kJointTolerance)
      return bad("Two of the line's points are one, at " + place_text(p) + ".");
    const bool end = i == 0 || i + 1 == line.points.size();
    if (!in_cloth(loops, p) && !(end && distance_to_loops(loops, p) <= kOnOutline))
      return bad("The line leaves the piece at " + place_text(p) + ".");
  }
  return std::nullopt;
}

Failure check_lines(const Panel& panel, const std::string& piece) {
  if (panel.lines.empty()) return std::nullopt;
  std::set<std::string> ids;
  for (const PanelEdge* edge : edges_of(panel)) ids.insert(edge->id);
  std::vector<std::vector<Vec2>> loops{flatten(panel.outline, kFlatness)};
  for (const Loop& hole : panel.holes) loops.push_back(flatten(hole, kFlatness));
  for (std::size_t i = 0; i < panel.lines.size(); ++i) {
    const InnerLine& line = panel.lines[i];
    const std::string where = piece + ", line " + (line.id.empty() ? std::to_string(i) : line.id);
    if (line.id.empty()) return Error{"pattern.missing_id", "A line has no id.", where};
    if (!ids.insert(line.id).second)
      return Error{"pattern.duplicate_id",
                   "Two edges or lines of the piece are both called '" + line.id + "'.", where};
    if (auto error = check_line(line, loops, where)) return error;
  }
  return std::nullopt;
}

std::vector<const Loop*> loops_of(const Panel& panel) {
  std::vector<const Loop*> loops{&panel.outline};
  for (const Loop& hole : panel.holes) loops.push_back(&hole);
  return loops;
}

/// What must hold before the loops can be drawn and compared.
Failure check_form(const Panel& panel, const std::vector<const Loop*>& loops, const std::string& piece) {
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (loops[l]->edges.empty())
      return Error{"pattern.empty_edge", "The outline has no edges.", piece + loop_text(l)};
  if (auto error = check_edges(panel, piece)) return error;
  for (const Loop* loop : loops)
    if (auto error = check_closed(*loop, piece)) return error;
  if (!is_finite(panel.grain) || std::abs(length(panel.grain) - 1) > kUnitSlack)
    return Error{"pattern.bad_grain", "The grain is not a direction of length 1.", piece};
  return std::nullopt;
}

Failure check_panel(const Panel& panel, const std::string& piece) {
  const std::vector<const Loop*> loops = loops_of(panel);
  if (auto error = check_form(panel, loops, piece)) return error;
  if (auto error = check_crossings(loops, piece)) {
    // A flat outline touches itself everywhere: that it is flat says more.
    if (auto fault = area_fault(loops, piece); fault && fault->flat) return fault->error;
    return error;
  }
  if (auto fault = area_fault(loops, piece)) return fault->error;
  return check_lines(panel, piece);
}

/// A part of an edge that a seam has, and where that is said.
struct SewnRange {
  double from, to;
  std::string place;
};
using Sewn = std::map<std::pair<Index, Index>, std::vector<SewnRange>>;

Failure check_range(const SeamEdge& item, const std::string& edge, const std::string& place, Sewn& sewn) {
  constexpr double kTouch = 1e-9;  // of the edge: parts may share an end
  if (!(item.from >= 0 && item.to <= 1 && item.to - item.from > kTouch))
    return Error{"pattern.seam_range",
                 "The seam takes no part of " + edge + "; from and to are fractions of its length, 0 to 1.",
                 place};
  std::vector<SewnRange>& there = sewn[{item.panel, item.edge}];
  for (const SewnRange& other : there) {
    if (std::min(item.to, other.to) - std::max(item.from, other.from) > kTouch)
      return Error{"pattern.edge_sewn_twice", edge + " is already sewn in " + other.place + ".", place};
  }
  there.push_back({item.from, item.to, place});
  return std::nullopt;
}

Failure check_side(const Pattern& pattern, const std::vector<SeamEdge>& side, const std::string& where,
                   Sewn& sewn) {
  if (side.empty()) return Error{"pattern.empty_seam_side", "The seam has no edges on this side.", where};
  for (std::size_t i = 0; i < side.size(); ++i) {
    const SeamEdge& item = side[i];
    const std::string place = where + ", item " + std::to_string(i);
    if (item.panel < 0 || std::size_t(item.panel) >= pattern.panels.size())
      return Error{"pattern.seam_reference", "There is no piece " + std::to_string(item.panel) + ".", place};
    const Panel& panel = pattern.panels[std::size_t(item.panel)];
    const std::vector<const PanelEdge*> edges = edges_of(panel);
    if (item.edge < 0 || std::size_t(item.edge) >= edges.size())
      return Error{"pattern.seam_reference",
                   "Piece " + panel.id + " has no edge " + std::to_string(item.edge) + ".", place};
    const std::string edge = "Edge " + edges[std::size_t(item.edge)]->id + " of piece " + panel.id;
    if (auto error = check_range(item, edge, place, sewn)) return error;
  }
  return std::nullopt;
}

Failure check_seams(const Pattern& pattern) {
  std::set<std::string> ids;
  Sewn sewn;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (seam.id.empty()) return Error{"pattern.missing_id", "A seam has no id.", "seam " + std::to_string(s)};
    const std::string where = "seam " + seam.id;
    if (!ids.insert(seam.id).second)
      return Error{"pattern.duplicate_id", "Two seams are both called '" + seam.id + "'.", where};
    if (auto error = check_side(pattern, seam.a, where + ", side a", sewn)) return error;
    if (auto error = check_side(pattern, seam.b, where + ", side b", sewn)) return error;
  }
  return std::nullopt;
}

}  // namespace

Status validate(const Panel& panel) {
  if (panel.id.empty()) return Error{"pattern.missing_id", "The piece has no id.", ""};
  const Failure error = check_panel(panel, "piece " + panel.id);
  return error ? Status(*error) : Status();
}

bool has_crossing_lines(const Panel& panel) {
  const std::vector<const Loop*> loops = loops_of(panel);
  if (panel.id.empty() || check_form(panel, loops, "") || !check_crossings(loops, "")) return false;
  const std::optional<AreaFault> fault = area_fault(loops, "");
  return !(fault && fault->flat);
}

Status validate(const Pattern& pattern) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
    const std::string& id = pattern.panels[i].id;
    if (id.empty()) return Error{"pattern.missing_id", "A piece has no id.", "piece " + std::to_string(i)};
    if (!ids.insert(id).second)
      return Error{"pattern.duplicate_id", "Two pieces are both called '" + id + "'.", "piece " + id};
    if (Status status = validate(pattern.panels[i]); !status) return status;
  }
  const Failure error = check_seams(pattern);
  return error ? Status(*error) : Status();
}

}  // namespace toile::pattern
