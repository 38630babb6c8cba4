#include "core/collision/surface.h"

#include <algorithm>
#include <numeric>

namespace toile::collision {

Surface make_surface(std::span<const Tri> triangles, Index vertex_count,
                     std::span<const Index> vertex_class) {
  Surface surface;
  surface.triangles.assign(triangles.begin(), triangles.end());
  surface.owned.assign(triangles.size(), 0);
  surface.vertex_class.assign(vertex_class.begin(), vertex_class.end());
  if (surface.vertex_class.empty()) {
    surface.vertex_class.resize(vertex_count);
    std::iota(surface.vertex_class.begin(), surface.vertex_class.end(), 0);
  }

  struct Half {
    Index v0, v1, triangle;
    int corner;
  };
  std::vector<Half> halves;
  halves.reserve(3 * triangles.size());
  std::vector<bool> vertex_taken(vertex_count, false);
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Index i = triangles[t][k], j = triangles[t][(k + 1) % 3];
      halves.push_back({std::min(i, j), std::max(i, j), t, k});
      if (!vertex_taken[i]) {
        vertex_taken[i] = true;
        surface.owned[t] |= 1u << k;
      }
    }
  }
  std::stable_sort(halves.begin(), halves.end(),
                   [](const Half& a, const Half& b) { return a.v0 != b.v0 ? a.v0 < b.v0 : a.v1 < b.v1; });
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const bool first = i == 0 || halves[i].v0 != halves[i - 1].v0 || halves[i].v1 != halves[i - 1].v1;
    std::uint8_t& owned = surface.owned[halves[i].triangle];
    if (first) owned = static_cast<std::uint8_t>(owned | 8u << halves[i].corner);
  }
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (surface.owned[t] >> k & 1) surface.vertices.push_back(triangles[t][k]);
      if (surface.owned[t] >> (3 + k) & 1)
        surface.edges.push_back({triangles[t][k], triangles[t][(k + 1) % 3]});
    }
  }
  return surface;
}

}  // namespace toile::collision
