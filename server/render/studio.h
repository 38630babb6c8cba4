#pragma once
// The lamps of the studio.

#include <array>
#include <vector>

#include "core/base/aabb.h"
#include "server/render/camera.h"

namespace toile::render {

inline constexpr int kSkyTileSide = 192;  ///< texels of one sky light's depth map; about 1 cm around a person

struct Lamps {
  Vec3 key, fill, rim;  ///< towards the lights, unit
  Matrix4 key_matrix;   ///< world to the key light's depth map, [-1, 1]³
};

/// Lamps for what lies in `box`. They turn with the camera: the key light stands to its upper left, grazing,
/// so that folds show from every side.
Lamps lamps_for(const Camera& camera, Aabb3 box);

/// Soft light of an overcast sky over what lies in a box, which does not turn with the camera.
struct SkyLight {
  std::vector<Matrix4> matrices;             ///< world to each light's depth map, [-1, 1]³
  std::vector<std::array<float, 4>> lights;  ///< towards each; its share of the light on a level plane
  float offset = 0.01f;                      ///< m, how far off a surface it is asked for
};

SkyLight sky_over(Aabb3 box);

}  // namespace toile::render
