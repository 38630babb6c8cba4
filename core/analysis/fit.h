#pragma once
// How a garment fits whoever wears it: girths of both where a tailor takes them, and what lies between.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/preflight/finding.h"

namespace toile::analysis {

enum class Fit : std::uint8_t {
  kFits,       ///< as wide as the body or wider
  kStretched,  ///< narrower, and the cloth gives without pressing
  kTooTight,   ///< narrower than the cloth gives
};
/// "fits", "stretched", "too_tight".
std::string_view word_of(Fit fit);

/// One line of the table. Girths are of one plane: the body's as a tape takes it, over hollows; the garment's
/// as its flat pieces measure along the shortest way around.
struct FitLine {
  std::string place;  ///< "bust", "waist", "hip", "thigh_left", "upper_arm_right", …
  double shifted =
      0;  ///< m, how far above where that girth is usually taken: the nearest that the garment has
  double body = 0, garment = 0;  ///< m
  double worn = 0;               ///< m, of the garment as it hangs, stretch and folds included
  double tight_by = 0;           ///< m, that it should be wider; 0 where it is not too tight
  std::vector<std::string> pieces;
  std::vector<Vec3> way;  ///< m, where it runs
  Vec3 at;                ///< m, in the middle of the body there
  Fit fit = Fit::kFits;

  double ease() const { return garment - body; }
};

/// The table, from the top down; empty where nobody stands there, or for a place that the cloth does not go
/// around.
std::vector<FitLine> fit_table(const drape::DrapeInput& input, const drape::DrapeResult& result);

/// "waist 2.1 cm too tight", "bust 8.0 cm of ease", "hip 3.0 cm narrower than the body, the cloth stretches
/// by 3 %".
std::string fit_text(const FitLine& line);

/// Findings "fit.too_tight".
preflight::Findings find_too_tight(const std::vector<FitLine>& table);

}  // namespace toile::analysis
