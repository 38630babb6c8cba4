#pragma once
// How fast does cloth swing, and how thick a medium brings it to rest soonest? A thin one lets it swing on, a
// thick one holds it up on its way: a short overhang swings four times as fast as a long skirt and wants four
// times the damping. After dynamic relaxation with a damping that follows the motion (Underwood, "Dynamic
// Relaxation", in Computational Methods for Transient Analysis, 1983).

#include <span>

namespace toile::drape {

/// Rate (1/s) at which a motion swings, by Rayleigh's quotient: with M ü + c M u̇ + K u = 0 for velocities u,
/// ω² = (u·K u)/(u·M u) = −u·(ü + c u̇)/(u·u), all vertices alike. `ways`: how far the vertices went (m, three
/// coordinates each) in three windows of `seconds` that follow each other. 0 for what does not swing: what
/// falls, creeps evenly or speeds up.
double rayleigh_rate(std::span<const float> first, std::span<const float> second,
                     std::span<const float> third, double seconds, double damping);

/// Damping (1/s) for cloth that swings at `rate` (1/s).
double calming_damping(double rate);

/// How far (m) something goes on that moves at `speed` (m/s), under this damping and swinging at this rate:
/// v/ω at most if it swings, v c/ω² if it creeps.
double way_left(double speed, double damping, double rate);

}  // namespace toile::drape
