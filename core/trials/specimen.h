#pragma once
// Pieces of cloth as laboratories cut them.

#include <vector>

#include "core/material/fabric.h"
#include "core/pattern/pattern.h"
#include "core/solver/cloth_solver.h"

namespace toile::trials {

/// A piece alone, as the solver sees it.
struct Specimen {
  std::vector<Vec2> rest;  ///< m, where its vertices lie in the flat piece
  solver::ClothModel model;
};

/// A rectangle from 0 to `length` and 0 to `width`, mm, with vertices along the line x = `across` (0: none).
pattern::Panel rectangle(double length, double width, Vec2 warp, double across = 0);
/// A circle around 0, mm.
pattern::Panel circle(double radius, Vec2 warp);

/// REQUIRES a piece that can be meshed with edges of about `spacing` metres.
Specimen make_specimen(const pattern::Panel& panel, double spacing, const material::Fabric& fabric);
/// A rectangle's ends at x = 0 and `length` made one. `rest` has one entry a vertex, those at its end left
/// out. REQUIRES as of make_specimen, of a rectangle.
Specimen make_ring(const pattern::Panel& rectangle, double spacing, const material::Fabric& fabric);

/// Steps for `seconds` of simulated time.
void run(solver::ClothSolver& solver, const solver::StepForces& forces, double seconds);

}  // namespace toile::trials
