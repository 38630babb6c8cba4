#include "core/drape/weld.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/collision/contact_finder.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

namespace {

/// m; what has been joined stays so, even where contact leaves nothing free.
constexpr double kRounding = 1e-12;

/// Bounds of contact around `positions` for ways of up to `reach` (m).
collision::Contacts bounds_at(const sewing::GarmentMesh& garment, std::span<const Vec3> positions,
                              double reach, std::span<const collision::Obstacle> obstacles) {
  collision::ContactSettings settings;
  settings.thickness = 0;
  settings.trust_radius_least = settings.trust_radius_most = reach + collision::kContactFloor;
  collision::ContactFinder finder(
      collision::make_surface(garment.triangles, garment.vertex_count(), garment.weld), obstacles, settings);
  collision::Contacts bounds;
  finder.detect(positions, std::vector<double>(positions.size(), 0), bounds);
  return bounds;
}

}  // namespace

Weld no_weld(std::span<const Vec3> positions) {
  Weld weld;
  weld.vertex_of.resize(positions.size());
  std::iota(weld.vertex_of.begin(), weld.vertex_of.end(), 0);
  weld.vertex_count = static_cast<Index>(positions.size());
  weld.positions.assign(positions.begin(), positions.end());
  return weld;
}

Weld joined_as(const sewing::GarmentMesh& garment, const std::vector<bool>& joined) {
  sewing::JoinedVertices now = sewing::joined_vertices(garment, joined);
  Weld weld;
  weld.vertex_of = std::move(now.vertex_of);
  weld.vertex_count = now.count;
  return weld;
}

Weld weld_seams(const sewing::GarmentMesh& garment, std::span<const Vec3> positions, double reach,
                std::span<const collision::Obstacle> obstacles) {
  const std::vector<Vec3> mean = sewing::together_at_means(garment, positions);
  const collision::Contacts bounds = bounds_at(garment, positions, reach, obstacles);
  std::vector<bool> open(positions.size(), false);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 to = mean[garment.weld[i]];
    const double way = length(to - positions[i]);
    const auto v = static_cast<Index>(i);
    const bool free =
        way < kRounding || (way <= reach && bounds.inside_trust_region(v, to) && bounds.inside_planes(v, to));
    if (!free) open[garment.weld[i]] = true;
  }

  std::vector<bool> shut(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) shut[i] = !open[garment.weld[i]];
  Weld weld = joined_as(garment, shut);
  weld.positions.resize(static_cast<std::size_t>(weld.vertex_count));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Index least = garment.weld[i];
    weld.positions[weld.vertex_of[i]] = shut[i] ? mean[least] : positions[i];
    if (static_cast<Index>(i) != least && open[least]) weld.refused.push_back(least);
  }
  std::sort(weld.refused.begin(), weld.refused.end());
  weld.refused.erase(std::unique(weld.refused.begin(), weld.refused.end()), weld.refused.end());
  return weld;
}

std::vector<Vec3> velocities_of_joined(std::span<const Index> before, const Weld& after,
                                       std::span<const double> mass, std::span<const Vec3> velocities) {
  std::vector<Vec3> joined(after.vertex_count);
  std::vector<double> joined_mass(after.vertex_count, 0);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double m = mass[before[i]];
    joined[after.vertex_of[i]] += velocities[before[i]] * m;
    joined_mass[after.vertex_of[i]] += m;
  }
  for (std::size_t v = 0; v < joined.size(); ++v) joined[v] = joined[v] * (1 / joined_mass[v]);
  return joined;
}

}  // namespace toile::drape
