#include "core/arrange/box_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/arrange/sheet_placement.h"

namespace toile::arrange {

namespace {

/// Away from the box, and half its size that way.
struct Facing {
  Vec3 normal;
  double half;
  double angle;  ///< about the box's own axis
};

Facing facing_of(const measure::PartBox& box, BoxSide side) {
  constexpr double kPi = std::numbers::pi;
  switch (side) {
    case BoxSide::kFront:
      return {box.axis[2], box.half.z, 0};
    case BoxSide::kBack:
      return {-box.axis[2], box.half.z, kPi};
    case BoxSide::kLeft:
      return {box.axis[0], box.half.x, kPi / 2};
    default:
      return {-box.axis[0], box.half.x, -kPi / 2};
  }
}

}  // namespace

sewing::RigidPlacement on_box_side(const measure::PartBox& box, const OnBox& where) {
  const Facing facing = facing_of(box, where.side);
  const Vec3 up = box.axis[1], right = cross(up, facing.normal);
  const double c = std::cos(where.turn), s = std::sin(where.turn);
  const Vec3 along_u = right * c + up * s, along_v = up * c - right * s;
  sewing::RigidPlacement rigid;
  rigid.rotation = turn_angles({along_u, along_v, facing.normal});
  rigid.flipped = where.flipped;
  const double u = where.flipped ? -where.anchor.x : where.anchor.x;
  rigid.translation = box.centre + facing.normal * (facing.half + where.away) + right * where.at.x +
                      up * where.at.y - along_u * u - along_v * where.anchor.y;
  return rigid;
}

sewing::WrappedPlacement around_box(const measure::PartBox& box, const OnBox& where, double part_radius,
                                    double slope) {
  sewing::WrappedPlacement w;
  w.axis = box.centre;
  w.up = box.axis[1];
  w.radius = part_radius + where.away;
  w.angle = facing_of(box, where.side).angle + where.at.x / w.radius;
  w.height = where.at.y;
  w.anchor = where.anchor;
  w.slope = slope;
  w.flipped = where.flipped;
  w.turn = where.flipped ? -where.turn : where.turn;
  return w;
}

double radius_of_part(const geometry::TriangleMesh& mesh, const measure::BodyFigure& figure,
                      const measure::PartBox& box, double low, double high) {
  const std::vector<measure::BodyPart> parts = measure::part_of_vertices(mesh, figure);
  double most = 0;
  for (std::size_t v = 0; v < parts.size(); ++v) {
    const Vec3 d = mesh.vertices[v] - box.centre;
    const double along = dot(d, box.axis[1]);
    if (parts[v] != box.part || along < low || along > high) continue;
    most = std::max(most, length(d - box.axis[1] * along));
  }
  return most;
}

}  // namespace toile::arrange
