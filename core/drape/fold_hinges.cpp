#include "core/drape/fold_hinges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/mesh/topology.h"

namespace toile::drape {

namespace {

using solver::constraints::FoldHinge;
using Ends = std::pair<Index, Index>;  ///< of an edge, the lesser first

/// Sines differ in their last bit between processors; the same input must give the same bytes.
double rounded(double value) { return std::nearbyint(value * 0x1p40) / 0x1p40; }

/// A hinge of the crease along an edge of the flat cloth, its vertices still to be told.
FoldHinge hinge_of(const sewing::Crease& crease, double edge_length) {
  FoldHinge hinge;
  hinge.half_sine = rounded(std::sin(crease.angle / 2));
  hinge.half_cosine = rounded(std::cos(crease.angle / 2));
  hinge.stiffness = crease.stiffness * edge_length;
  return hinge;
}

/// A triangle at an edge, and its corner beyond it.
struct Wing {
  Index panel = kNone, tip = kNone;
};

/// The triangles at each edge of the cloth as far as it is sewn, in the solver's vertices.
std::map<Ends, std::vector<Wing>> wings_of(const sewing::GarmentMesh& g, std::span<const Index> vertex_of) {
  std::map<Ends, std::vector<Wing>> wings;
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t i) { return vertex_of[g.triangles[t][(k + i) % 3]]; };
      wings[std::minmax({at(0), at(1)})].push_back({g.panel_of_triangle[t], at(2)});
    }
  }
  return wings;
}

void add_along_seam(const sewing::Crease& crease, const std::vector<Index>& chain,
                    const sewing::GarmentMesh& g, const std::map<Ends, std::vector<Wing>>& wings,
                    std::span<const Index> vertex_of, std::vector<FoldHinge>& hinges) {
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const Index a = vertex_of[chain[k]], b = vertex_of[chain[k + 1]];
    const auto found = wings.find(std::minmax({a, b}));
    if (a == b || found == wings.end() || found->second.size() != 2) continue;
    const bool first = found->second[0].panel == crease.panel;
    FoldHinge hinge = hinge_of(crease, length(g.rest[chain[k + 1]] - g.rest[chain[k]]));
    hinge.e0 = a;
    hinge.e1 = b;
    hinge.left = found->second[first ? 0 : 1].tip;  // an outline has its piece to the left
    hinge.right = found->second[first ? 1 : 0].tip;
    hinge.turned = true;
    hinges.push_back(hinge);
  }
}

std::map<Ends, mesh::MeshEdge> edges_of(const sewing::GarmentMesh& g) {
  std::map<Ends, mesh::MeshEdge> edges;
  for (const mesh::MeshEdge& e : mesh::edges_of(g.triangles, g.vertex_count()))
    edges.emplace(std::minmax(e.v0, e.v1), e);
  return edges;
}

/// Edges about which something begins, or was, turned over.
std::set<Ends> turned_edges(const sewing::Assembly& assembly) {
  std::set<Ends> turned;
  for (const auto& [a, b] : assembly.turned) turned.insert(std::minmax(a, b));
  for (const sewing::PressedBack& back : assembly.pressed_back)
    for (std::size_t k = 0; k + 1 < back.along.size(); ++k)
      turned.insert(std::minmax(back.along[k], back.along[k + 1]));
  return turned;
}

}  // namespace

std::vector<FoldHinge> fold_hinges(const std::vector<sewing::Crease>& creases,
                                   const sewing::Assembly& assembly, std::span<const Index> vertex_of) {
  std::vector<FoldHinge> hinges;
  if (creases.empty()) return hinges;
  const sewing::GarmentMesh& g = assembly.garment;
  const std::map<Ends, mesh::MeshEdge> edges = edges_of(g);
  const std::map<Ends, std::vector<Wing>> wings = wings_of(g, vertex_of);
  const std::set<Ends> turned = turned_edges(assembly);
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const sewing::VertexChains& chains = assembly.notions.creases[i];
    for (std::size_t c = 0; c < chains.size(); ++c) {
      if (c < creases[i].edges.size()) {
        add_along_seam(creases[i], chains[c], g, wings, vertex_of, hinges);
        continue;
      }
      for (std::size_t k = 0; k + 1 < chains[c].size(); ++k) {
        const auto found = edges.find(std::minmax(chains[c][k], chains[c][k + 1]));
        if (found == edges.end() || found->second.t1 == kNone) continue;
        const mesh::MeshEdge& e = found->second;
        FoldHinge hinge = hinge_of(creases[i], length(g.rest[e.v1] - g.rest[e.v0]));
        hinge.e0 = vertex_of[e.v0];
        hinge.e1 = vertex_of[e.v1];
        hinge.left = vertex_of[e.opposite0];
        hinge.right = vertex_of[e.opposite1];
        hinge.turned = turned.contains(found->first);
        hinges.push_back(hinge);
      }
    }
  }
  return hinges;
}

}  // namespace toile::drape
