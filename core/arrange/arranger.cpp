#include "core/arrange/arranger.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/arrange/layout_measures.h"
#include "core/arrange/piece_cover.h"
#include "core/arrange/sheet_placement.h"
#include "core/arrange/sleeve_places.h"
#include "core/geometry/polygon2.h"

namespace toile {

namespace {

constexpr double kUnder = 0.025;     ///< m, how far beside an outline the body still counts
constexpr double kSleeveOut = 0.03;  ///< m, sleeves begin beyond the arm's root
constexpr double kTopBand = 0.10;    ///< m, what lies that far under the top is the top edge
constexpr double kCrotchEase = 0.015, kMostSunk = 0.08;  // m
constexpr double kBelowCrotch = 0.022;                   // m
constexpr double kApart = 0.02;                          ///< m, between sheets that face one way

bool is_bottom(Cover c) { return c == Cover::kSkirt || c == Cover::kLeg || c == Cover::kWaistband; }

}  // namespace

Result<Arranger> Arranger::make(const ArrangeInput& input, const BodyStand& stand) {
  Arranger arranger(input, stand);
  arranger.graph_ = make_garment_graph(input.pattern, input.meshes);
  arranger.sort_pieces();
  arranger.layout_ = lay_out_trunk(arranger.graph_, arranger.trunk_);
  for (const Index p : arranger.trunk_) {
    if (arranger.layout_.has(p)) continue;
    return Error{
        "arrange.no_seams",
        "no seam leads from the other pieces to this one, so that nothing tells where it goes; sew it, or "
        "place it by hand",
        "piece " + arranger.graph_.pieces[p].id};
  }
  part_pieces(arranger.graph_, arranger.trunk_, kGap, arranger.layout_);
  arranger.set_legs_over_legs();
  part_pieces(arranger.graph_, arranger.trunk_, kGap, arranger.layout_);
  arranger.top_ = -HUGE_VAL;
  for (const Index p : arranger.trunk_) {
    for (const Vec2 q : outline_on_sheet(arranger.graph_.pieces[p], arranger.layout_.pose[p])) {
      arranger.top_ = std::max(arranger.top_, q.y);
    }
  }
  for (const Index p : arranger.on_arms_) {
    auto& kind = arranger.graph_.pieces[p].tube ? arranger.tube_ : arranger.limb_;
    kind[arranger.side_of(p)].push_back(p);
  }
  return arranger;
}

void Arranger::sort_pieces() {
  const auto sewn_to_sleeve = [&](Index p) {
    return std::any_of(graph_.ties.begin(), graph_.ties.end(), [&](const GarmentTie& t) {
      const Index other = t.a == p ? t.b : t.b == p ? t.a : kNone;
      return other != kNone && other != p && graph_.pieces[other].cover == Cover::kSleeve;
    });
  };
  for (Index p = 0; p < static_cast<Index>(graph_.pieces.size()); ++p) {
    const GarmentPiece& piece = graph_.pieces[p];
    if (piece.cover == Cover::kSleeve || (piece.cover == Cover::kCuff && sewn_to_sleeve(p))) {
      on_arms_.push_back(p);
    } else if (piece.cover == Cover::kHood) {
      hoods_.push_back(p);
    } else if (piece.tube) {
      bands_.push_back(p);
    } else {
      trunk_.push_back(p);
    }
  }
}

/// By its name, by where on the trunk it is sewn, or as what it is sewn to.
BodySide Arranger::side_of(Index piece) const {
  const auto as_side = [](double x) { return x >= 0 ? kWearersLeft : kWearersRight; };
  if (graph_.pieces[piece].hand != 0) return as_side(graph_.pieces[piece].hand);
  std::vector<Index> open{piece}, seen{piece};
  while (!open.empty()) {
    double x = 0;
    std::vector<Index> next;
    for (const GarmentTie& t : graph_.ties) {
      for (const bool first : {true, false}) {
        const Index mine = first ? t.a : t.b, other = first ? t.b : t.a;
        if (std::find(open.begin(), open.end(), mine) == open.end()) continue;
        if (layout_.has(other)) x += layout_.pose[other](first ? t.at_b : t.at_a).x;
        if (std::find(seen.begin(), seen.end(), other) == seen.end() && !layout_.has(other)) {
          next.push_back(other);
          seen.push_back(other);
        }
      }
    }
    if (x != 0) return as_side(x);
    open = std::move(next);
  }
  // Nothing tells: the side that has fewer.
  const auto count = [&](BodySide s) { return limb_[s].size() + tube_[s].size(); };
  return count(kWearersLeft) <= count(kWearersRight) ? kWearersLeft : kWearersRight;
}

bool Arranger::is_top() const {
  return std::any_of(trunk_.begin(), trunk_.end(),
                     [&](Index p) { return !is_bottom(graph_.pieces[p].cover); });
}

std::vector<ArrangeTrial> Arranger::trials() const {
  if (!is_top()) return {{0, 0, 0}, {0, 0, 0.04}};
  std::vector<ArrangeTrial> trials;
  for (int cm = 0; cm < 10; ++cm) trials.push_back({0.01 * cm, 0, 0});
  for (const double lower : {0.03, 0.06, 0.09}) trials.push_back({lower, 0.05, 0.03});
  return trials;
}

/// What is added to heights on the sheet.
double Arranger::rise_of_trunk(const ArrangeTrial& trial) const {
  return is_top() ? rise_of_top() - trial.lower : rise_of_bottom();
}

/// The highest stitches between fronts and backs come to the neck's sides.
double Arranger::rise_of_top() const {
  double highest = -HUGE_VAL;
  for (const GarmentTie& t : graph_.ties) {
    if (!layout_.has(t.a) || !layout_.has(t.b) || layout_.face[t.a] == layout_.face[t.b]) continue;
    highest = std::max({highest, layout_.pose[t.a](t.at_a).y, layout_.pose[t.b](t.at_b).y});
  }
  if (highest == -HUGE_VAL) highest = top_;
  return stand_.figure().neck_side[0].y + 0.005 - highest;
}

bool Arranger::is_top_segment(Index piece, std::size_t i) const {
  const GarmentPiece& p = graph_.pieces[piece];
  const std::size_t j = (i + 1) % p.outline.size();
  if (p.sewn[i] && p.sewn[j]) return false;
  const Vec2 a = layout_.pose[piece](p.outline[i]), b = layout_.pose[piece](p.outline[j]);
  return (a.y + b.y) / 2 > top_ - kTopBand && std::abs(b.x - a.x) > std::abs(b.y - a.y);
}

std::array<double, 2> Arranger::top_edge() const {
  double total = 0, moment = 0;
  for (const Index piece : trunk_) {
    const GarmentPiece& p = graph_.pieces[piece];
    for (std::size_t i = 0; i < p.outline.size(); ++i) {
      if (!is_top_segment(piece, i)) continue;
      const Vec2 a = layout_.pose[piece](p.outline[i]),
                 b = layout_.pose[piece](p.outline[(i + 1) % p.outline.size()]);
      total += length(b - a);
      moment += length(b - a) * (a.y + b.y) / 2;
    }
  }
  return {total, total > 0 ? moment / total : top_};
}

/// Where the inner leg seams begin on the sheet; nothing where there are none.
std::optional<double> Arranger::crotch_on_sheet() const {
  std::optional<double> highest;
  for (const GarmentTie& t : graph_.ties) {
    if (!layout_.has(t.a) || !layout_.has(t.b) || layout_.face[t.a] == layout_.face[t.b]) continue;
    if (graph_.pieces[t.a].cover != Cover::kLeg || graph_.pieces[t.b].cover != Cover::kLeg) continue;
    const Vec2 at = layout_.pose[t.a](t.at_a);
    const bool inner = std::abs(at.x) < std::abs(layout_.pose[t.a](graph_.pieces[t.a].centroid).x);
    if (inner && (!highest || at.y > *highest)) highest = at.y;
  }
  return highest;
}

/// The upper edge sits where the trunk is as wide as it is. Trousers come up to the crotch even so, as far as
/// the waist allows, and never over it: their inner seams close between the legs.
double Arranger::rise_of_bottom() const {
  const auto [girth, edge] = top_edge();
  const double height = bands_.empty() ? edge : top_;
  constexpr double kOver = 0.01;  // the edge lies a finger over the girth that it fits
  double rise = stand_.height_of_ring(girth) + kOver - height;
  if (const auto crotch = crotch_on_sheet()) {
    const double closing = stand_.figure().crotch - kBelowCrotch - *crotch;
    rise = std::max(rise, std::min(closing - kCrotchEase, stand_.figure().waist + kOver - height));
    rise = std::max(std::min(rise, closing), rise - kMostSunk);
  }
  return rise;
}

double Arranger::sheet_depth(int face, double rise, const ArrangeTrial& trial) const {
  double most = -HUGE_VAL;
  for (const Index p : trunk_) {
    if (layout_.face[p] != face) continue;
    FlatMove pose = layout_.pose[p];
    pose.t = pose.t + Vec2{stand_.figure().middle, rise};
    most = std::max(most, face * stand_.reach(outline_on_sheet(graph_.pieces[p], pose), face, kUnder));
  }
  return face * (most + kAway + trial.away);
}

void Arranger::place_trunk(const ArrangeTrial& trial, double rise, Arrangement& made) const {
  const double front = sheet_depth(1, rise, trial), back = sheet_depth(-1, rise, trial);
  for (const Index p : trunk_) {
    FlatMove pose = layout_.pose[p];
    pose.t = pose.t + Vec2{stand_.figure().middle, rise};
    put(made, p, on_upright_sheet(pose, layout_.face[p] > 0 ? front : back),
        std::string(name_of(graph_.pieces[p].cover)) + (layout_.face[p] > 0 ? ", front" : ", back"));
  }
}

/// The pieces along an arm, `out` (m) beyond its root; without a sleeve among them nothing is laid out.
FlatLayout Arranger::lay_limb(BodySide side, double out) const {
  const std::vector<Index>& limb = limb_[side];
  const ArmLine& arm = stand_.figure().arm[side];
  FlatLayout flat = empty_layout(graph_.pieces.size());
  // Each half that names its face or its side of the trunk lies along the arm; others follow by their seams.
  Index root = kNone;
  for (const Index p : limb) {
    const GarmentPiece& piece = graph_.pieces[p];
    if (piece.cover != Cover::kSleeve) continue;
    if (root == kNone || (piece.face > 0 && graph_.pieces[root].face <= 0)) root = p;
  }
  if (root == kNone) return flat;
  const int face = graph_.pieces[root].face < 0 ? -1 : 1;
  const SleeveLine line = line_of_sleeve(graph_, root, limb);
  lay_out_limb(graph_, limb, root, sleeve_pose(line, arm, out, graph_.pieces[root].outside * face < 0), face,
               flat);
  for (const Index p : limb) {
    if (p == root || !flat.has(p) || graph_.pieces[p].cover != Cover::kSleeve) continue;
    flat.pose[p] =
        sleeve_pose(line_of_sleeve(graph_, p, limb), arm, out, graph_.pieces[p].outside * flat.face[p] < 0);
  }
  part_pieces(graph_, limb, kGap, flat);
  return flat;
}

/// Whether a piece of the limb lies before or behind one of the trunk's that looks the same way.
bool Arranger::covers_trunk(const FlatLayout& flat, double rise) const {
  const auto meets = [](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    return std::any_of(a.begin(), a.end(), [&](Vec2 p) { return contains(b, p); });
  };
  for (Index p = 0; p < static_cast<Index>(graph_.pieces.size()); ++p) {
    if (!flat.has(p)) continue;
    const std::vector<Vec2> sleeve = outline_on_sheet(graph_.pieces[p], flat.pose[p]);
    for (const Index q : trunk_) {
      if (layout_.face[q] != flat.face[p]) continue;
      FlatMove pose = layout_.pose[q];
      pose.t = pose.t + Vec2{stand_.figure().middle, rise};
      const std::vector<Vec2> piece = outline_on_sheet(graph_.pieces[q], pose);
      if (meets(sleeve, piece) || meets(piece, sleeve)) return true;
    }
  }
  return false;
}

void Arranger::place_limb(BodySide side, const ArrangeTrial& trial, double rise, Arrangement& made) const {
  const std::vector<Index>& limb = limb_[side];
  const std::string hand = side == kWearersLeft ? "left " : "right ";
  // A wide sleeve's lower corner would start under the trunk's piece, with that edge in its way.
  constexpr double kStep = 0.01, kFarthest = 0.1, kLap = 0.02;
  const double out = kSleeveOut + trial.sleeve_out;
  double more = 0;
  while (more < kFarthest && covers_trunk(lay_limb(side, out + more + kLap), rise)) more += kStep;
  const FlatLayout flat = lay_limb(side, out + more);
  for (const int f : {1, -1}) {
    double most = -HUGE_VAL;
    for (const Index p : limb) {
      if (flat.face[p] == f)
        most = std::max(most, f * stand_.reach(outline_on_sheet(graph_.pieces[p], flat.pose[p]), f, kUnder));
    }
    double z = most + kAway + trial.away;
    const double trunk = f * sheet_depth(f, rise, trial);
    if (std::abs(z - trunk) < kApart) z = trunk + kApart;
    for (const Index p : limb) {
      if (flat.face[p] != f) continue;
      put(made, p, on_upright_sheet(flat.pose[p], f * z),
          hand + name_of(graph_.pieces[p].cover) + (f > 0 ? ", before the arm" : ", behind the arm"));
    }
  }
}

void Arranger::place_tube_sleeve(Index piece, BodySide side, const ArrangeTrial& trial,
                                 Arrangement& made) const {
  const ArmLine& arm = stand_.figure().arm[side];
  const SleeveLine line = line_of_sleeve(graph_, piece, {piece});
  const double radius = std::max(1.1 * line.breadth, 1.6 * arm.girth) / (2 * std::numbers::pi);
  const auto rolled = [&](bool flipped) {
    return around_arm(line, arm, side, radius, kSleeveOut + trial.sleeve_out, flipped);
  };
  // The cap's front belongs before the arm, whatever side of the cloth that turns out.
  double fits[2] = {0, 0};
  for (const bool flipped : {false, true}) {
    for (const GarmentTie& t : graph_.ties) {
      if (t.a == t.b || (t.a != piece && t.b != piece)) continue;
      const Index other = t.a == piece ? t.b : t.a;
      if (!layout_.has(other)) continue;
      const Vec3 p = toile::place({t.a == piece ? t.at_a : t.at_b}, rolled(flipped))[0];
      fits[flipped] += layout_.face[other] * (p.z - arm.root.z);
    }
  }
  const bool as_told = graph_.pieces[piece].outside < 0;
  const bool flipped = std::abs(fits[0] - fits[1]) > 1e-9 ? fits[1] > fits[0] : as_told;
  put(made, piece, rolled(flipped),
      (side == kWearersLeft ? "left sleeve, around the arm" : "right sleeve, around the arm"));
}

Vec2 Arranger::mean_tie_on_trunk(Index piece, bool& any) const {
  Vec2 sum;
  int count = 0;
  for (const GarmentTie& t : graph_.ties) {
    const Index other = t.a == piece ? t.b : t.b == piece ? t.a : kNone;
    if (other == kNone || other == piece || !layout_.has(other)) continue;
    sum = sum + layout_.pose[other](t.a == piece ? t.at_b : t.at_a);
    ++count;
  }
  any = count > 0;
  return any ? sum * (1.0 / count) : sum;
}

/// A skirt or trousers stay at their height until gravity is full and friction carries them.
void Arranger::hold_bottoms(Arrangement& made) const {
  if (is_top()) return;
  const bool banded = std::any_of(graph_.pieces.begin(), graph_.pieces.end(),
                                  [](const GarmentPiece& p) { return p.cover == Cover::kWaistband; });
  for (Index p = 0; p < static_cast<Index>(graph_.pieces.size()); ++p) {
    const GarmentPiece& piece = graph_.pieces[p];
    Attachment hold;
    hold.id = "hold_" + piece.id;
    hold.panel = p;
    hold.hold = Attachment::Hold::kHeight;
    if (banded) {
      if (piece.cover == Cover::kWaistband) made.attachments.push_back(std::move(hold));
      continue;
    }
    if (!layout_.has(p)) continue;
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      if (is_top_segment(p, i)) hold.edges.push_back(piece.edge_of[i]);
    }
    std::sort(hold.edges.begin(), hold.edges.end());
    hold.edges.erase(std::unique(hold.edges.begin(), hold.edges.end()), hold.edges.end());
    if (!hold.edges.empty()) made.attachments.push_back(std::move(hold));
  }
}

void Arranger::put(Arrangement& made, Index piece, const Placement& placement, std::string where) {
  made.placements[piece] = placement;
  made.pieces[piece].where = std::move(where);
}

Arrangement Arranger::place(const ArrangeTrial& trial) const {
  Arrangement made;
  made.placements.assign(graph_.pieces.size(), RigidPlacement{});
  for (const GarmentPiece& p : graph_.pieces) made.pieces.push_back({p.id, ""});
  const double rise = trunk_.empty() ? 0 : rise_of_trunk(trial);
  place_trunk(trial, rise, made);
  for (const BodySide side : {kWearersLeft, kWearersRight}) {
    place_limb(side, trial, rise, made);
    for (const Index p : tube_[side]) place_tube_sleeve(p, side, trial, made);
  }
  place_hoods(rise, made);
  place_bands(rise, made);
  hold_bottoms(made);
  return made;
}

}  // namespace toile
