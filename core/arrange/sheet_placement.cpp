#include "core/arrange/sheet_placement.h"

#include <cmath>
#include <numbers>

namespace toile::arrange {

Vec3 turn_angles(const std::array<Vec3, 3>& column) {
  const double up = column[0].z;
  if (std::abs(up) > 1 - 1e-12) {
    const double sign = up < 0 ? 1 : -1;
    return {std::atan2(sign * column[1].x, column[1].y), sign * std::numbers::pi / 2, 0};
  }
  return {std::atan2(column[1].z, column[2].z), -std::asin(up), std::atan2(column[0].y, column[0].x)};
}

sewing::RigidPlacement on_upright_sheet(const FlatMove& pose, double z) {
  sewing::RigidPlacement rigid;
  rigid.translation = {pose.t.x, pose.t.y, z};
  rigid.rotation = {0, pose.mirrored ? std::numbers::pi : 0, pose.angle()};
  return rigid;
}

sewing::RigidPlacement on_side_sheet(const FlatMove& pose, double x) {
  const Vec2 u = pose.turned({1, 0}), v = pose.turned({0, 1});
  const Vec3 along_u{0, u.y, u.x}, along_v{0, v.y, v.x};
  sewing::RigidPlacement rigid;
  rigid.translation = {x, pose.t.y, pose.t.x};
  rigid.rotation = turn_angles({along_u, along_v, cross(along_u, along_v)});
  return rigid;
}

}  // namespace toile::arrange
