#pragma once
// Equations 3 and 4 of Kim and Park 2003: Verlet's integrator, and its damping.

#include "core/base/types.h"

namespace toile::paper {

/// Where a particle is after a step (m). Equation 3 is read x_new = 2x − x_prev + (F/m)·Δt²: in print the
/// square is missing, without which the units do not agree. Equation 4 takes C·(x − x_prev)/m off the force:
/// put into equation 3, a particle loses the share d = C·Δt²/m² of its way with each step. With particles of
/// 4e-5 kg no C near 1 could be chosen, so d itself is what is set, from 0 to below 1. `acceleration` is F/m
/// (m/s²), `time_step` in s.
inline Vec3 next_place(Vec3 x, Vec3 previous, Vec3 acceleration, double time_step, double damping) {
  return x + (x - previous) * (1 - damping) + acceleration * (time_step * time_step);
}

}  // namespace toile::paper
