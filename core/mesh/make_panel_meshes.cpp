#include "core/mesh/make_panel_meshes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/mesh/resample.h"
#include "core/mesh/sample_lines.h"
#include "core/mesh/triangulate.h"

namespace toile::mesh {
namespace {

using EdgePoints = std::vector<std::vector<Vec2>>;

/// Calls f(first edge, one past the last) for the outline and each hole.
template <typename F>
void for_loops(const pattern::Panel& panel, F&& f) {
  std::size_t first = 0;
  const auto visit = [&](const pattern::Loop& loop) {
    f(first, first + loop.edges.size());
    first += loop.edges.size();
  };
  visit(panel.outline);
  for (const pattern::Loop& hole : panel.holes) visit(hole);
}

std::vector<Polygon> polygons_of(const pattern::Panel& panel, const EdgePoints& edges) {
  std::vector<Polygon> polygons;
  for_loops(panel, [&](std::size_t first, std::size_t last) {
    Polygon polygon;
    for (std::size_t e = first; e < last; ++e) {
      polygon.insert(polygon.end(), edges[e].begin(), edges[e].end() - 1);
    }
    polygons.push_back(std::move(polygon));
  });
  return polygons;
}

/// The border's vertices edge by edge; the last of each is the first of the next.
std::vector<std::vector<Index>> edge_vertices_of(const pattern::Panel& panel, const EdgePoints& edges,
                                                 const std::vector<Index>& border) {
  std::vector<std::vector<Index>> vertices(edges.size());
  std::size_t loop_start = 0;
  for_loops(panel, [&](std::size_t first, std::size_t last) {
    std::size_t loop_size = 0;
    for (std::size_t e = first; e < last; ++e) loop_size += edges[e].size() - 1;
    std::size_t offset = 0;
    for (std::size_t e = first; e < last; ++e) {
      for (std::size_t k = 0; k < edges[e].size(); ++k) {
        vertices[e].push_back(border[loop_start + (offset + k) % loop_size]);
      }
      offset += edges[e].size() - 1;
    }
    loop_start += loop_size;
  });
  return vertices;
}

Result<PanelMesh> mesh_panel(const pattern::Panel& panel, const EdgePoints& edges,
                             const std::vector<Polygon>& polygons,
                             const std::vector<std::vector<Vec2>>& lines, double particle_distance,
                             const RunContext& context) {
  Result<FlatMesh> flat = triangulate(polygons, particle_distance, context, lines);
  if (!flat) return placed_at(flat.error(), "piece " + panel.id);
  PanelMesh mesh;
  mesh.edge_vertices = edge_vertices_of(panel, edges, flat->border);
  mesh.line_vertices = std::move(flat->lines);
  mesh.rest = std::move(flat->points);
  mesh.triangles = std::move(flat->triangles);
  const Vec2 warp = normalized(panel.grain);
  if (is_finite(warp) && length(warp) > 0) mesh.warp = warp;
  return mesh;
}

MatchedSeam matched_seam(Index index, const SampledSeam& sampled, const std::vector<PanelMesh>& panels) {
  MatchedSeam seam{index, {}, sampled.length_a, sampled.length_b};
  const auto vertex_of = [&](const EdgeSample& s) {
    return PanelVertex{s.panel, panels[s.panel].edge_vertices[s.edge][s.sample]};
  };
  for (const SampledSeam::Pair& p : sampled.pairs) {
    const SewnPair pair{vertex_of(p.a), vertex_of(p.b)};
    const bool repeats =
        !seam.pairs.empty() && seam.pairs.back().a == pair.a && seam.pairs.back().b == pair.b;
    if (!repeats && !(pair.a == pair.b)) seam.pairs.push_back(pair);
  }
  return seam;
}

Status check_size(const pattern::Pattern& pattern, const std::vector<std::vector<Polygon>>& panels,
                  double particle_distance) {
  double particles = 0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double area = std::fabs(enclosed_area(panels[p]));
    particles += particle_estimate(area, pattern::spacing_on(pattern.panels[p], particle_distance));
  }
  if (particles <= kMaxParticles) return {};
  return Error{"mesh.too_many_particles",
               "The pattern would have about " + std::to_string(std::llround(std::min(particles, 1e15))) +
                   " particles, and 500000 is the most; choose a larger particle distance.",
               ""};
}

}  // namespace

Result<PanelMeshes> make_panel_meshes(const pattern::Pattern& pattern, double particle_distance,
                                      const RunContext& context) {
  SampledPattern sampled = TRY(resample(pattern, particle_distance));
  const auto lines = TRY(sample_lines(pattern, particle_distance, sampled));
  const std::size_t count = pattern.panels.size();
  std::vector<std::vector<Polygon>> polygons;
  for (std::size_t p = 0; p < count; ++p) {
    polygons.push_back(polygons_of(pattern.panels[p], sampled.edges[p]));
  }
  TRY(check_size(pattern, polygons, particle_distance));
  PanelMeshes meshes;
  for (std::size_t p = 0; p < count; ++p) {
    context.progress("mesh", static_cast<double>(p) / static_cast<double>(count));
    PanelMesh mesh = TRY(mesh_panel(pattern.panels[p], sampled.edges[p], polygons[p], lines[p],
                                    pattern::spacing_on(pattern.panels[p], particle_distance), context));
    meshes.panels.push_back(std::move(mesh));
  }
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    meshes.seams.push_back(matched_seam(static_cast<Index>(s), sampled.seams[s], meshes.panels));
  }
  context.progress("mesh", 1);
  return meshes;
}

}  // namespace toile::mesh
