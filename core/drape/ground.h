#pragma once
// The floor that a person stands on, as two triangles.

#include <array>

#include "core/base/types.h"

namespace toile::drape {

/// A square that no garment reaches beyond, facing up, and what lies on it does not slide.
struct Ground {
  std::array<Vec3, 4> corners;
  std::array<Tri, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
  double friction = 0.5, skin = 1e-3;  ///< Coulomb; m

  /// `height` in m.
  explicit Ground(double height) {
    constexpr double kReach = 20;  // m
    corners = {{{-kReach, height, -kReach},
                {-kReach, height, kReach},
                {kReach, height, kReach},
                {kReach, height, -kReach}}};
  }
};

}  // namespace toile::drape
