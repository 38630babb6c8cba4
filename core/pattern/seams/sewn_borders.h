#pragma once
// The borders of sewn cloth.

#include <vector>

#include "core/pattern/seams/sewn_points.h"

namespace toile::seams {

/// Runs that are sewn to nothing come together to borders at the points where they meet. Those that lead
/// through no point that has changed stay as they were.
class SewnBorders {
 public:
  /// Nothing is sewn. The model must outlive it.
  explicit SewnBorders(const SeamModel& model);

  /// Run r is sewn from now on. renew() must follow.
  void leave(Index r);
  /// Looks at what has changed since the points were renewed before.
  void renew(const SewnPoints& points);

  int count() const { return count_; }
  /// Borders of the bodice alone that no head or arm passes through.
  int narrow() const { return narrow_count_; }

 private:
  void gather(const SewnPoints& points, Index r);
  void forget(Index r);
  bool is_narrow() const;

  const SeamModel& m_;
  double least_;              ///< mm, of the bodice alone
  std::vector<Index> first_;  ///< of each free run: the one that stands for its border; else kNone
  std::vector<char> narrow_;  ///< of each border, at the run that stands for it
  int count_ = 0, narrow_count_ = 0;

  // While borders are renewed.
  std::vector<char> renewed_;        ///< of each run
  std::vector<Index> renewed_list_;  ///< those
  std::vector<Index> border_;        ///< runs of one …
  std::vector<Index> ends_;          ///< … and ends of these that lead on
};

}  // namespace toile::seams
