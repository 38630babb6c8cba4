// Hoods, the strips that go around trunk and neck, and rings of gores.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/arrange/arranger.h"
#include "core/arrange/piece_cover.h"
#include "core/arrange/roll.h"
#include "core/arrange/sheet_placement.h"
#include "core/geometry/polygon2.h"

namespace toile::arrange {

namespace {

/// Whether the band is sewn to a top alone, whose hem it is then.
bool ends_top(const GarmentGraph& graph, Index band) {
  if (graph.pieces[band].cover != Cover::kWaistband) return false;
  bool any = false;
  for (const GarmentTie& t : graph.ties) {
    if (t.a == t.b || (t.a != band && t.b != band)) continue;
    if (graph.pieces[t.a == band ? t.b : t.a].cover != Cover::kTorso) return false;
    any = true;
  }
  return any;
}

/// What a piece that is sewn to itself rolls up to.
std::optional<Roll> own_roll(const GarmentGraph& graph, Index p) {
  std::vector<std::array<Vec2, 2>> seam;
  for (const GarmentTie& t : graph.ties)
    if (t.a == p && t.b == p) seam.push_back({t.at_a, t.at_b});
  return roll_of(std::move(seam), graph.pieces[p].centroid, graph.pieces[p].grain);
}

constexpr double kClose = 0.012;  // m, strips lie nearer than sheets, so that their ends meet
constexpr double kSteepest = 0.6, kOffHips = 0.03;  // of a skirt's cone, as WrappedPlacement::slope; m
/// As kLeastAround, of the trunk, which is flatter than round: the way that closes a tube runs behind it
/// still.
constexpr double kLeastOfTrunk = 0.68;
constexpr double kNeckDepth = 0.07, kNeckHalf = 0.1;  // m, of a neckline

/// The unit vector across the line along which the points lie, to the side of `inwards`. Where they lie close
/// together on one part of an edge, the way to the piece's middle would be aslant.
Vec2 across(const PointAxes& line, Vec2 inwards) {
  if (!line.spread) return normalized(inwards);
  const Vec2 normal = perpendicular(line.along);
  return dot(normal, inwards) < 0 ? normal * -1 : normal;
}

}  // namespace

/// A half of a hood stands beside the head, its front edge to the front, over the shoulder.
std::vector<Arranger::Placed> Arranger::hood_places(double rise) const {
  std::vector<Placed> places;
  const measure::BodyFigure& f = stand_.figure();
  for (const Index p : plan_.roles.hoods) {
    const measure::BodySide side = side_of(plan_.graph, plan_.layout, plan_.arms, p);
    const int hand = side == measure::kWearersLeft ? 1 : -1;
    const GarmentPiece& piece = plan_.graph.pieces[p];
    FlatMove pose = hood_pose(p, side, rise);
    const double x = stand_.half_breadth_above(f.neck) + kAway;
    double low = HUGE_VAL;
    for (const Vec2 q : outline_on_sheet(piece, pose)) low = std::min(low, q.y);
    pose.t.y += std::max(0.0, stand_.top_beside(x) + kAway / 2 - low);
    places.push_back({p, on_side_sheet(pose, f.middle + hand * x),
                      std::string("hood, ") + (hand > 0 ? "left" : "right") + " of the head"});
  }
  return places;
}

/// On the sheet beside the head, where its stitches lie as near to the neckline as can be, upright.
FlatMove Arranger::hood_pose(Index p, measure::BodySide side, double rise) const {
  const measure::BodyFigure& f = stand_.figure();
  const GarmentPiece& piece = plan_.graph.pieces[p];
  std::vector<Vec2> points, targets;
  for (const GarmentTie& t : plan_.graph.ties) {
    const bool first = t.a == p;
    const Index other = first ? t.b : t.b == p ? t.a : kNone;
    if (other == kNone || !plan_.layout.has(other)) continue;
    const Vec2 there = plan_.layout.pose[other](first ? t.at_b : t.at_a);
    // Fronts of the neckline lie before the neck, backs behind it, farther the nearer to the middle.
    const double depth = kNeckDepth * std::max(0.0, 1 - std::abs(there.x) / kNeckHalf);
    points.push_back(first ? t.at_a : t.at_b);
    targets.push_back({f.neck_side[side].z + plan_.layout.face[other] * depth, there.y + rise});
  }
  if (points.empty()) {
    points = {piece.centroid};
    targets = {{0, f.chin + 0.05}};
  }
  const bool mirrored = piece.outside * (side == measure::kWearersLeft ? 1 : -1) > 0;
  const double free = fit_move(points, targets, mirrored).move.angle();
  const Vec2 grain = turn_by(0, mirrored).turned(piece.grain);
  double best = 0, least = HUGE_VAL;
  for (int k = 0; k < 4; ++k) {
    const double angle = (k + 1) * std::numbers::pi / 2 - std::atan2(grain.y, grain.x);
    const double d = std::abs(std::remainder(angle - free, 2 * std::numbers::pi));
    if (d < least) {
      least = d;
      best = angle;
    }
  }
  FlatMove pose = turn_by(best, mirrored);
  Vec2 shift;
  for (std::size_t i = 0; i < points.size(); ++i) shift = shift + targets[i] - pose.turned(points[i]);
  pose.t = shift * (1.0 / static_cast<double>(points.size()));
  return pose;
}

/// Whether a strip's stitches to the other piece say how it stands. A collar that is open in front has its
/// middle behind, and there alone no end of it is sewn.
bool Arranger::tells_of_band(Index piece, Index other) const {
  const bool open_collar =
      plan_.graph.pieces[piece].cover == Cover::kCollar && !plan_.graph.pieces[piece].tube;
  const int face = plan_.layout.has(other) ? plan_.layout.face[other] : plan_.graph.pieces[other].face;
  return !open_collar || face < 0;
}

/// The angle at which the strip's stitches stand nearest to those that they are sewn to, radians.
double Arranger::angle_of_band(Index piece, const sewing::WrappedPlacement& w) const {
  const double c = std::cos(w.turn), s = std::sin(w.turn);
  double sines = 0, cosines = 0;
  for (const GarmentTie& t : plan_.graph.ties) {
    const bool first = t.a == piece;
    const Index other = first ? t.b : t.b == piece ? t.a : kNone;
    if (other == kNone || other == piece || !plan_.layout.has(other) || !tells_of_band(piece, other))
      continue;
    const Vec2 there = plan_.layout.pose[other](first ? t.at_b : t.at_a);
    const Vec2 d = (first ? t.at_a : t.at_b) - w.anchor;
    const double along = (c * d.x - s * d.y) * (w.flipped ? -1 : 1);
    const double angle = std::atan2(there.x, plan_.layout.face[other] * 0.5 * w.radius) - along / w.radius;
    sines += std::sin(angle);
    cosines += std::cos(angle);
  }
  return std::atan2(sines, cosines);
}

/// Strips that close in themselves go around the trunk, or the neck, at the height of what they are sewn to;
/// a collar as much higher as the neck is slimmer there. What is sewn to such a strip alone goes around it.
std::vector<Arranger::Placed> Arranger::band_places(double rise, const std::vector<Placed>& legs,
                                                    const std::vector<Placed>& trunk) const {
  std::vector<Placed> places;
  for (const bool on_trunk : {true, false}) {
    for (const Index p : plan_.roles.bands) {
      if (mean_tie_on_trunk(p).has_value() != on_trunk) continue;
      const Cover cover = plan_.graph.pieces[p].cover;
      std::optional<sewing::WrappedPlacement> upon = cuff_on_leg(p, on_trunk ? trunk : legs);
      const bool ankle = upon.has_value();
      if (!on_trunk && !upon) upon = band_on_legs(p, legs);
      if (!on_trunk && !upon) upon = band_upon(p, legs);
      if (!on_trunk && !upon) upon = band_upon(p, places);
      const bool alone = !on_trunk && cover != Cover::kCollar && plan_.roles.trunk.empty();
      if (!upon) upon = alone ? tube_around(p) : band_around(p, rise);
      const char* where = ankle                     ? ", around the ankle"
                          : cover == Cover::kCollar ? ", around the neck"
                                                    : ", around the trunk";
      places.push_back({p, *upon, name_of(cover) + std::string(where)});
    }
  }
  return places;
}

/// Turns and mirrors the strip so that the edge by which it is sewn, at `sewn`, is below the rest of it, or
/// above.
void Arranger::hang_by(const std::vector<Vec2>& sewn, bool downwards, Index p,
                       sewing::WrappedPlacement& w) const {
  const GarmentPiece& piece = plan_.graph.pieces[p];
  const PointAxes line = sewn.empty() ? PointAxes{piece.centroid, {}} : axes_of(sewn);
  w.anchor = line.mean;
  const Vec2 up = sewn.empty() ? piece.grain : across(line, piece.centroid - line.mean);
  w.turn = (downwards ? -0.5 : 0.5) * std::numbers::pi - std::atan2(up.y, up.x);
  w.flipped = piece.outside < 0;
}

/// Around the strip that it is sewn to, beyond the edge that takes it: a collar above its stand, a skirt
/// below its band.
std::optional<sewing::WrappedPlacement> Arranger::band_upon(Index p,
                                                            const std::vector<Placed>& places) const {
  for (const Placed& placed : places) {
    const auto& host = std::get<sewing::WrappedPlacement>(placed.placement);
    std::vector<Vec2> mine, there;
    for (const GarmentTie& t : plan_.graph.ties) {
      if (!(t.a == p && t.b == placed.piece) && !(t.b == p && t.a == placed.piece)) continue;
      mine.push_back(t.a == p ? t.at_a : t.at_b);
      there.push_back(t.a == p ? t.at_b : t.at_a);
    }
    if (mine.empty()) continue;
    // The stitches' middle in the flat lies off the edge where that is an arc.
    const Vec3 toward = sewing::place({mean_of(there)}, host).front() - host.axis;
    double height = 0, radius = 0;
    for (const Vec3 at : sewing::place(there, host)) {
      height += (at.y - host.axis.y) / static_cast<double>(there.size());
      radius += std::hypot(at.x - host.axis.x, at.z - host.axis.z) / static_cast<double>(there.size());
    }
    sewing::WrappedPlacement w = host;
    const Vec2 middle = plan_.graph.pieces[placed.piece].centroid;
    const bool downwards = height < (sewing::place({middle}, host).front() - host.axis).y;
    hang_by(mine, downwards, p, w);
    // As the strip itself rolls up: the host's cone would turn the ends of a straight one down.
    const std::optional<Roll> roll = own_roll(plan_.graph, p);
    w.slope = roll ? std::min(roll->slope, kSteepest) : 0;
    w.radius = radius + kClose;
    if (roll) w.radius = std::min(w.radius, roll->above / (2 * std::numbers::pi * kLeastOfTrunk));
    w.height = height + (downwards ? -kSheetGap : kSheetGap);
    w.angle = std::atan2(toward.x, toward.z);
    return w;
  }
  return std::nullopt;
}

/// A circle of the strip's length at a height (m), or where the neck above it is slimmest.
sewing::WrappedPlacement Arranger::band_at(Index p, double lowest) const {
  const measure::BodyFigure& f = stand_.figure();
  const GarmentPiece& piece = plan_.graph.pieces[p];
  const bool neck = piece.cover == Cover::kCollar;
  const Vec2 outline = bounding_box(piece.outline).size();
  const double tall = std::min(outline.x, outline.y), wide = std::max(outline.x, outline.y);
  sewing::WrappedPlacement w;
  w.radius = HUGE_VAL;
  for (double y = lowest; y == lowest || (neck && y < f.chin); y += 0.01) {
    const Vec2 axis = stand_.middle_at(neck ? f.neck : y);
    const double body = stand_.radius_about(axis, y - 0.02, y + tall + 0.02, neck ? 0.09 : 0.25);
    if (body + kClose >= w.radius) continue;
    w.radius = body + kClose;
    w.axis = {axis.x, 0, axis.y};
    w.height = y;
  }
  w.radius = std::max(w.radius, 1.02 * wide / (2 * std::numbers::pi));
  // Where shoulders make the circle much wider than the strip is long, its ends would close beside the neck.
  if (neck && piece.tube) w.radius = std::min(w.radius, wide / (2 * std::numbers::pi * kLeastAround));
  return w;
}

sewing::WrappedPlacement Arranger::band_around(Index p, double rise) const {
  const measure::BodyFigure& f = stand_.figure();
  const GarmentPiece& piece = plan_.graph.pieces[p];
  const std::optional<Vec2> tie = mean_tie_on_trunk(p);
  sewing::WrappedPlacement w = band_at(p, tie                             ? tie->y + rise
                                          : piece.cover == Cover::kCollar ? f.neck
                                                                          : f.waist);
  // The sewn edge comes to the height of what it is sewn to, the free one away from it.
  std::vector<Vec2> sewn;
  for (const GarmentTie& t : plan_.graph.ties) {
    if (t.a == t.b || (t.a != p && t.b != p) || !tells_of_band(p, t.a == p ? t.b : t.a)) continue;
    sewn.push_back(t.a == p ? t.at_a : t.at_b);
  }
  const bool downwards =
      piece.cover == Cover::kCuff || (piece.cover == Cover::kSkirt && is_top()) || ends_top(plan_.graph, p);
  hang_by(sewn, downwards, p, w);
  w.height += downwards ? -kSheetGap : kSheetGap;
  w.angle = angle_of_band(p, w);
  return w;
}

/// A garment of one tube: its upper end comes to where the trunk is as wide as that, a top's under the arms.
sewing::WrappedPlacement Arranger::tube_around(Index p) const {
  const GarmentPiece& piece = plan_.graph.pieces[p];
  const measure::BodyFigure& f = stand_.figure();
  sewing::WrappedPlacement w;
  const std::optional<Roll> roll = own_roll(plan_.graph, p);
  if (!roll) return band_around(p, 0);
  w.height = piece.cover == Cover::kTorso ? f.armpit[0].y - kBelowArmpit : stand_.height_of_ring(roll->above);
  const Vec2 axis = stand_.middle_at(w.height);
  w.axis = {axis.x, 0, axis.y};
  // As wide as the body is, but never so wide that the way to close it would be shorter beside the body.
  const auto radius = [](double around, double covered) { return around / (2 * std::numbers::pi * covered); };
  const auto body = [&](double low, double high) {
    return stand_.radius_about(axis, low, high, 0.25) + kClose;
  };
  w.radius = std::clamp(body(w.height - 0.05, w.height + kClose), radius(roll->above, 0.98),
                        radius(roll->above, kLeastOfTrunk));
  const double grown = (body(f.hip - 0.05, w.height) - w.radius) / std::max(w.height - f.hip, 0.1);
  const double most = (radius(roll->below, kLeastOfTrunk) - w.radius) / roll->length;
  w.slope = std::clamp(std::max(roll->slope, std::min(grown, most)), 0.0, kSteepest);
  w.anchor = roll->top;
  w.turn = 0.5 * std::numbers::pi - std::atan2(roll->up.y, roll->up.x);
  w.flipped = piece.outside < 0;
  return w;
}

/// On a cone around the hips, each beside the next, turned so that their stitches to the rest are short.
std::vector<Arranger::Placed> Arranger::gore_places(double rise) const {
  std::vector<Placed> places;
  double above = 0, below = 0, length = 0;
  Vec2 lowest{0, HUGE_VAL};
  for (const Gore& gore : plan_.roles.gores) {
    above += gore.width;
    below += gore.below;
    length = std::max(length, gore.length);
    const std::optional<Vec2> tie = mean_tie_on_trunk(gore.piece);
    if (tie && tie->y + rise < lowest.y) lowest = {tie->x, tie->y + rise};
  }
  if (plan_.roles.gores.empty()) return places;
  const measure::BodyFigure& f = stand_.figure();
  sewing::WrappedPlacement cone;
  cone.height = (lowest.y < HUGE_VAL ? lowest.y : stand_.height_of_ring(above)) - kSheetGap;
  const Vec2 axis = stand_.middle_at(cone.height);
  cone.axis = {axis.x, 0, axis.y};
  cone.radius = std::max(above / (2 * std::numbers::pi),
                         stand_.radius_about(axis, f.hip - 0.05, cone.height + 0.02, 0.25) + kOffHips);
  cone.slope = std::clamp((below - above) / (2 * std::numbers::pi * length), 0.0, kSteepest);
  double sines = 0, cosines = 0;
  for (const Gore& gore : plan_.roles.gores) {
    sewing::WrappedPlacement w = cone;
    w.anchor = gore.top;
    w.turn = 0.5 * std::numbers::pi - std::atan2(gore.up.y, gore.up.x);
    w.flipped = plan_.graph.pieces[gore.piece].outside < 0;
    w.angle = gore.angle;
    if (mean_tie_on_trunk(gore.piece)) {
      sines += std::sin(angle_of_band(gore.piece, w) - gore.angle);
      cosines += std::cos(angle_of_band(gore.piece, w) - gore.angle);
    }
    places.push_back({gore.piece, w, "gore, around the hips"});
  }
  const double turn = std::atan2(sines, cosines);
  for (Placed& placed : places) std::get<sewing::WrappedPlacement>(placed.placement).angle += turn;
  return places;
}

}  // namespace toile::arrange
