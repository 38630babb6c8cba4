#include "core/drape/weld.h"

#include <algorithm>
#include <numeric>

namespace toile::drape {

namespace {

/// Mean position of each class, stored at its least vertex.
std::vector<Vec3> class_means(const sewing::GarmentMesh& garment, std::span<const Vec3> positions) {
  std::vector<Vec3> mean(positions.size());
  std::vector<int> count(positions.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    mean[garment.weld[i]] += positions[i];
    ++count[garment.weld[i]];
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (count[i] > 1) mean[i] = mean[i] * (1.0 / count[i]);
  }
  return mean;
}

/// Marks the classes of every vertex that takes part in a crossing; true when there was one.
bool open_crossing_classes(const sewing::GarmentMesh& garment, std::span<const Vec3> positions,
                           std::span<const collision::CrossingBody> bodies, std::vector<bool>& open) {
  const collision::Surface surface =
      collision::make_surface(garment.triangles, garment.vertex_count(), garment.weld);
  bool any = false;
  const auto mark = [&](Index triangle) {
    for (const Index v : garment.triangles[triangle]) {
      if (!open[garment.weld[v]]) open[garment.weld[v]] = any = true;
    }
  };
  for (const auto& [a, b] : collision::self_crossings(surface, positions)) {
    mark(a);
    mark(b);
  }
  for (const collision::CrossingBody& body : bodies) {
    for (const auto& [a, b] : collision::body_crossings(surface, positions, body)) mark(a);
  }
  return any;
}

std::vector<Vec3> with_means(const sewing::GarmentMesh& garment, std::span<const Vec3> positions,
                             const std::vector<Vec3>& mean, const std::vector<bool>& open) {
  std::vector<Vec3> out(positions.begin(), positions.end());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!open[garment.weld[i]]) out[i] = mean[garment.weld[i]];
  }
  return out;
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
  Weld weld;
  weld.vertex_of.assign(joined.size(), kNone);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const Index least = garment.weld[i];
    const bool own = static_cast<Index>(i) == least || !joined[i];
    weld.vertex_of[i] = own ? weld.vertex_count++ : weld.vertex_of[least];
  }
  return weld;
}

Weld weld_seams(const sewing::GarmentMesh& garment, std::span<const Vec3> positions, double reach,
                std::span<const collision::CrossingBody> bodies) {
  const std::vector<Vec3> mean = class_means(garment, positions);
  std::vector<bool> open(positions.size(), false);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (length(positions[i] - mean[garment.weld[i]]) > reach) open[garment.weld[i]] = true;
  }
  std::vector<Vec3> joined = with_means(garment, positions, mean, open);
  while (open_crossing_classes(garment, joined, bodies, open))
    joined = with_means(garment, positions, mean, open);

  std::vector<bool> shut(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) shut[i] = !open[garment.weld[i]];
  Weld weld = joined_as(garment, shut);
  weld.positions.resize(static_cast<std::size_t>(weld.vertex_count));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Index least = garment.weld[i];
    weld.positions[weld.vertex_of[i]] = joined[i];
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
