#pragma once
// The method of S. Kim and C. K. Park, "Fast Garment Drape Simulation Using Geometrically Constrained
// Particle System" (2003), whole and in a room of its own: a second way to drape, to compare with and to
// learn from. Each equation stands in a header of its own with the reading that was chosen, since the paper
// as it is printed leaves some of them open.

namespace toile::paper {

/// s; its steps are long, and viewers see so much of simulated time between two frames.
inline constexpr double kFrameTime = 1.0 / 30;

/// What the paper leaves to its user. Defaults are the best that a search over samples found
/// (tests/bench/paper_search.csv).
struct PaperSettings {
  double time_step = 1.0 / 500;  ///< s, of the Verlet integrator
  double damping = 0.3;          ///< share of its way that a particle loses with each step, 0 to below 1
  int passes = 5;                ///< over all links, seams and held particles, a step
  double reflection = 0;         ///< share of its way that a particle keeps, mirrored, where it strikes
  /// N/m. ε_max of a link is what its fabric is stretched by under this load, its limit at most: the method
  /// lets cloth stretch so far for nothing. 490 gives the fabric's coefficients
  /// (core/material/coefficients.h).
  double load = 2;
  /// m. Bodies are met so far outside their skin at least: of a link only the ends are tried, and between
  /// them it cuts through what is round.
  double clearance = 4e-3;
};

}  // namespace toile::paper
