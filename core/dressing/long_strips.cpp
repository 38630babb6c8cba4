#include "core/dressing/long_strips.h"

#include <algorithm>
#include <cmath>

#include "core/base/aabb.h"

namespace toile::dressing {

namespace {

constexpr double kLong = 0.9;       ///< m: longer than any neck is around
constexpr double kAspect = 10;      ///< times its breadth
constexpr double kHeldLeast = 0.6;  ///< of the length, that is sewn
constexpr double kOff = 0.015;      ///< m, that the free side begins before what holds the other one

struct Stitch {
  Vec2 rest;
  Vec3 there;
};

/// Where the panel is sewn to pieces for the trunk, each vertex at the mean of what it is sewn to.
std::vector<Stitch> stitches_of(const sewing::GarmentMesh& g, std::span<const Covers> covers, Index panel,
                                std::span<const Vec3> x) {
  const Index first = g.first_vertex[panel], end = g.first_vertex[panel + 1];
  std::vector<Vec3> sum(static_cast<std::size_t>(end - first));
  std::vector<int> count(sum.size(), 0);
  for (const auto& [i, j] : g.sewn) {
    for (const auto& [mine, other] : {std::pair{i, j}, std::pair{j, i}}) {
      if (g.panel_of_vertex[mine] != panel || g.panel_of_vertex[other] == panel) continue;
      if (covers[static_cast<std::size_t>(g.panel_of_vertex[other])] != Covers::kTrunk) continue;
      sum[static_cast<std::size_t>(mine - first)] += x[other];
      ++count[static_cast<std::size_t>(mine - first)];
    }
  }
  std::vector<Stitch> stitches;
  for (std::size_t k = 0; k < sum.size(); ++k)
    if (count[k] > 0) stitches.push_back({g.rest[first + static_cast<Index>(k)], sum[k] * (1.0 / count[k])});
  return stitches;
}

bool closes_in_itself(const sewing::GarmentMesh& g, Index panel) {
  return std::any_of(g.sewn.begin(), g.sewn.end(), [&](const auto& pair) {
    return g.panel_of_vertex[pair[0]] == panel && g.panel_of_vertex[pair[1]] == panel;
  });
}

bool is_long_strip(const sewing::GarmentMesh& g, Index panel, const std::vector<Stitch>& stitches) {
  Aabb2 all, held;
  for (Index v = g.first_vertex[panel]; v < g.first_vertex[panel + 1]; ++v) all.add(g.rest[v]);
  for (const Stitch& s : stitches) held.add(s.rest);
  if (stitches.size() < 2) return false;
  const Vec2 size = all.size(), sewn = held.size();
  const double longest = std::max(size.x, size.y), breadth = std::min(size.x, size.y);
  return longest > kLong && longest > kAspect * breadth && std::max(sewn.x, sewn.y) > kHeldLeast * longest &&
         std::min(sewn.x, sewn.y) < 0.5 * breadth;
}

}  // namespace

void lay_on_stitches(const sewing::Assembly& assembly, std::span<const Covers> covers, std::vector<Vec3>& x) {
  const sewing::GarmentMesh& g = assembly.garment;
  for (Index p = 0; p + 1 < static_cast<Index>(g.first_vertex.size()); ++p) {
    if (covers[static_cast<std::size_t>(p)] == Covers::kTrunk) continue;
    const std::vector<Stitch> stitches = stitches_of(g, covers, p, x);
    if (!is_long_strip(g, p, stitches) || closes_in_itself(g, p)) continue;
    for (Index v = g.first_vertex[p]; v < g.first_vertex[p + 1]; ++v) {
      const auto nearest =
          std::min_element(stitches.begin(), stitches.end(), [&](const Stitch& a, const Stitch& b) {
            return length(a.rest - g.rest[v]) < length(b.rest - g.rest[v]);
          });
      const double off = std::min(kOff, length(nearest->rest - g.rest[v]));
      x[v] = nearest->there + Vec3{0, 0, std::copysign(off, nearest->there.z)};
    }
  }
}

}  // namespace toile::dressing
