#include "core/sewing/assembly.h"

#include <algorithm>
#include <iterator>

#include "core/base/disjoint_sets.h"
#include "core/base/snapped.h"
#include "core/sewing/attached_places.h"

namespace toile::sewing {

namespace {

void append_panel(const mesh::PanelMesh& mesh, Index panel, GarmentMesh& garment) {
  const Index first = garment.vertex_count();
  garment.first_vertex.push_back(first);
  garment.rest.insert(garment.rest.end(), mesh.rest.begin(), mesh.rest.end());
  garment.panel_of_vertex.insert(garment.panel_of_vertex.end(), mesh.rest.size(), panel);
  for (const Tri& t : mesh.triangles) garment.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  garment.panel_of_triangle.insert(garment.panel_of_triangle.end(), mesh.triangles.size(), panel);
}

void append_seams(const mesh::PanelMeshes& meshes, GarmentMesh& garment) {
  const auto index = [&](mesh::PanelVertex v) { return garment.first_vertex[v.panel] + v.vertex; };
  for (const mesh::MatchedSeam& seam : meshes.seams) {
    for (const mesh::SewnPair& pair : seam.pairs) {
      garment.sewn.push_back({index(pair.a), index(pair.b)});
      garment.seam_of_sewn.push_back(seam.seam);
    }
  }
}

/// Of each vertex of the panels, whether a seam holds it.
std::vector<std::vector<bool>> held_by_seams(const mesh::PanelMeshes& meshes) {
  std::vector<std::vector<bool>> held;
  for (const mesh::PanelMesh& mesh : meshes.panels) held.emplace_back(mesh.rest.size(), false);
  for (const mesh::MatchedSeam& seam : meshes.seams)
    for (const mesh::SewnPair& pair : seam.pairs)
      for (const mesh::PanelVertex& v : {pair.a, pair.b}) held[v.panel][v.vertex] = true;
  return held;
}

void add_folded(const PlacedPiece& piece, Index first, Assembly& assembly) {
  for (const auto& [a, b] : piece.turned) assembly.turned.push_back({a + first, b + first});
  for (PressedBack back : piece.pressed_back) {
    for (std::vector<Index>* vertices : {&back.along, &back.fall})
      for (Index& v : *vertices) v += first;
    assembly.pressed_back.push_back(std::move(back));
  }
}

}  // namespace

std::vector<Index> least_of_class(Index vertex_count, const std::vector<std::array<Index, 2>>& joined) {
  DisjointSets classes(static_cast<std::size_t>(vertex_count));
  for (const auto& [i, j] : joined) classes.join(i, j);
  std::vector<Index> least;
  least.reserve(static_cast<std::size_t>(vertex_count));
  for (Index i = 0; i < vertex_count; ++i) least.push_back(classes.root(i));
  return least;
}

JoinedVertices joined_vertices(const GarmentMesh& garment, const std::vector<bool>& joined) {
  JoinedVertices now;
  now.vertex_of.assign(joined.size(), kNone);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const Index least = garment.weld[i];
    const bool own = static_cast<Index>(i) == least || !joined[i];
    now.vertex_of[i] = own ? now.count++ : now.vertex_of[least];
  }
  return now;
}

std::vector<Vec3> together_at_means(const GarmentMesh& garment, std::span<const Vec3> positions) {
  std::vector<Vec3> mean(positions.size());
  std::vector<int> count(positions.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    mean[garment.weld[i]] += positions[i];
    ++count[garment.weld[i]];
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (garment.weld[i] == static_cast<Index>(i)) mean[i] = mean[i] * (1.0 / count[i]);
    mean[i] = mean[garment.weld[i]];  // the least of its class, which comes before it
  }
  return mean;
}

std::vector<double> seam_held_by_pairs(const GarmentMesh& g) {
  std::vector<std::array<double, 2>> sides(g.sewn.size(), {0, 0});
  for (std::size_t k = 1; k < g.sewn.size(); ++k) {
    if (g.seam_of_sewn[k] != g.seam_of_sewn[k - 1]) continue;
    for (int side = 0; side < 2; ++side) {
      const Index a = g.sewn[k - 1][side], b = g.sewn[k][side];
      if (g.panel_of_vertex[a] != g.panel_of_vertex[b]) continue;  // the seam goes on to another piece
      const double half = 0.5 * length(g.rest[b] - g.rest[a]);
      sides[k - 1][side] += half;
      sides[k][side] += half;
    }
  }
  std::vector<double> held;
  held.reserve(sides.size());
  for (const auto& side : sides) held.push_back(std::min(side[0], side[1]));
  return held;
}

Result<Assembly> assemble(const mesh::PanelMeshes& meshes, const std::vector<Placement>& placements,
                          const std::vector<Attachment>& attachments, const Notions& notions) {
  if (placements.size() != meshes.panels.size()) {
    return Error{"placement.count", "every piece needs a placement",
                 std::to_string(placements.size()) + " placements for " +
                     std::to_string(meshes.panels.size()) + " pieces"};
  }
  Assembly assembly;
  const std::vector<std::vector<bool>> held = held_by_seams(meshes);
  for (std::size_t i = 0; i < meshes.panels.size(); ++i) {
    append_panel(meshes.panels[i], static_cast<Index>(i), assembly.garment);
    std::vector<Crease> creases;
    std::copy_if(notions.creases.begin(), notions.creases.end(), std::back_inserter(creases),
                 [&](const Crease& c) { return c.panel == static_cast<Index>(i); });
    const PlacedPiece piece = placed_folded(meshes.panels[i], placements[i], creases, held[i]);
    const std::vector<Vec3>& placed = piece.positions;
    if (!std::all_of(placed.begin(), placed.end(), [](Vec3 p) { return is_finite(p) && length(p) < 100; })) {
      return Error{"placement.not_finite", "the placement puts the piece nowhere, or over 100 m away",
                   "piece number " + std::to_string(i + 1)};
    }
    for (const Vec3& p : placed) assembly.positions.push_back(snapped(p));
    add_folded(piece, assembly.garment.first_vertex.back(), assembly);
  }
  assembly.garment.first_vertex.push_back(assembly.garment.vertex_count());
  append_seams(meshes, assembly.garment);
  TRY(locate_attachments(attachments, meshes, assembly));
  assembly.garment.weld = least_of_class(assembly.garment.vertex_count(), assembly.garment.sewn);
  NotionPlaces places = TRY(locate_notions(notions, meshes, assembly.garment));
  assembly.notions = std::move(places);
  return assembly;
}

}  // namespace toile::sewing
