#pragma once
// A triangle surface prepared for pairwise tests. Every vertex and every edge is owned by one of its
// triangles; when two triangles come near each other, only features that they own are paired, so that each
// pair of features is found exactly once.

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::collision {

struct Surface {
  std::vector<Tri> triangles;
  std::vector<Index> vertices;              ///< that a triangle has, each once
  std::vector<std::array<Index, 2>> edges;  ///< each once, as its owner goes along it
  /// Bits 0 to 2: the triangle owns its corner k. Bits 3 to 5: it owns the edge from corner k to corner k+1.
  std::vector<std::uint8_t> owned;
  /// Vertices of the same class count as one for neighbourhood (a stitched pair); least member's index.
  std::vector<Index> vertex_class;

  Index vertex_count() const { return static_cast<Index>(vertex_class.size()); }
};

/// Prepares a surface. `vertex_class` may be empty: every vertex is then its own class.
Surface make_surface(std::span<const Tri> triangles, Index vertex_count,
                     std::span<const Index> vertex_class = {});

}  // namespace toile::collision
