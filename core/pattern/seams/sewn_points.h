#pragma once
// The points that the corners of sewn outlines come to, and how the cloth lies around each.

#include <array>
#include <cstddef>
#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Corner i is the start of run i. Two ends of runs lie at each: the start of one run and the end of the one
/// before it. Corners whose ends are sewn to each other come to one point; where none of them is free the
/// point is inside the cloth, else borders run through it. Seams that change touch no point but those at
/// their ends.
///
/// Mostly a run is sewn to the one that is sewn to it. But an edge of a pattern may be in several seams, and
/// is sewn to the last of them here: it is the lower run of a pair that joins their corners.
class SewnPoints {
 public:
  /// Nothing is sewn. The model must outlive it.
  explicit SewnPoints(const SeamModel& model);

  /// Run r is sewn to `partner` from now on, along the outlines' direction or against it, or to nothing
  /// (kNone). renew() must follow once all are told.
  void sew(Index r, Index partner, bool along);
  void renew();

  /// The corner that stands for those that come to the same point: the least of them.
  Index at(Index corner) const { return root_[corner]; }
  int count() const { return count_; }
  /// What speaks for how the cloth lies, summed in the points' order, so that a sum is the same to the last
  /// bit however it came about.
  double merit() const;

  static constexpr Index start_of(Index run) { return 2 * run; }
  static constexpr Index end_of(Index run) { return 2 * run + 1; }
  static constexpr Index run_of(Index end) { return end / 2; }
  /// The run's other end.
  static constexpr Index opposite(Index end) { return end ^ 1; }
  /// The next free end at the same point, itself where there is no other. REQUIRES a free end.
  Index next_free(Index end) const { return next_free_[end]; }
  /// The free ends at the points that were renewed last.
  const std::vector<Index>& renewed_free() const { return renewed_free_; }

 private:
  /// What of a corner's piece counts, one bit each.
  enum Trait : unsigned char { kCut = 1, kLegs = 2, kFront = 4, kBack = 8, kOther = 16 };

  /// What else a run's corners are joined to.
  struct Joint {
    Index other = kNone;
    bool along = false;  ///< the outlines' direction
  };
  struct Run {
    Index next, before;  ///< around its outline
    Joint joint = {};    ///< the first of its joints; nearly always the only one
    bool free = true;
  };
  struct MoreJoint {
    Index run;
    Joint joint;
  };
  Index corner_of(Index end) const { return end % 2 == 0 ? run_of(end) : runs_[run_of(end)].next; }
  /// The end of another run that this one of a run is sewn to.
  static Index met_by(Index end, const Joint& joint) {
    return joint.along ? start_of(joint.other) + end % 2 : end_of(joint.other) - end % 2;
  }
  void join(Index r, const Joint& joint);
  void part(Index r, Index other);
  void gather(Index end);
  void gather_corner(Index corner);
  void renew_point(Index corner);
  void judge_point();

  std::vector<Run> runs_;
  std::vector<MoreJoint> more_;   ///< of runs that have several
  std::vector<Index> joined_to_;  ///< of each run: the higher one that it is sewn to; kNone
  std::vector<double> angle_;     ///< of each corner, degrees
  std::vector<unsigned char> traits_;
  std::vector<Index> next_free_;  ///< of each end
  std::vector<Index> root_;       ///< of each corner
  std::vector<double> lies_;      ///< of each point, at the corner that stands for it: its merit
  std::vector<char> shuts_arm_;   ///< as `lies_`
  int count_ = 0;

  // While points are renewed.
  std::vector<Index> changed_;       ///< runs
  std::vector<char> renewed_;        ///< of each corner
  std::vector<Index> renewed_list_;  ///< those
  std::vector<Index> renewed_free_;
  std::vector<Index> point_, free_;  ///< corners and free ends of one point
};

}  // namespace toile::seams
