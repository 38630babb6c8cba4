#pragma once
// What garments are worth that differ in a few seams each.

#include <array>
#include <vector>

#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/sewn_borders.h"
#include "core/pattern/seams/sewn_outlines.h"
#include "core/pattern/seams/sewn_panels.h"
#include "core/pattern/seams/sewn_points.h"

namespace toile::seams {

/// Says what garments are worth, one after the other, without asking for memory. What one garment has in
/// common with the one before it is not looked at again: a search changes some three runs of a hundred at a
/// time. That changes no bit of what comes out: what is no whole multiple of a half is summed in one order
/// always. The model must outlive it.
class GluingJudge {
 public:
  GluingJudge(const SeamModel& model, const GluingSettings& settings);
  /// The merit of all that is sewn together: of its pairs, and of the surface that comes out.
  double merit(const SeamGluing& gluing) { return merit(gluing, pairs(gluing)); }
  /// The same where that of its pairs is known.
  double merit(const SeamGluing& gluing, double pairs);
  /// What its pairs are worth, each by itself, and the same on mirrored pieces.
  double pairs(const SeamGluing& gluing) const;

 private:
  /// What is asked of a run in every garment, close together in memory.
  struct Run {
    Index next, panel, mirror;
    Index before;  ///< the part of the same edge that ends at a notch where it begins; kNone
    bool cut;      ///< one end is no corner of the drawing
    double length, share;
    int half, face;  ///< half_of() it, and of its piece
    int level;       ///< +1 it faces up along the grain, -1 down; 0 neither, or names tell what hangs where
  };
  bool along(const SeamGluing& g, Index a, Index b) const {
    return g.turned[runs_[a].panel] != g.turned[runs_[b].panel];
  }
  void take(const SeamGluing& g);
  void take_run(const SeamGluing& g, Index r);
  void find_gathered(Index r, Index partner);
  bool is_parted(const SeamGluing& g, Index r) const;
  double sides(const SeamGluing& g) const;
  int second_lines_in_rows(const SeamGluing& g) const;
  double limbs(const SeamGluing& g);
  double straps(const SeamGluing& g);
  double levels(const SeamGluing& g);
  double surface();
  double gathers() const;

  const SeamModel& m_;
  GluingSettings settings_;
  std::vector<Run> runs_;
  std::vector<Index> of_sleeves_, of_straps_, in_rows_, upper_;  ///< runs that limbs(), straps() … are about

  // Of the garment that was judged last.
  SewnPoints points_;
  SewnBorders borders_;
  SewnPanels panels_;
  SewnOutlines outlines_;
  std::vector<char> turned_;
  double sides_;
  std::vector<char> along_;      ///< of each run that is sewn: along the outlines' direction
  std::vector<Index> gathered_;  ///< runs that are longer than what they are sewn to, ascending
  int free_ = 0;                 ///< runs that are sewn to nothing
  int pairs_ = 0;                ///< of runs that are sewn to each other

  // For one garment at a time.
  std::vector<Index> mate_;  ///< of each panel of a sleeve: the first of another that it is sewn to
  std::vector<Index> held_;  ///< of each panel of a strap: the first run that it is sewn to
  std::vector<std::array<Index, 2>> hangs_;  ///< panels: the one hangs from the other
};

}  // namespace toile::seams
