#include "core/arrange/arranger.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/arrange/layout_measures.h"
#include "core/arrange/piece_cover.h"
#include "core/arrange/sheet_placement.h"
#include "core/arrange/sleeve_places.h"
#include "core/geometry/polygon2.h"

namespace toile::arrange {

namespace {

constexpr double kUnder = 0.025;     ///< m, how far beside an outline the body still counts
constexpr double kSleeveOut = 0.03;  ///< m, sleeves begin beyond the arm's root
constexpr double kTopBand = 0.10;    ///< m, what lies that far under the top is the top edge
constexpr double kCrotchEase = 0.015, kMostSunk = 0.08;  // m
constexpr double kBelowCrotch = 0.022;                   // m
constexpr double kOverNeck = 0.005;                      // m
constexpr double kShoulderLow = 0.12;  // m, how far shoulder seams may lie below the highest stitches
constexpr double kCollarAway = 0.04;   ///< m, before what they are sewn to
constexpr double kCuffAway = 0.06;     ///< m, of the right leg's: the left one's lies between
constexpr double kOverHand = 0.06;     ///< m, beyond the wrist, where a cuff ends at most
constexpr double kApart = 0.02;        ///< m, between sheets that face one way

/// Cuffs among the trunk's pieces are those of legs.
bool is_bottom(Cover c) {
  return c == Cover::kSkirt || c == Cover::kLeg || c == Cover::kWaistband || c == Cover::kCuff;
}

/// The stitches of one seam on the sheets.
struct SeamRun {
  double low = HUGE_VAL, high = -HUGE_VAL, left = HUGE_VAL, right = -HUGE_VAL;
  void take(Vec2 p) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  /// As shoulder seams do; side seams run downwards.
  bool across() const { return right - left > 0.5 * (high - low); }
};

}  // namespace

Result<Arranger> Arranger::make(const ArrangeInput& input, const BodyStand& stand) {
  ArrangePlan plan = TRY(plan_arrangement(input, stand));
  return Arranger(std::move(plan), stand);
}

bool Arranger::is_top() const {
  return std::any_of(plan_.roles.trunk.begin(), plan_.roles.trunk.end(),
                     [&](Index p) { return !is_bottom(plan_.graph.pieces[p].cover); });
}

std::vector<ArrangeTrial> Arranger::trials() const {
  if (!is_top()) return {{0, 0, 0}, {0, 0, 0.04}};
  std::vector<ArrangeTrial> trials;
  trials.reserve(13);
  for (int cm = 0; cm < 10; ++cm) trials.push_back({0.01 * cm, 0, 0});
  for (const double lower : {0.03, 0.06, 0.09}) trials.push_back({lower, 0.05, 0.03});
  return trials;
}

/// What is added to heights on the sheet.
double Arranger::rise_of_trunk(const ArrangeTrial& trial) const {
  return is_top() ? rise_of_top() - trial.lower : rise_of_bottom();
}

/// The highest stitches between fronts and backs come to the neck's sides; without shoulders, what has legs
/// is held by its crotch, as dungarees are, and all else ends its sides below the arms.
double Arranger::rise_of_top() const {
  std::map<std::array<Index, 3>, SeamRun> runs;  // by seam and pieces: one name may be sewn on both sides
  for (const GarmentTie& t : plan_.graph.ties) {
    if (!plan_.layout.has(t.a) || !plan_.layout.has(t.b) || plan_.layout.face[t.a] == plan_.layout.face[t.b])
      continue;
    if (plan_.graph.pieces[t.a].strap || plan_.graph.pieces[t.b].strap)
      continue;  // it comes over the shoulder
    SeamRun& run = runs[{t.seam, t.a, t.b}];
    run.take(plan_.layout.pose[t.a](t.at_a));
    run.take(plan_.layout.pose[t.b](t.at_b));
  }
  double highest = -HUGE_VAL, shoulder = -HUGE_VAL;
  for (const auto& [seam, run] : runs) {
    highest = std::max(highest, run.high);
    if (run.across()) shoulder = std::max(shoulder, run.high);
  }
  const measure::BodyFigure& f = stand_.figure();
  if (highest == -HUGE_VAL) return f.neck_side[0].y + kOverNeck - plan_.top;
  if (shoulder < highest - kShoulderLow) {
    const std::optional<double> crotch = crotch_on_sheet();
    return crotch ? f.crotch - kBelowCrotch - kCrotchEase - *crotch : f.armpit[0].y - kBelowArmpit - highest;
  }
  return f.neck_side[0].y + kOverNeck - highest;
}

bool Arranger::is_top_segment(Index piece, std::size_t i) const {
  const GarmentPiece& p = plan_.graph.pieces[piece];
  const std::size_t j = (i + 1) % p.outline.size();
  if (p.sewn[i] && p.sewn[j]) return false;
  const Vec2 a = plan_.layout.pose[piece](p.outline[i]), b = plan_.layout.pose[piece](p.outline[j]);
  return (a.y + b.y) / 2 > plan_.top - kTopBand && std::abs(b.x - a.x) > std::abs(b.y - a.y);
}

/// A leg of one piece ends above its fork.
bool Arranger::is_top_of_leg(Index piece, std::size_t i) const {
  const auto leg =
      std::find_if(plan_.legs.begin(), plan_.legs.end(), [&](const LegPiece& l) { return l.piece == piece; });
  if (leg == plan_.legs.end()) return false;
  const GarmentPiece& p = plan_.graph.pieces[piece];
  const std::size_t j = (i + 1) % p.outline.size();
  if (p.sewn[i] && p.sewn[j]) return false;
  return dot((p.outline[i] + p.outline[j]) * 0.5 - leg->fork, leg->up) > 0;
}

std::array<double, 2> Arranger::top_edge() const {
  double total = 0, moment = 0;
  for (const Index piece : plan_.roles.trunk) {
    const GarmentPiece& p = plan_.graph.pieces[piece];
    for (std::size_t i = 0; i < p.outline.size(); ++i) {
      if (!is_top_segment(piece, i)) continue;
      const Vec2 a = plan_.layout.pose[piece](p.outline[i]),
                 b = plan_.layout.pose[piece](p.outline[(i + 1) % p.outline.size()]);
      total += length(b - a);
      moment += length(b - a) * (a.y + b.y) / 2;
    }
  }
  return {total, total > 0 ? moment / total : plan_.top};
}

/// Where the inner leg seams begin on the sheet; nothing where there are none.
std::optional<double> Arranger::crotch_on_sheet() const {
  std::optional<double> highest;
  for (const GarmentTie& t : plan_.graph.ties) {
    if (!plan_.layout.has(t.a) || !plan_.layout.has(t.b) || plan_.layout.face[t.a] == plan_.layout.face[t.b])
      continue;
    if (plan_.graph.pieces[t.a].cover != Cover::kLeg || plan_.graph.pieces[t.b].cover != Cover::kLeg)
      continue;
    const Vec2 at = plan_.layout.pose[t.a](t.at_a);
    const bool inner = std::abs(at.x) < std::abs(plan_.layout.pose[t.a](plan_.graph.pieces[t.a].centroid).x);
    if (inner && (!highest || at.y > *highest)) highest = at.y;
  }
  return highest;
}

/// The upper edge sits where the trunk is as wide as it is. Trousers come up to the crotch even so, as far as
/// the waist allows, and never over it: their inner seams close between the legs.
double Arranger::rise_of_bottom() const {
  const auto [girth, edge] = top_edge();
  const double height = plan_.roles.bands.empty() ? edge : plan_.top;
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
  for (const Index p : plan_.roles.trunk) {
    if (plan_.layout.face[p] != face) continue;
    FlatMove pose = plan_.layout.pose[p];
    pose.t = pose.t + Vec2{stand_.figure().middle, rise};
    most = std::max(most, face * stand_.reach(outline_on_sheet(plan_.graph.pieces[p], pose), face, kUnder));
  }
  return face * (most + kAway + trial.away);
}

std::vector<Arranger::Placed> Arranger::trunk_places(const ArrangeTrial& trial, double rise) const {
  std::vector<Placed> places;
  const double front = sheet_depth(1, rise, trial), back = sheet_depth(-1, rise, trial);
  for (const Index p : plan_.roles.trunk) {
    FlatMove pose = plan_.layout.pose[p];
    pose.t = pose.t + Vec2{stand_.figure().middle, rise};
    double depth = plan_.layout.face[p] > 0 ? front : back;
    if (plan_.graph.pieces[p].cover == Cover::kCollar) depth += plan_.layout.face[p] * kCollarAway;
    if (plan_.graph.pieces[p].cover == Cover::kCuff)
      depth += plan_.layout.face[p] *
               (pose(plan_.graph.pieces[p].centroid).x > stand_.figure().middle ? kCollarAway : kCuffAway);
    places.push_back({p, on_upright_sheet(pose, depth),
                      std::string(name_of(plan_.graph.pieces[p].cover)) +
                          (plan_.layout.face[p] > 0 ? ", front" : ", back")});
  }
  return places;
}

/// The pieces along an arm, `out` (m) beyond its root; without a sleeve among them nothing is laid out.
FlatLayout Arranger::lay_limb(measure::BodySide side, double out) const {
  const std::vector<Index>& limb = plan_.arms.limb[side];
  const measure::ArmLine& arm = stand_.figure().arm[side];
  FlatLayout flat = empty_layout(plan_.graph.pieces.size());
  // Each half that names its face or its side of the trunk lies along the arm; others follow by their seams.
  Index root = kNone;
  for (const Index p : limb) {
    const GarmentPiece& piece = plan_.graph.pieces[p];
    if (piece.cover != Cover::kSleeve) continue;
    if (root == kNone || (piece.face > 0 && plan_.graph.pieces[root].face <= 0)) root = p;
  }
  if (root == kNone) return flat;
  const int face = plan_.graph.pieces[root].face < 0 ? -1 : 1;
  const SleeveLine line = line_of_sleeve(plan_.graph, root, limb);
  lay_out_limb(plan_.graph, limb, root,
               sleeve_pose(line, arm, out, plan_.graph.pieces[root].outside * face < 0), face, flat);
  for (const Index p : limb) {
    if (p == root || !flat.has(p) || plan_.graph.pieces[p].cover != Cover::kSleeve) continue;
    flat.pose[p] = sleeve_pose(line_of_sleeve(plan_.graph, p, limb), arm, out,
                               plan_.graph.pieces[p].outside * flat.face[p] < 0);
  }
  part_pieces(plan_.graph, limb, kSheetGap, flat);
  return flat;
}

/// Whether a piece of the limb lies before or behind one of the trunk's that looks the same way.
bool Arranger::covers_trunk(const FlatLayout& flat, double rise) const {
  const auto meets = [](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    return std::any_of(a.begin(), a.end(), [&](Vec2 p) { return geometry::contains(b, p); });
  };
  for (Index p = 0; p < static_cast<Index>(plan_.graph.pieces.size()); ++p) {
    if (!flat.has(p)) continue;
    const std::vector<Vec2> sleeve = outline_on_sheet(plan_.graph.pieces[p], flat.pose[p]);
    for (const Index q : plan_.roles.trunk) {
      if (plan_.layout.face[q] != flat.face[p]) continue;
      FlatMove pose = plan_.layout.pose[q];
      pose.t = pose.t + Vec2{stand_.figure().middle, rise};
      const std::vector<Vec2> piece = outline_on_sheet(plan_.graph.pieces[q], pose);
      if (meets(sleeve, piece) || meets(piece, sleeve)) return true;
    }
  }
  return false;
}

std::vector<Arranger::Placed> Arranger::limb_places(measure::BodySide side, const ArrangeTrial& trial,
                                                    double rise) const {
  std::vector<Placed> places;
  const std::vector<Index>& limb = plan_.arms.limb[side];
  const std::string hand = side == measure::kWearersLeft ? "left " : "right ";
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
        most = std::max(most,
                        f * stand_.reach(outline_on_sheet(plan_.graph.pieces[p], flat.pose[p]), f, kUnder));
    }
    double z = most + kAway + trial.away;
    const double trunk = f * sheet_depth(f, rise, trial);
    if (std::abs(z - trunk) < kApart) z = trunk + kApart;
    for (const Index p : limb) {
      if (flat.face[p] != f) continue;
      places.push_back(
          {p, on_upright_sheet(flat.pose[p], f * z),
           hand + name_of(plan_.graph.pieces[p].cover) + (f > 0 ? ", before the arm" : ", behind the arm")});
    }
  }
  return places;
}

/// What of an arm a piece hangs from, with the stitches of both: cuffs from sleeves. Nothing where it hangs
/// from the trunk itself.
struct Arranger::Hanging {
  Index from = kNone;
  std::vector<Vec2> mine, there;  ///< m
};

std::optional<Arranger::Hanging> Arranger::hanging_on_arm(Index piece) const {
  const std::vector<int> steps = steps_from_trunk();
  std::optional<Hanging> found;
  for (const GarmentTie& t : plan_.graph.ties) {
    if (t.a != piece && t.b != piece) continue;
    const bool first = t.a == piece;
    const Index other = first ? t.b : t.a;
    if (steps[other] < 1 || steps[other] >= steps[piece] || (found && found->from != other)) continue;
    if (!found) found = Hanging{other, {}, {}};
    found->mine.push_back(first ? t.at_a : t.at_b);
    found->there.push_back(first ? t.at_b : t.at_a);
  }
  return found;
}

/// How many pieces it is from each to the trunk; of what no seam leads to, more than there are.
std::vector<int> Arranger::steps_from_trunk() const {
  const int never = static_cast<int>(plan_.graph.pieces.size());
  std::vector<int> steps(plan_.graph.pieces.size(), never);
  for (Index p = 0; p < never; ++p)
    if (plan_.layout.has(p)) steps[p] = 0;
  for (bool more = true; more;) {
    more = false;
    for (const GarmentTie& t : plan_.graph.ties)
      for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.a}}) {
        if (steps[from] + 1 >= steps[to]) continue;
        steps[to] = steps[from] + 1;
        more = true;
      }
  }
  return steps;
}

/// How far out along the arm a tube begins, m: what hangs from another one where that ends.
double Arranger::out_of_tube(Index piece, const SleeveLine& line, measure::BodySide side, double out) const {
  const std::optional<Hanging> hanging = hanging_on_arm(piece);
  if (!hanging) return out;
  const SleeveLine host = line_of_sleeve(plan_.graph, hanging->from, {hanging->from});
  const double begin = out_of_tube(hanging->from, host, side, out);
  const double end = std::max(0.0, dot(mean_of(hanging->there) - host.begin, host.along));
  const double beyond = begin + end + kSheetGap - dot(mean_of(hanging->mine) - line.begin, line.along);
  const GarmentPiece& p = plan_.graph.pieces[piece];
  if (p.cover != Cover::kCuff) return beyond;
  // A cuff is narrower than a hand, so that it closes about the wrist however far out its sleeve begins.
  const measure::ArmLine& arm = stand_.figure().arm[side];
  double low = -HUGE_VAL;
  for (const Vec2 q : p.outline) low = std::max(low, dot(q - line.begin, line.along));
  return std::min(beyond, length(arm.wrist - arm.root) + kOverHand - low);
}

Arranger::Placed Arranger::tube_place(Index piece, measure::BodySide side, const ArrangeTrial& trial) const {
  const measure::ArmLine& arm = stand_.figure().arm[side];
  const SleeveLine line = line_of_sleeve(plan_.graph, piece, {piece});
  const double out = out_of_tube(piece, line, side, kSleeveOut + trial.sleeve_out);
  // What covers less of the circle would close beside the arm: narrow cuffs, which are for the wrist.
  const double around = std::max(1.1 * line.breadth, 1.6 * arm.girth);
  const double least = hanging_on_arm(piece) ? 0 : 1.2 * arm.girth;
  const double radius =
      std::max(least, std::min(around, line.breadth / kLeastAround)) / (2 * std::numbers::pi);
  const auto rolled = [&](bool flipped) { return around_arm(line, arm, side, radius, out, flipped); };
  // The cap's front belongs before the arm, whatever side of the cloth that turns out.
  double fits[2] = {0, 0};
  for (const bool flipped : {false, true}) {
    for (const GarmentTie& t : plan_.graph.ties) {
      if (t.a == t.b || (t.a != piece && t.b != piece)) continue;
      const Index other = t.a == piece ? t.b : t.a;
      if (!plan_.layout.has(other)) continue;
      const Vec3 p = toile::sewing::place({t.a == piece ? t.at_a : t.at_b}, rolled(flipped))[0];
      fits[flipped] += plan_.layout.face[other] * (p.z - arm.root.z);
    }
  }
  const bool as_told = plan_.graph.pieces[piece].outside < 0;
  const bool flipped = std::abs(fits[0] - fits[1]) > 1e-9 ? fits[1] > fits[0] : as_told;
  return {piece, rolled(flipped),
          side == measure::kWearersLeft ? "left sleeve, around the arm" : "right sleeve, around the arm"};
}

/// On the sheet; nothing for a piece that is not sewn to the trunk.
std::optional<Vec2> Arranger::mean_tie_on_trunk(Index piece) const {
  Vec2 sum;
  int count = 0;
  for (const GarmentTie& t : plan_.graph.ties) {
    const Index other = t.a == piece ? t.b : t.b == piece ? t.a : kNone;
    if (other == kNone || other == piece || !plan_.layout.has(other) || !tells_of_band(piece, other))
      continue;
    sum = sum + plan_.layout.pose[other](t.a == piece ? t.at_b : t.at_a);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum * (1.0 / count);
}

/// A skirt or trousers stay at their height until gravity is full and friction carries them.
std::vector<sewing::Attachment> Arranger::holds() const {
  std::vector<sewing::Attachment> holds;
  if (is_top()) return holds;
  const bool banded = std::any_of(plan_.graph.pieces.begin(), plan_.graph.pieces.end(),
                                  [](const GarmentPiece& p) { return p.cover == Cover::kWaistband; });
  for (Index p = 0; p < static_cast<Index>(plan_.graph.pieces.size()); ++p) {
    const GarmentPiece& piece = plan_.graph.pieces[p];
    sewing::Attachment hold;
    hold.id = "hold_" + piece.id;
    hold.panel = p;
    hold.hold = sewing::Attachment::Hold::kHeight;
    if (banded) {
      if (piece.cover == Cover::kWaistband) holds.push_back(std::move(hold));
      continue;
    }
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      if (plan_.layout.has(p) ? is_top_segment(p, i) : is_top_of_leg(p, i))
        hold.edges.push_back(piece.edge_of[i]);
    }
    std::sort(hold.edges.begin(), hold.edges.end());
    hold.edges.erase(std::unique(hold.edges.begin(), hold.edges.end()), hold.edges.end());
    if (!hold.edges.empty()) holds.push_back(std::move(hold));
  }
  return holds;
}

Arrangement Arranger::place(const ArrangeTrial& trial) const {
  Arrangement made;
  made.placements.assign(plan_.graph.pieces.size(), sewing::RigidPlacement{});
  for (const GarmentPiece& p : plan_.graph.pieces) made.pieces.push_back({p.id, ""});
  const auto take = [&](std::vector<Placed> places) {
    for (Placed& placed : places) {
      made.placements[placed.piece] = placed.placement;
      made.pieces[placed.piece].where = std::move(placed.where);
    }
  };
  const double rise = plan_.roles.trunk.empty() ? 0 : rise_of_trunk(trial);
  const std::vector<Placed> trunk = trunk_places(trial, rise);
  take(trunk);
  for (const measure::BodySide side : {measure::kWearersLeft, measure::kWearersRight}) {
    take(limb_places(side, trial, rise));
    for (const Index p : plan_.arms.tube[side]) take({tube_place(p, side, trial)});
    for (const Index p : plan_.arms.limb[side])  // no flat sleeve to lie beside
      if (made.pieces[p].where.empty()) take({tube_place(p, side, trial)});
  }
  take(hood_places(rise));
  const std::vector<Placed> legs = leg_places(trial);
  take(legs);
  take(band_places(rise, legs, trunk));
  take(gore_places(rise));
  made.attachments = holds();
  return made;
}

}  // namespace toile::arrange
