#pragma once
// What is free and what is sewn around each piece, and what speaks for it.

#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Runs and what each is sewn to. What is judged is counted run by run, of each run together with the next,
/// so that a change touches no more than the run and the one before it.
class SewnOutlines {
 public:
  /// Nothing is sewn.
  explicit SewnOutlines(const SeamModel& model);

  /// Run r is sewn to `partner` from now on, or to nothing (kNone).
  void sew(Index r, Index partner);
  Index partner(Index r) const { return partner_[r]; }

  /// Nearly every piece has an edge that is sewn to nothing: a hem, a neck, or to a band, cuff or collar that
  /// ends it there. But a piece of a bodice is sewn.
  double free_edges() const;
  /// Two pieces that mirror each other meet along one line, the middle of the body, seldom along two.
  double second_lines() const;

 private:
  struct Run {
    Index panel, next, before, mirror;
    bool round;    ///< turns by more than an opening does, and is no hem
    bool smooth;   ///< the outline runs on smoothly at its start
    bool trim;     ///< of a band, cuff or collar
    bool goes_on;  ///< a line in the middle of the body goes on where it begins
  };
  struct Panel {
    bool may_be_left_out;    ///< no piece of the bodice, or a layer
    int lines_allowed;       ///< with its twin; as many as there are for what is no twin
    int open = 0, sewn = 0;  ///< runs that end it or lead to what ends it; that are sewn
    int lines = 0;           ///< in the middle of the body, by their last runs
  };
  bool is_free(Index r) const { return partner_[r] == kNone; }
  bool in_middle(Index r) const { return !is_free(r) && partner_[r] == runs_[r].mirror; }
  void count(Index r, int times);
  void count_both(Index r, int times);

  std::vector<Run> runs_;
  std::vector<Panel> panels_;
  std::vector<Index> partner_;
  int free_round_ = 0, torn_ = 0;
};

}  // namespace toile::seams
