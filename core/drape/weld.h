#pragma once
// Makes one vertex of sewn ones, which moves them: within the bounds of contact, as every step does. Looking
// for crossings afterwards would not do: what a weld carries through a layer by less than the count's
// rounding lies on its other side for ever.

#include <span>
#include <vector>

#include "core/collision/obstacle.h"
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

/// Joins each class of sewn vertices that lies within `reach` (m) of its mean, unless one of them would leave
/// what contact leaves free to it. `positions` are the garment's vertices, which cross neither cloth nor
/// body.
Weld weld_seams(const sewing::GarmentMesh& garment, std::span<const Vec3> positions, double reach,
                std::span<const collision::Obstacle> obstacles);

/// The velocities of the solver's vertices after a weld, with the momentum of the parts, so that it neither
/// starts nor stops anything. `before` and `after` give each garment vertex its solver vertex; masses and
/// velocities are those of before.
std::vector<Vec3> velocities_of_joined(std::span<const Index> before, const Weld& after,
                                       std::span<const double> mass, std::span<const Vec3> velocities);

}  // namespace toile::drape
