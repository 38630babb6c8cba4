#pragma once
// Which parts of a pattern's edges seams want.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::seams {

/// The edges of side a, then of side b.
std::vector<pattern::SeamEdge> both_sides(const pattern::Seam& seam);

/// Says "reversed" for a whole side by the seam's direction, as people would.
void say_plainly(pattern::Seam& seam);

/// Edges that seams have taken.
class TakenEdges {
 public:
  /// Whether a part of one of its edges is taken: parts that meet share nothing.
  bool clashes(const pattern::Seam& seam) const;
  /// Whether a part of one of its edges is sewn, and this is more of it: a sleeve is not set in by half.
  bool goes_on(const pattern::Seam& seam) const;
  void take(const pattern::Seam& seam);

 private:
  std::vector<pattern::SeamEdge> taken_;
};

}  // namespace toile::seams
