#pragma once
// Drapes a random garment and looks at everything that must never be.

#include <string>
#include <vector>

#include "tests/garments/random_garment.h"

namespace toile::test {

struct TrialReport {
  std::string end;  ///< stop_reason, "refused" or "cancelled"
  std::string refusal;
  int particles = 0, steps = 0, frames = 0;
  double thread = 0;        ///< m, the longest at the start
  double speed = 0;         ///< m/s, the fastest vertex over a few steps
  double stretch = 0;       ///< longest over rest length in any direction of any triangle, once sewn
  double most_stretch = 0;  ///< that the loads of this garment allow
  double cpu_s = 0;
  std::vector<std::string> faults;  ///< empty: all is well

  bool refused() const { return end == "refused"; }
};

/// Faults: a crossing at a frame; a position that is no number or far from where anything can be; a vertex
/// faster than anything falls or is pulled; cloth stretched beyond what forces there are; a drape that does
/// not end by itself or without a reason; fewer than 100 frames of a drape that ran to its end in 100 steps
/// or more; a cancel that is not obeyed; a refusal that names no place. With `dump`, a folder, starts, ends
/// and, where there was a crossing, the worst frame are written there as OBJ.
TrialReport try_garment(const RandomGarment& garment, const std::string& dump);

/// One line about a trial, for people.
std::string line_of(std::uint64_t seed, const RandomGarment& garment, const TrialReport& report);

}  // namespace toile::test
