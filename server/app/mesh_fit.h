#pragma once
// How fine a project's triangles are against what its fabrics want, and what finer ones would cost.

#include <string>

#include "core/drape/drape_input.h"
#include "core/json/tree.h"

namespace toile::app {

struct MeshFit {
  double now = 0;      ///< m, the project's particle distance
  double fitting = 0;  ///< m, what fits the limpest of its fabrics (core/fabric/card.h)
  std::string fabric;  ///< title of that one
  double particles_now = 0, particles_fitting = 0;
  /// Of the time that a drape takes, about: it grows with the particles.
  double times() const { return particles_fitting / particles_now; }
};

MeshFit mesh_fit(const drape::DrapeInput& input);

json::JsonValue mesh_fit_json(const MeshFit& fit);

/// One sentence; empty where the triangles are as fine already.
std::string mesh_fit_text(const MeshFit& fit);

}  // namespace toile::app
