#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/base/types.h"
#include "core/mesh/lattice.h"

namespace toile::mesh {

/// A flat piece as triangles, vertices in Morton order.
struct FlatMesh {
  std::vector<Vec2> points;               ///< m; border points bit for bit as given
  std::vector<Tri> triangles;             ///< counter-clockwise
  std::vector<Index> border;              ///< vertex of each given border point, loop after loop
  std::vector<std::vector<Index>> lines;  ///< vertex of each point of each given line
};

/// Near-equilateral triangles of edge length `particle_distance` (m) on the piece that loops[0]
/// (counter-clockwise) bounds, less the holes loops[1 …] (clockwise). All given points are vertices, and no
/// others stand on the border: sample it at about the particle distance before. Hexagonal lattice inside,
/// constrained Delaunay triangulation on a grid of 0.1 µm with exact tests, then smoothing, and points added
/// or taken where edges are too long or too short. Same input, same bytes.
///
/// `lines` are open polylines through the piece, sampled likewise: edges of the mesh lie on them. A point of
/// a line that equals a point of the border, or of another line, is one with it.
///
/// Errors (`where` is empty; messages give places in mm): "mesh.too_few_points", "mesh.not_finite",
/// "mesh.piece_too_large" (over 13.4 m), "mesh.zero_area", "mesh.outline_crosses", "mesh.outline_touches",
/// "mesh.outline_winding" (an outline clockwise, a hole counter-clockwise or not inside),
/// "mesh.line" (a line that leaves the piece, or crosses or touches the outline or a line between its
/// points), "mesh.too_many_particles", "cancelled".
Result<FlatMesh> triangulate(std::span<const Polygon> loops, double particle_distance,
                             const RunContext& context, std::span<const std::vector<Vec2>> lines = {});

/// Signed area of loops[0] (positive when counter-clockwise) less that of the holes.
double enclosed_area(std::span<const Polygon> loops);

inline constexpr double kMaxParticles = 500'000;  ///< that a garment may have; bounds memory and time

/// Particles that cloth of `area` m² will have.
double particle_estimate(double area, double particle_distance);

}  // namespace toile::mesh
