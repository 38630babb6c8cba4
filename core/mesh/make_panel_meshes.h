#pragma once

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"

namespace toile::mesh {

/// Homogeneous triangles of edge length `particle_distance` (m) on every panel that asks for no spacing of
/// its own, both sides of each seam with
/// the same number of particles, as in S. Kim and C. K. Park, "Fast Garment Drape Simulation Using
/// Geometrically Constrained Particle System" (2003). A small piece keeps at least one segment per edge.
/// Where a dart's two sides meet in one vertex, its seam has no pair for that vertex.
///
/// Errors are those of resample and triangulate; `where` names the piece, edge or seam.
/// "mesh.too_many_particles" counts the whole pattern.
Result<PanelMeshes> make_panel_meshes(const pattern::Pattern& pattern, double particle_distance,
                                      const RunContext& context);

}  // namespace toile::mesh
