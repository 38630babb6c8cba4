#include "core/arrange/arrange_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/arrange/garment_kind.h"
#include "core/arrange/trouser_legs.h"

namespace toile::arrange {
namespace {

/// Sleeves and cuffs sewn to them, and what is sewn to the rest of the garment through those alone. Where
/// sleeves are cut on, the cuffs of a top.
std::vector<bool> hang_on_arms(const GarmentGraph& graph) {
  std::vector<bool> on_arm(graph.pieces.size(), false);
  const auto any = [&](Cover cover) {
    return std::any_of(graph.pieces.begin(), graph.pieces.end(),
                       [&](const GarmentPiece& piece) { return piece.cover == cover; });
  };
  const bool cut_on = !any(Cover::kSleeve) && !any(Cover::kLeg) && any(Cover::kTorso);
  for (std::size_t p = 0; p < on_arm.size(); ++p) {
    const GarmentPiece& piece = graph.pieces[p];
    on_arm[p] = piece.cover == Cover::kSleeve || (cut_on && piece.cover == Cover::kCuff && piece.tube);
  }
  const auto spread = [&](std::vector<bool>& marked, auto may) {
    for (bool more = true; more;) {
      more = false;
      for (const GarmentTie& t : graph.ties) {
        for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.a}}) {
          if (!marked[from] || marked[to] || !may(to)) continue;
          marked[to] = more = true;
        }
      }
    }
  };
  if (std::find(on_arm.begin(), on_arm.end(), true) == on_arm.end()) return on_arm;
  spread(on_arm, [&](Index p) { return graph.pieces[p].cover == Cover::kCuff; });
  std::vector<bool> elsewhere(graph.pieces.size(), false);
  double most = 0;
  Index root = kNone;
  for (Index p = 0; p < static_cast<Index>(elsewhere.size()); ++p) {
    const Cover c = graph.pieces[p].cover;
    if (on_arm[p] || c == Cover::kCuff || graph.pieces[p].area <= most) continue;
    most = graph.pieces[p].area;
    root = p;
  }
  if (root == kNone) return on_arm;
  elsewhere[root] = true;
  spread(elsewhere, [&](Index p) { return !on_arm[p]; });
  spread(on_arm, [&](Index p) { return !elsewhere[p]; });
  return on_arm;
}

/// Whether the points lie within a strip, as those along one edge do.
bool lie_in_line(const std::vector<Vec2>& points) {
  constexpr double kStrip = 0.12;  // of its length, how wide
  if (points.empty()) return false;
  const PointAxes axes = axes_of(points);
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (const Vec2 p : points) {
    const double at[2] = {dot(p, axes.along), dot(p, perpendicular(axes.along))};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  return high[1] - low[1] < kStrip * (high[0] - low[0]);
}

/// Collars that are sewn to the front and to the back by one edge (a jacket's with its gorges lies before it
/// as it was drawn), or closed to a ring: they lie around the neck, open or not, and so does a collar that is
/// sewn to such a one more than to anything else.
std::vector<bool> go_around_neck(const GarmentGraph& graph) {
  const std::size_t count = graph.pieces.size();
  std::vector<bool> front(count), back(count), around(count);
  std::vector<std::vector<Vec2>> sewn(count);
  const auto each_tie = [&](auto visit) {
    for (const GarmentTie& t : graph.ties) {
      if (t.a == t.b) continue;
      if (graph.pieces[t.a].cover == Cover::kCollar) visit(t.a, t.b, t.at_a);
      if (graph.pieces[t.b].cover == Cover::kCollar) visit(t.b, t.a, t.at_b);
    }
  };
  each_tie([&](Index collar, Index other, Vec2 at) {
    const GarmentPiece& piece = graph.pieces[other];
    const bool yoke = piece.face == 0 && piece.cover == Cover::kTorso;  // over both shoulders
    if (piece.face > 0) front[collar] = true;
    if (piece.face < 0 || yoke) back[collar] = true;
    if (piece.face != 0 || yoke) sewn[collar].push_back(at);
  });
  for (std::size_t p = 0; p < count; ++p) {
    const bool ring = graph.pieces[p].cover == Cover::kCollar && graph.pieces[p].tube;
    around[p] = ring || (front[p] && back[p] && lie_in_line(sewn[p]));
  }
  std::vector<int> upon(count);
  each_tie([&](Index collar, Index other, Vec2) { upon[collar] += around[other] ? 1 : -1; });
  for (std::size_t p = 0; p < count; ++p) around[p] = around[p] || upon[p] > 0;
  return around;
}

/// The trunk's pieces on their sheets, clear of each other, legs over legs.
Result<FlatLayout> trunk_layout(GarmentGraph& graph, const std::vector<Index>& trunk,
                                const BodyStand& stand) {
  FlatLayout layout = lay_out_trunk(graph, trunk);
  for (const Index p : trunk) {
    if (layout.has(p)) continue;
    return Error{
        "arrange.no_seams",
        "no seam leads from the other pieces to this one, so that nothing tells where it goes; sew it, or "
        "place it by hand",
        "piece " + graph.pieces[p].id};
  }
  // Collars and frills of legs lie before the others: fronts that made room for lapels would stand far aside,
  // and so would two frills that made room for each other.
  std::vector<Index> flat;
  std::copy_if(trunk.begin(), trunk.end(), std::back_inserter(flat), [&](Index p) {
    return graph.pieces[p].cover != Cover::kCollar && graph.pieces[p].cover != Cover::kCuff;
  });
  part_pieces(graph, flat, kSheetGap, layout);
  layout = with_legs_over_legs(graph, trunk, stand, std::move(layout));
  part_pieces(graph, flat, kSheetGap, layout);  // turned legs may have come to lie on each other
  return layout;
}

double top_of(const GarmentGraph& graph, const std::vector<Index>& trunk, const FlatLayout& layout) {
  double top = -HUGE_VAL;
  for (const Index p : trunk) {
    for (const Vec2 q : outline_on_sheet(graph.pieces[p], layout.pose[p])) top = std::max(top, q.y);
  }
  return top;
}

/// In order: where nothing else tells, a piece goes where those before it have left room.
ArmPieces arm_pieces_of(const GarmentGraph& graph, const std::vector<Index>& on_arms,
                        const FlatLayout& layout) {
  ArmPieces arms;
  for (const Index p : on_arms) {
    auto& kind = graph.pieces[p].tube ? arms.tube : arms.limb;
    kind[side_of(graph, layout, arms, p)].push_back(p);
  }
  return arms;
}

}  // namespace

PieceRoles roles_of(const GarmentGraph& graph, const std::vector<LegPiece>& legs) {
  PieceRoles roles;
  const std::vector<bool> on_arm = hang_on_arms(graph);
  const std::vector<bool> around_neck = go_around_neck(graph);
  roles.gores = gore_ring(graph, on_arm);
  const auto is_gore = [&](Index p) {
    return std::any_of(roles.gores.begin(), roles.gores.end(), [&](const Gore& g) { return g.piece == p; });
  };
  const auto is_leg = [&](Index p) {
    return std::any_of(legs.begin(), legs.end(), [&](const LegPiece& leg) { return leg.piece == p; });
  };
  // A waistband that is open in front lies around the trunk where legs of one piece are all that it ends.
  const auto ends_legs = [&](Index p) {
    return graph.pieces[p].cover == Cover::kWaistband &&
           std::any_of(graph.ties.begin(), graph.ties.end(), [&](const GarmentTie& t) {
             return (t.a == p && is_leg(t.b)) || (t.b == p && is_leg(t.a));
           });
  };
  for (Index p = 0; p < static_cast<Index>(graph.pieces.size()); ++p) {
    const GarmentPiece& piece = graph.pieces[p];
    if (is_leg(p)) continue;
    if (on_arm[p]) {
      roles.on_arms.push_back(p);
    } else if (piece.cover == Cover::kHood) {
      roles.hoods.push_back(p);
    } else if (piece.tube || around_neck[p] || ends_legs(p)) {
      roles.bands.push_back(p);
    } else if (!is_gore(p)) {
      roles.trunk.push_back(p);
    }
  }
  return roles;
}

measure::BodySide side_of(const GarmentGraph& graph, const FlatLayout& layout, const ArmPieces& arms,
                          Index piece) {
  const auto as_side = [](double x) { return x >= 0 ? measure::kWearersLeft : measure::kWearersRight; };
  if (graph.pieces[piece].hand != 0) return as_side(graph.pieces[piece].hand);
  std::vector<Index> open{piece}, seen{piece};
  while (!open.empty()) {
    double x = 0;
    std::vector<Index> next;
    for (const GarmentTie& t : graph.ties) {
      for (const bool first : {true, false}) {
        const Index mine = first ? t.a : t.b, other = first ? t.b : t.a;
        if (std::find(open.begin(), open.end(), mine) == open.end()) continue;
        if (layout.has(other)) x += layout.pose[other](first ? t.at_b : t.at_a).x;
        if (std::find(seen.begin(), seen.end(), other) == seen.end() && !layout.has(other)) {
          next.push_back(other);
          seen.push_back(other);
        }
      }
    }
    if (x != 0) return as_side(x);
    open = std::move(next);
  }
  const auto count = [&](measure::BodySide s) { return arms.limb[s].size() + arms.tube[s].size(); };
  return count(measure::kWearersLeft) <= count(measure::kWearersRight) ? measure::kWearersLeft
                                                                       : measure::kWearersRight;
}

Result<ArrangePlan> plan_arrangement(const ArrangeInput& input, const BodyStand& stand) {
  ArrangePlan plan;
  plan.graph = make_garment_graph(input.pattern, input.meshes);
  cover_unnamed(plan.graph, input.absent, stand.waist_girth());
  plan.legs = leg_pieces(plan.graph);
  plan.roles = roles_of(plan.graph, plan.legs);
  FlatLayout layout = TRY(trunk_layout(plan.graph, plan.roles.trunk, stand));
  plan.layout = std::move(layout);
  plan.arms = arm_pieces_of(plan.graph, plan.roles.on_arms, plan.layout);
  plan.top = top_of(plan.graph, plan.roles.trunk, plan.layout);
  return plan;
}

}  // namespace toile::arrange
