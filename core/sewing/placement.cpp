#include "core/sewing/placement.h"

#include <cmath>

namespace toile::sewing {

namespace {

/// The sines and cosines of a rotation about x, then y, then z (fixed axes).
struct Rotation {
  double cx, sx, cy, sy, cz, sz;
  explicit Rotation(Vec3 r)
      : cx(std::cos(r.x)),
        sx(std::sin(r.x)),
        cy(std::cos(r.y)),
        sy(std::sin(r.y)),
        cz(std::cos(r.z)),
        sz(std::sin(r.z)) {}
  Vec3 operator()(Vec3 p) const {
    p = {p.x, cx * p.y - sx * p.z, sx * p.y + cx * p.z};
    p = {cy * p.x + sy * p.z, p.y, -sy * p.x + cy * p.z};
    return {cz * p.x - sz * p.y, sz * p.x + cz * p.y, p.z};
  }
};

std::vector<Vec3> place_rigid(const std::vector<Vec2>& rest, const RigidPlacement& placement) {
  const Rotation rotate(placement.rotation);
  std::vector<Vec3> out;
  out.reserve(rest.size());
  for (const Vec2& p : rest)
    out.push_back(placement.translation + rotate({placement.flipped ? -p.x : p.x, p.y, 0}));
  return out;
}

/// Where a point comes to around an upright axis through the origin: a cylinder unrolls trivially. A cone
/// unrolls into a ring sector around its apex: with half angle α, sin α = slope, a point at slant distance r
/// from the apex and sector angle φ stands at the angle φ / sin α around the axis, at the radius r·sin α.
Vec3 on_cone(Vec2 d, const WrappedPlacement& w) {
  const double slant = w.radius / w.slope;  // signed: the apex is above for a positive slope
  const Vec2 from_apex{d.x, slant - d.y};
  const double r = std::copysign(length(from_apex), slant);
  const double turn = w.angle + std::atan2(from_apex.x, std::abs(from_apex.y)) / std::abs(w.slope);
  const double radius = r * w.slope, drop = (r - slant) * std::sqrt(1 - w.slope * w.slope);
  return {radius * std::sin(turn), w.height - drop, radius * std::cos(turn)};
}

Vec3 on_cylinder(Vec2 d, const WrappedPlacement& w) {
  const double turn = w.angle + d.x / w.radius;
  return {w.radius * std::sin(turn), w.height + d.y, w.radius * std::cos(turn)};
}

std::vector<Vec3> place_wrapped(const std::vector<Vec2>& rest, const WrappedPlacement& w) {
  const double c = std::cos(w.turn), s = std::sin(w.turn);
  const Vec3 up = length(w.up) > 0 ? normalized(w.up) : Vec3{0, 1, 0};
  const Vec3 ahead = std::abs(up.z) < 0.999 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 front = normalized(ahead - up * dot(up, ahead)), aside = cross(up, front);
  std::vector<Vec3> out;
  out.reserve(rest.size());
  for (const Vec2& p : rest) {
    Vec2 d = p - w.anchor;
    if (w.turn != 0) d = {c * d.x - s * d.y, s * d.x + c * d.y};
    if (w.flipped) d.x = -d.x;
    const Vec3 q = std::abs(w.slope) < 1e-9 ? on_cylinder(d, w) : on_cone(d, w);
    out.push_back(w.axis + aside * q.x + up * q.y + front * q.z);
  }
  return out;
}

}  // namespace

std::vector<Vec3> place(const std::vector<Vec2>& rest, const Placement& placement) {
  if (const auto* rigid = std::get_if<RigidPlacement>(&placement)) return place_rigid(rest, *rigid);
  return place_wrapped(rest, std::get<WrappedPlacement>(placement));
}

}  // namespace toile::sewing
