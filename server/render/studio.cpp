#include "server/render/studio.h"

#include <algorithm>

#include "core/base/units.h"
#include "server/render/shaders.h"

namespace toile::render {
namespace {

constexpr double kLowestSky = 0.08;  // sine of the lowest sky light's elevation

/// With room for what lies at its border.
Aabb3 lit(Aabb3 box) {
  if (box.empty()) box.add({0, 0, 0});
  return box.grown(std::max(0.02 * length(box.size()), 0.01));
}

}  // namespace

Lamps lamps_for(const Camera& camera, Aabb3 box) {
  const Vec3 right = normalized(Vec3{camera.right.x, 0, camera.right.z}), up{0, 1, 0},
             front = cross(right, up);
  Lamps lamps;
  lamps.key = normalized(right * -0.80 + up * 0.85 + front * 0.62);
  lamps.fill = normalized(right * 0.85 + up * 0.25 + front * 0.75);
  lamps.rim = normalized(right * 0.70 + up * 0.55 - front * 0.80);
  lamps.key_matrix = parallel_matrix(lit(box), -lamps.key);
  return lamps;
}

/// Directions spread evenly over the upper half sphere along a spiral; brighter overhead.
SkyLight sky_over(Aabb3 box) {
  box = lit(box);
  SkyLight sky;
  const double golden = kPi * (3 - std::sqrt(5.0));
  double level = 0;  // irradiance of a level plane, to be 1
  for (int i = 0; i < shaders::kSkyLights; ++i) {
    const double height = kLowestSky + (1 - kLowestSky) * (i + 0.5) / shaders::kSkyLights;
    const double across = std::sqrt(1 - height * height), angle = golden * i;
    const Vec3 d{across * std::sin(angle), height, across * std::cos(angle)};
    const double share = (1 + 2 * height) / 3;
    level += share * height;
    sky.lights.push_back({static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z),
                          static_cast<float>(share)});
    sky.matrices.push_back(parallel_matrix(box, -d));
  }
  for (auto& light : sky.lights) light[3] = static_cast<float>(light[3] / level);
  sky.offset = static_cast<float>(length(box.size()) / kSkyTileSide);
  return sky;
}

}  // namespace toile::render
