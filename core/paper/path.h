#pragma once
// Figure 7 of Kim and Park 2003: a particle's path in one step against a triangle, and its reflection.

#include <array>
#include <optional>

#include "core/base/types.h"

namespace toile::paper {

using Corners = std::array<Vec3, 3>;

/// Where a path meets a triangle.
struct PathHit {
  double at = 0;                  ///< share of the path that is behind it
  double side = 1;                ///< it came from where the normal points (1), or from behind (−1)
  std::array<double, 3> share{};  ///< weights of the corners
};

/// Twice the area along the normal of the triangle.
inline Vec3 area_normal(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// The weights of a triangle's corners that give `p`, which lies in its plane; nothing when p lies beside it.
/// The border counts as inside, with a little more than rounding needs, so that nothing slips between two.
std::optional<std::array<double, 3>> inside(const Corners& triangle, Vec3 p);

/// The path from p0 to p1 against a triangle that moves from `before` to `after` in the same step: it is hit
/// when the particle changes sides of its plane, and is within it then. Distances are taken to change evenly
/// over the step.
std::optional<PathHit> path_hit(Vec3 p0, Vec3 p1, const Corners& before, const Corners& after);

/// Against a triangle at rest, from its outer side only.
std::optional<PathHit> path_hit_outside(Vec3 p0, Vec3 p1, const Corners& triangle);

inline Vec3 mirrored(Vec3 way, Vec3 normal) { return way - normal * (2 * dot(way, normal)); }

/// Where the particle ends that strikes a surface with this unit normal at `hit` on its way to `aim`: what is
/// left of its way is mirrored at the surface and kept by the share `reflection`. 0: it stays where it
/// struck; 1: it leaves as fast as it came.
inline Vec3 reflected(Vec3 hit, Vec3 aim, Vec3 normal, double reflection) {
  return hit + mirrored(aim - hit, normal) * reflection;
}

}  // namespace toile::paper
