#pragma once
// Makes one vertex of sewn ones. A weld that would make a crossing is not done.

#include <span>
#include <vector>

#include "core/collision/crossings.h"
#include "core/sewing/garment_mesh.h"

namespace toile::drape {

struct Weld {
  std::vector<Index> vertex_of;  ///< solver vertex of each garment vertex
  Index vertex_count = 0;        ///< solver vertices
  std::vector<Vec3> positions;   ///< m, of the solver vertices
  std::vector<Index> refused;    ///< weld classes (GarmentMesh::weld) that stayed open
};

/// The solver's vertices when each garment vertex that is marked in `joined` is one with the least vertex of
/// its class. Positions and refused classes stay empty.
Weld joined_as(const sewing::GarmentMesh& garment, const std::vector<bool>& joined);

/// Every garment vertex for itself.
Weld no_weld(std::span<const Vec3> positions);

/// Joins each class of sewn vertices that lies within `reach` (m) of its mean, unless that crosses cloth or
/// body. `positions` are the garment's vertices.
Weld weld_seams(const sewing::GarmentMesh& garment, std::span<const Vec3> positions, double reach,
                std::span<const collision::CrossingBody> bodies);

/// The velocities of the solver's vertices after a weld, with the momentum of the parts, so that it neither
/// starts nor stops anything. `before` and `after` give each garment vertex its solver vertex; masses and
/// velocities are those of before.
std::vector<Vec3> velocities_of_joined(std::span<const Index> before, const Weld& after,
                                       std::span<const double> mass, std::span<const Vec3> velocities);

}  // namespace toile::drape
