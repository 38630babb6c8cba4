#pragma once
// Air inside a closed or nearly closed shape: each vertex is pushed by pressure times the volume's gradient,
// which is a third of each triangle's area around it along the normals. Openings are capped in thought by a
// fan around their middle, whose share their border carries, so that the forces of a shape cancel.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::constraints {

struct PressureChamber {
  std::vector<Tri> skin;                     ///< wound alike; normals point out
  std::vector<std::vector<Index>> openings;  ///< border lines, skin to the left
  double pressure = 0;                       ///< Pa above the outside; negative sucks
  double full_volume = 0;  ///< m³ at which the enclosed air has that pressure (p·V stays the same); 0: pumped
                           ///< at a constant pressure
};

/// A chamber of some of a cloth's triangles: wound like the first of each connected part, openings found.
PressureChamber make_chamber(std::span<const Tri> triangles, Index vertex_count, double pressure,
                             double full_volume);

/// m³; positive when the normals point out.
double volume_of(const PressureChamber& chamber, std::span<const Vec3> x);

/// Pa at that volume. Air of a fixed amount in a shape that is nearly empty has at most four times its
/// pressure: a flat cushion is filled, not blown up.
double pressure_at(const PressureChamber& chamber, double volume);

/// The force on each vertex, N; zero where the chamber is not. `out` has one entry a vertex and is added to.
void add_pressure(const PressureChamber& chamber, double pressure, std::span<const Vec3> x,
                  std::span<Vec3> out);

/// Changes velocities `v` by what the chambers push within `h` seconds, at `filled` (0 to 1) of their
/// pressure. `force` is room to work in.
void inflate(std::span<const PressureChamber> chambers, double filled, std::span<const double> w, double h,
             std::span<const Vec3> x, std::vector<Vec3>& force, std::span<Vec3> v);

}  // namespace toile::solver::constraints
