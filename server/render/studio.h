#pragma once
// The lamps of the studio.

#include <array>
#include <vector>

#include "core/base/aabb.h"
#include "server/render/camera.h"

namespace toile::render {

inline constexpr int kSkyTileSide = 192;  ///< texels of one sky light's depth map; about 1 cm around a person

struct Lights {
  Vec3 key, fill, rim;                    ///< towards the lights, unit
  Matrix4 key_matrix;                     ///< world to the key light's depth map, [-1, 1]³
  std::vector<Matrix4> sky_matrices;      ///< the same for each sky light
  std::vector<std::array<float, 4>> sky;  ///< towards each sky light; its share of the light on a level plane
  float sky_offset = 0.01f;               ///< m, how far off a surface sky light is asked for
};

/// Lamps for what lies in `box`. They turn with the camera: the key light stands to its upper left, grazing,
/// so that folds show from every side. Soft light comes from an overcast sky, which does not turn.
Lights studio(const Camera& camera, Aabb3 box);

}  // namespace toile::render
