#pragma once
// Bodies and objects as this method meets them: triangles that particles' paths may strike.

#include <span>
#include <vector>

#include "core/paper/path.h"

namespace toile::paper {

/// The triangles of all bodies: where cloth lies on them, and their skin.
struct Solids {
  std::vector<Corners> triangles;  ///< m, counter-clockwise seen from outside
  std::vector<Vec3> normals;       ///< unit, outwards, of each
  std::vector<bool> skin;          ///< which are skin
};

/// Adds a body twice: with corners that stand off by `clearance` (m) along their normals, so that a link
/// between two particles on it does not cut through where it is round, and as it is, for what is nearer to
/// it, as under an arm, where there is no room for more.
void add_solid(std::span<const Vec3> vertices, std::span<const Tri> triangles, double clearance,
               Solids& solids);

}  // namespace toile::paper
