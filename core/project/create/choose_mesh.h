#pragma once
// How fine a new project's cloth is cut into triangles.

#include "core/pattern/pattern.h"
#include "core/project/project.h"

namespace toile::create {

/// Particle distance (mm) for cloth of that area (mm²): the default, or so much more, up to 25 mm, that the
/// mesh has some 6000 particles; a wide dress at 15 mm would have five times as many, and drape for minutes.
/// Particles lie in equilateral triangles, each on √3/2 d² of cloth.
double distance_for(double area);

/// Sets the project's particle distance for the pattern's cloth, and the time step with it, so that a wave
/// crosses as much of an edge in a step as by default. Does nothing where the default is fine enough.
void choose_mesh(const pattern::Pattern& pattern, project::ProjectSettings& settings);

}  // namespace toile::create
