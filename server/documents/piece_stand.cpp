#include "server/documents/piece_stand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "core/arrange/box_places.h"
#include "core/base/aabb.h"
#include "core/base/units.h"
#include "core/sewing/placement.h"

namespace toile::documents {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFacing = 0.5;      // cosine: a sheet faces a side within 60 degrees
constexpr double kAlong = 0.8;       // cosine: a roll's axis runs along a part
constexpr double kOffTheEnd = 0.25;  // what it counts that a roll lies beyond a part's end, a metre

/// A side of a box: its name, where it looks and how it is turned about the box's own axis.
struct Side {
  const char* name;
  int axis;
  double sign;
  double angle;
};
constexpr Side kSides[]{
    {"front", 2, 1, 0}, {"back", 2, -1, kPi}, {"left", 0, 1, kPi / 2}, {"right", 0, -1, -kPi / 2}};

double hundredths(double x) { return std::round(x * 100) / 100 + 0.0; }
double mm(double metres) { return hundredths(mm_from_metres(metres)); }
double wrapped_angle(double a) { return std::remainder(a, 2 * kPi); }

Aabb2 box_of(const pattern::Panel& panel) {
  std::vector<Vec2> points;
  for (const pattern::PanelEdge& edge : panel.outline.edges) {
    for (const pattern::CubicBezier& c : edge.curves) {
      for (const Vec2 p : {c.p0, c.p1, c.p2, c.p3})
        points.push_back({metres_from_mm(p.x), metres_from_mm(p.y)});
    }
  }
  return bounding_box(points);
}

/// Told by hand: both kinds of place have the same words.
PieceWish told(const auto& place, const std::string& piece, bool wrapped) {
  PieceWish wish;
  wish.piece = piece;
  wish.part = place.part;
  wish.side = place.side;
  wish.at_mm = {mm_from_metres(place.at.x), mm_from_metres(place.at.y)};
  wish.away_mm = mm_from_metres(place.away);
  wish.turn = place.turn;
  wish.wrapped = wrapped;
  wish.flipped = place.flipped;
  return wish;
}

/// The part that an axis runs through, by how far its box's middle lies off it and how far along.
const measure::PartBox* part_around(const std::vector<measure::PartBox>& boxes,
                                    const sewing::WrappedPlacement& roll, Vec3 at) {
  const measure::PartBox* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const measure::PartBox& box : boxes) {
    if (std::abs(dot(box.axis[1], roll.up)) < kAlong) continue;
    const Vec3 d = box.centre - roll.axis;
    const double off = length(d - roll.up * dot(d, roll.up));
    const double beyond = std::max(0.0, std::abs(dot(at - box.centre, box.axis[1])) - box.half.y);
    const double far = off + kOffTheEnd * beyond;
    if (far >= least) continue;
    least = far;
    best = &box;
  }
  return best;
}

}  // namespace

std::optional<PieceWish> wish_of_hand(const project::ProjectPiece& piece) {
  const project::ProjectPlacement& placement = piece.placement;
  if (placement.on_box) return told(*placement.on_box, piece.id, false);
  if (placement.around) return told(*placement.around, piece.id, true);
  return std::nullopt;
}

PieceStands::PieceStands(const drape::DrapeInput& input) : input_(input) {
  for (const auto& body : input.bodies) {
    Result<measure::BodyFigure> figure = measure::find_figure(body.mesh);
    if (!figure) continue;
    mesh_ = &body.mesh;
    const auto boxes = measure::part_boxes(body.mesh, *figure);
    boxes_.assign(boxes.begin(), boxes.end());
    figure_ = *figure;
    return;
  }
}

std::optional<PieceWish> PieceStands::of(Index piece) const {
  const pattern::Panel& panel = input_.pattern.panels[static_cast<std::size_t>(piece)];
  const sewing::Placement& placement = input_.placements[static_cast<std::size_t>(piece)];
  const Aabb2 box = box_of(panel);
  std::optional<PieceWish> wish;
  if (const auto* rigid = std::get_if<sewing::RigidPlacement>(&placement)) {
    wish = of_sheet(*rigid, box.middle());
  } else {
    wish = of_roll(std::get<sewing::WrappedPlacement>(placement), box.middle(), box.high.y - box.low.y);
  }
  if (wish) wish->piece = panel.id;
  return wish;
}

std::optional<PieceWish> PieceStands::of_sheet(const sewing::RigidPlacement& rigid, Vec2 middle) const {
  const std::vector<Vec3> p =
      sewing::place({middle, middle + Vec2{rigid.flipped ? -1.0 : 1.0, 0}, middle + Vec2{0, 1}}, rigid);
  const Vec3 u = p[1] - p[0], normal = cross(u, p[2] - p[0]);
  std::optional<PieceWish> best;
  double least = 0;
  for (const measure::PartBox& box : boxes_) {
    for (const Side& side : kSides) {
      const Vec3 way = box.axis[static_cast<std::size_t>(side.axis)] * side.sign;
      if (dot(way, normal) < kFacing) continue;
      const Vec3 d = p[0] - box.centre - way * (side.axis == 2 ? box.half.z : box.half.x);
      if (best && length(d) >= least) continue;
      least = length(d);
      const Vec3 up = box.axis[1], right = cross(up, way);
      best.emplace();
      best->part = measure::name_of(box.part);
      best->side = side.name;
      best->at_mm = {mm(dot(d, right)), mm(dot(d, up))};
      best->away_mm = mm(dot(d, way));
      best->turn = hundredths(degrees_from_radians(std::atan2(dot(u, up), dot(u, right))));
      best->flipped = rigid.flipped;
    }
  }
  return best;
}

std::optional<PieceWish> PieceStands::of_roll(const sewing::WrappedPlacement& roll, Vec2 middle,
                                              double height) const {
  constexpr double kStep = 1e-4;  // m, to see which way the piece's own right goes
  const double side_way = roll.flipped ? -kStep : kStep;
  const std::vector<Vec3> p = sewing::place({middle, middle + Vec2{side_way, 0}}, roll);
  const measure::PartBox* box = part_around(boxes_, roll, p[0]);
  if (!box) return std::nullopt;
  const Vec3 d = p[0] - box->centre, up = box->axis[1], u = p[1] - p[0];
  const double along = dot(d, up);
  const double angle = std::atan2(dot(d, box->axis[0]), dot(d, box->axis[2]));
  const Side& side =
      *std::min_element(std::begin(kSides), std::end(kSides), [&](const Side& a, const Side& b) {
        return std::abs(wrapped_angle(angle - a.angle)) < std::abs(wrapped_angle(angle - b.angle));
      });
  const double radius =
      arrange::radius_of_part(*mesh_, *figure_, *box, along - height / 2, along + height / 2);
  const Vec3 around = box->axis[0] * std::cos(angle) - box->axis[2] * std::sin(angle);
  PieceWish wish;
  wish.part = measure::name_of(box->part);
  wish.side = side.name;
  wish.at_mm = {mm(wrapped_angle(angle - side.angle) * roll.radius), mm(along)};
  wish.away_mm = std::max(0.0, mm(roll.radius - radius));
  wish.turn = hundredths(degrees_from_radians(std::atan2(dot(u, up), dot(u, around))));
  wish.wrapped = true;
  wish.flipped = roll.flipped;
  return wish;
}

}  // namespace toile::documents
