#include "core/mesh/sewn_part.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace toile::mesh {
namespace {

/// Index of each panel's first vertex among all, and how many there are.
std::vector<Index> first_vertices(const PanelMeshes& meshes) {
  std::vector<Index> first{0};
  for (const PanelMesh& m : meshes.panels) first.push_back(first.back() + static_cast<Index>(m.rest.size()));
  return first;
}

double area_of(const PanelMesh& m) {
  double area = 0;
  for (const Tri& t : m.triangles)
    area += 0.5 * std::abs(cross(m.rest[t[1]] - m.rest[t[0]], m.rest[t[2]] - m.rest[t[0]]));
  return area;
}

/// An edge of the sewn cloth: how often it bounds a triangle, and how long it is, m.
struct SewnEdge {
  int times = 0;
  double length = 0;
};

/// Edges by their ends, which are roots of `vertices`.
std::map<std::pair<Index, Index>, SewnEdge> edges_of(const PanelMeshes& meshes,
                                                     const std::vector<Index>& first,
                                                     DisjointSets& vertices) {
  std::map<std::pair<Index, Index>, SewnEdge> edges;
  for (std::size_t m = 0; m < meshes.panels.size(); ++m) {
    const std::vector<Vec2>& rest = meshes.panels[m].rest;
    for (const Tri& t : meshes.panels[m].triangles) {
      for (int k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        const Index i = vertices.root(first[m] + a), j = vertices.root(first[m] + b);
        SewnEdge& edge = edges[{std::min(i, j), std::max(i, j)}];
        ++edge.times;
        edge.length = length(rest[b] - rest[a]);
      }
    }
  }
  return edges;
}

/// The length of every border, m, by one of its vertices.
std::map<Index, double> borders_of(const PanelMeshes& meshes, const std::vector<Index>& first,
                                   DisjointSets& vertices) {
  const std::map<std::pair<Index, Index>, SewnEdge> edges = edges_of(meshes, first, vertices);
  // Borders are told apart after their vertices have been joined along them.
  for (const auto& [ends, edge] : edges)
    if (edge.times == 1) vertices.join(ends.first, ends.second);
  std::map<Index, double> borders;
  for (const auto& [ends, edge] : edges)
    if (edge.times == 1) borders[vertices.root(ends.first)] += edge.length;
  return borders;
}

}  // namespace

std::vector<SewnPart> sewn_parts(const PanelMeshes& meshes) {
  const std::vector<Index> first = first_vertices(meshes);
  DisjointSets panels(meshes.panels.size()), vertices(static_cast<std::size_t>(first.back()));
  for (const MatchedSeam& seam : meshes.seams) {
    for (const SewnPair& p : seam.pairs) {
      panels.join(p.a.panel, p.b.panel);
      vertices.join(first[p.a.panel] + p.a.vertex, first[p.b.panel] + p.b.vertex);
    }
  }
  std::vector<SewnPart> parts;
  std::map<Index, std::size_t> part_of;
  for (Index p = 0; p < static_cast<Index>(meshes.panels.size()); ++p) {
    const auto [at, made] = part_of.try_emplace(panels.root(p), parts.size());
    if (made) parts.emplace_back();
    parts[at->second].panels.push_back(p);
    parts[at->second].area += area_of(meshes.panels[p]);
  }
  const auto part = [&](Index panel) -> SewnPart& { return parts[part_of.at(panels.root(panel))]; };
  for (const MatchedSeam& seam : meshes.seams)
    if (!seam.pairs.empty()) ++part(seam.pairs.front().a.panel).seams;
  for (const auto& [vertex, around] : borders_of(meshes, first, vertices)) {
    const auto after = std::upper_bound(first.begin(), first.end(), vertex);
    part(static_cast<Index>(after - first.begin()) - 1).borders.push_back(around);
  }
  for (SewnPart& each : parts) std::sort(each.borders.begin(), each.borders.end(), std::greater<>());
  return parts;
}

}  // namespace toile::mesh
