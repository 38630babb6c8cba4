// Legs of one piece each, as leggings and pyjamas have: rolled around the leg, open between the legs, and the
// bands that end them.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/arrange/arranger.h"
#include "core/arrange/leg_piece.h"
#include "core/arrange/piece_cover.h"
#include "core/geometry/polygon2.h"

namespace toile::arrange {

namespace {

/// Of a circle, that a leg's piece covers where its inner seam closes: less would close it before the leg,
/// more would bring it between the legs.
constexpr double kLeastAtFork = 0.72, kLeastAtHem = 0.85, kMostOfLeg = 0.95;
constexpr double kOffTrunk = 0.02, kFromMiddle = 0.01, kForkLow = 0.037;  // m

constexpr double kSteepestLeg = 0.6;  // as WrappedPlacement::slope: shorts are hardly longer than wide

double sign_of(measure::BodySide side) { return side == measure::kWearersLeft ? 1 : -1; }

double radius_of(double around, double wanted, double least) {
  const double circle = around / (2 * std::numbers::pi);
  return std::clamp(wanted, circle / kMostOfLeg, circle / least);
}

/// How far from the axis the two edges of what covers that much of a circle of that radius lie inwards, m.
double inwards(double around, double radius) { return -radius * std::cos(around / (2 * radius)); }

}  // namespace

/// The trunk's middle and half depth between crotch and waist where a leg's piece goes on upwards, m.
std::array<double, 2> Arranger::depth_over_legs() const {
  const measure::BodyFigure& f = stand_.figure();
  constexpr double kHalf = 0.1;
  const std::vector<Vec2> there{{f.middle - kHalf, f.crotch},
                                {f.middle + kHalf, f.crotch},
                                {f.middle + kHalf, f.waist},
                                {f.middle - kHalf, f.waist}};
  const double front = stand_.reach(there, 1, 0), back = stand_.reach(there, -1, 0);
  return {(front + back) / 2, (front - back) / 2};
}

/// A cone that opens inwards: about the leg below, and above it as far out before and behind the trunk as its
/// half is deep.
sewing::WrappedPlacement Arranger::around_leg(Index p, const LegPiece& leg, double away) const {
  const measure::BodyFigure& f = stand_.figure();
  const measure::BodySide side = leg.side;
  const measure::LegLine& line = f.leg[side];
  const auto [middle, half] = depth_over_legs();
  const double calf = length(line.top - line.knee) * 0.15;
  const double at_fork = radius_of(leg.at_fork, half + kOffTrunk + away, kLeastAtFork);
  const double at_hem = radius_of(leg.at_hem, std::min(calf + away, at_fork), kLeastAtHem);
  const auto aside = [&](double x, double around, double radius) {
    return f.middle +
           sign_of(side) * std::max(sign_of(side) * (x - f.middle), inwards(around, radius) + kFromMiddle);
  };
  const double fork = f.crotch - kForkLow;
  const double share = std::min(1.0, leg.length / std::max(0.1, line.top.y - line.ankle.y));
  const Vec3 above{aside(line.top.x, leg.at_fork, at_fork), fork, middle};
  const Vec3 below{aside(line.top.x + (line.ankle.x - line.top.x) * share, leg.at_hem, at_hem),
                   fork - leg.length, middle + (line.ankle.z - middle) * share};
  sewing::WrappedPlacement w;
  w.axis = above;
  w.up = normalized(above - below);
  w.height = 0;
  w.radius = at_fork;
  w.slope = std::clamp((at_hem - at_fork) / leg.length, -kSteepestLeg, kSteepestLeg);
  w.angle = sign_of(side) * std::numbers::pi / 2;
  w.anchor = leg.fork;
  w.turn = std::numbers::pi / 2 - std::atan2(leg.up.y, leg.up.x);
  w.flipped = plan_.graph.pieces[p].outside < 0;
  return w;
}

std::vector<Arranger::Placed> Arranger::leg_places(const ArrangeTrial& trial) const {
  std::vector<Placed> places;
  for (const LegPiece& leg : plan_.legs)
    places.push_back({leg.piece, around_leg(leg.piece, leg, trial.away),
                      leg.side == measure::kWearersLeft ? "left leg, around it" : "right leg, around it"});
  return places;
}

/// Where the piece's stitches lie, in its plane, and what of those that are placed they are sewn to, m.
struct Arranger::Stitches {
  std::vector<Vec2> mine;
  std::vector<Vec3> there;
  std::vector<Index> hosts;

  Vec3 mean() const {
    Vec3 sum;
    for (const Vec3& q : there) sum += q * (1.0 / static_cast<double>(there.size()));
    return sum;
  }
};

Arranger::Stitches Arranger::stitches_to_legs(Index p, const std::vector<Placed>& placed) const {
  Stitches found;
  for (const Placed& leg : placed) {
    if (plan_.graph.pieces[leg.piece].cover != Cover::kLeg) continue;
    for (const GarmentTie& t : plan_.graph.ties) {
      if (!(t.a == p && t.b == leg.piece) && !(t.b == p && t.a == leg.piece)) continue;
      found.mine.push_back(t.a == p ? t.at_a : t.at_b);
      found.there.push_back(sewing::place({t.a == p ? t.at_b : t.at_a}, leg.placement).front());
      if (found.hosts.empty() || found.hosts.back() != leg.piece) found.hosts.push_back(leg.piece);
    }
  }
  return found;
}

/// The angle at which the strip's stitches stand nearest to those that they are sewn to, radians.
double Arranger::angle_to(const Stitches& stitches, const sewing::WrappedPlacement& w) {
  double sines = 0, cosines = 0;
  const double c = std::cos(w.turn), s = std::sin(w.turn);
  for (std::size_t i = 0; i < stitches.mine.size(); ++i) {
    const Vec2 d = stitches.mine[i] - w.anchor;
    const double along = (c * d.x - s * d.y) * (w.flipped ? -1 : 1);
    const Vec3 out = stitches.there[i] - w.axis;
    sines += std::sin(std::atan2(out.x, out.z) - along / w.radius);
    cosines += std::cos(std::atan2(out.x, out.z) - along / w.radius);
  }
  return std::atan2(sines, cosines);
}

/// A band that joins legs of one piece each goes around the trunk, above where they end.
std::optional<sewing::WrappedPlacement> Arranger::band_on_legs(Index p,
                                                               const std::vector<Placed>& legs) const {
  const Stitches stitches = stitches_to_legs(p, legs);
  if (stitches.hosts.size() < 2 || plan_.graph.pieces[p].cover == Cover::kCuff) return std::nullopt;
  sewing::WrappedPlacement w = band_at(p, stitches.mean().y);
  hang_by(stitches.mine, false, p, w);
  w.height += kSheetGap;
  w.angle = angle_to(stitches, w);
  return w;
}

/// A cuff closes about the ankle, however far down its leg ends: it is narrower than a foot.
std::optional<sewing::WrappedPlacement> Arranger::cuff_on_leg(Index p,
                                                              const std::vector<Placed>& placed) const {
  const GarmentPiece& piece = plan_.graph.pieces[p];
  if (piece.cover != Cover::kCuff || !piece.tube) return std::nullopt;
  const Stitches stitches = stitches_to_legs(p, placed);
  if (stitches.hosts.empty()) return std::nullopt;
  const Vec3 hem = stitches.mean();
  const measure::BodyFigure& f = stand_.figure();
  const measure::LegLine& leg = f.leg[hem.x > f.middle ? measure::kWearersLeft : measure::kWearersRight];
  const Vec2 size = bounding_box(piece.outline).size();
  sewing::WrappedPlacement w;
  w.axis = leg.ankle;
  w.up = normalized(leg.knee - leg.ankle);
  w.radius = radius_of(std::max(size.x, size.y), HUGE_VAL, kLeastAtHem);
  hang_by(stitches.mine, true, p, w);
  w.height = std::max(hem.y - kSheetGap - leg.ankle.y, std::min(size.x, size.y));
  w.angle = angle_to(stitches, w);
  return w;
}

}  // namespace toile::arrange
