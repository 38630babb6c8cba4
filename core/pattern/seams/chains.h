#pragma once
// Free runs one after the other along a border, which may be a side of a seam together.

#include <cstddef>
#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Free runs one after the other along one of the garment's borders.
struct Chain {
  std::size_t border = 0, first = 0;
  std::vector<Index> runs;
  double length = 0;
  bool whole = false;  ///< all of its border
};

/// All chains of the borders without a `locked` run or a fold: those of eight runs at most, and whole
/// borders.
std::vector<Chain> chains_of(const SeamModel& model, const std::vector<std::vector<Index>>& borders,
                             const std::vector<char>& locked);

/// Whether a run is in both.
bool overlap(const Chain& a, const Chain& b);

/// mm from the chain's start at which its runs meet, ascending.
std::vector<double> corners_of(const SeamModel& model, const std::vector<Index>& runs);

/// Corners of b run backwards, scaled to a's length, ascending.
std::vector<double> seen_from(const SeamModel& model, const Chain& a, const Chain& b);

/// mm that corners of two chains of that length may lie apart and still meet.
double meeting_distance(double length_mm);

}  // namespace toile::seams
