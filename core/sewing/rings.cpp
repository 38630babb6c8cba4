#include "core/sewing/rings.h"

#include <algorithm>
#include <utility>

#include "core/mesh/topology.h"

namespace toile::sewing {

namespace {

/// Where pieces are sewn with their sides against each other the sewn triangles wind against each other; the
/// edge then counts as two borders. Those pairs are no border of the garment.
std::vector<mesh::MeshEdge> borders_of(std::span<const Tri> triangles, Index vertex_count) {
  std::vector<mesh::MeshEdge> edges = mesh::edges_of(triangles, vertex_count);
  const auto key = [](const mesh::MeshEdge& e) {
    return std::pair(std::min(e.v0, e.v1), std::max(e.v0, e.v1));
  };
  std::vector<mesh::MeshEdge> borders;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && key(edges[j]) == key(edges[i])) ++j;
    if (j == i + 1 && edges[i].t1 == kNone) borders.push_back(edges[i]);
    i = j;
  }
  return borders;
}

/// The border edges chained into closed lines, whichever way each runs.
std::vector<std::vector<Index>> chained(const std::vector<mesh::MeshEdge>& borders) {
  struct Half {
    Index from, to, edge;
  };
  std::vector<Half> halves;
  for (Index e = 0; e < static_cast<Index>(borders.size()); ++e) {
    halves.push_back({borders[e].v0, borders[e].v1, e});
    halves.push_back({borders[e].v1, borders[e].v0, e});
  }
  std::stable_sort(halves.begin(), halves.end(),
                   [](const Half& x, const Half& y) { return x.from < y.from; });
  std::vector<bool> used(borders.size(), false);
  std::vector<std::vector<Index>> rings;
  for (Index start = 0; start < static_cast<Index>(borders.size()); ++start) {
    if (used[start]) continue;
    used[start] = true;
    std::vector<Index> ring{borders[start].v0};
    Index at = borders[start].v1;
    while (at != ring.front()) {
      ring.push_back(at);
      auto next = std::lower_bound(halves.begin(), halves.end(), at,
                                   [](const Half& h, Index v) { return h.from < v; });
      while (next != halves.end() && next->from == at && used[next->edge]) ++next;
      if (next == halves.end() || next->from != at) break;
      used[next->edge] = true;
      at = next->to;
    }
    if (at == ring.front() && ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace

std::vector<Tri> sewn_triangles(const GarmentMesh& g) {
  std::vector<Tri> out;
  for (const Tri& t : g.triangles) {
    const Tri w{g.weld[t[0]], g.weld[t[1]], g.weld[t[2]]};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) out.push_back(w);
  }
  return out;
}

std::vector<std::vector<Index>> rings_of(const GarmentMesh& garment) {
  return chained(borders_of(sewn_triangles(garment), garment.vertex_count()));
}

}  // namespace toile::sewing
