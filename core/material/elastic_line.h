#pragma once
// How a strip that is clamped level at one end hangs under its own weight.

#include <vector>

#include "core/base/types.h"

namespace toile::material {

/// `steps` + 1 points along an elastic line of length 1 that leaves its clamp, at the origin, level along x
/// and bends down: B θ'' = −w (1 − s) cos θ, θ falling, θ(0) = 0, θ'(1) = 0, with `load` w / B (Euler's
/// elastica under its weight; F. T. Peirce 1930). Found by shooting with the slope at the clamp.
std::vector<Vec2> elastic_line(double load, int steps);

}  // namespace toile::material
