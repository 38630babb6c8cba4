#pragma once
// Runs sewn to runs, and how much the result looks like a garment: cloth that lies smoothly around the points
// where pieces meet, a surface with two sides, openings and no handles.

#include <array>
#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

struct SeamGluing {
  std::vector<Index> partner;  ///< of each run; kNone where it is free
  /// What speaks for each sewn run's pair by itself, when it is sewn against the outlines' direction and
  /// along it; the same for both runs of a pair.
  std::vector<std::array<double, 2>> merit;
  std::vector<char> turned;  ///< of each panel: sewn as if the drawing showed its wrong side

  void sew(Index a, Index b, const std::array<double, 2>& value) {
    partner[a] = b;
    partner[b] = a;
    merit[a] = merit[b] = value;
  }
  void undo(Index a) {
    if (partner[a] == kNone) return;
    partner[partner[a]] = kNone;
    partner[a] = kNone;
  }
  bool along(const SeamModel& m, Index a, Index b) const {
    return turned[m.runs[a].panel] != turned[m.runs[b].panel];
  }
};

SeamGluing nothing_sewn(const SeamModel& model);

struct GluingSettings {
  bool sides_known = false;  ///< whether all pieces are drawn from their right side
  /// One per panel: which of them the drawing probably shows from the other side. None: all from one.
  std::vector<char> turned = {};
};

/// What speaks for sewing a to b, apart from what else is sewn: their lengths (unless `lengths` is false),
/// shapes, notches, heights along the grain, and names; against and along the outlines' direction.
std::array<double, 2> pair_merit(const SeamModel& model, Index a, Index b, bool lengths = true);

/// Whether the kinds of the pieces, or a front that opens, keep the two runs apart: what no other part of a
/// seam makes good.
bool never_sewn(const SeamModel& model, Index a, Index b);

/// What a difference of lengths says: 6 for equal ones, 0 at a sixth.
double length_merit(double a, double b);

/// What all that is sewn together is worth: its pairs, and the surface that comes out (GluingJudge).
double gluing_merit(const SeamModel& model, const SeamGluing& gluing, const GluingSettings& settings);

/// The free borders: each a cycle of runs as one walks along it with the cloth at the left (seen from the
/// right side).
std::vector<std::vector<Index>> free_borders(const SeamModel& model, const SeamGluing& gluing);

/// Whether the runs, in the order in which one walks along them with the cloth at the left, would be a whole
/// border if they were free: what else is sewn brings the end of the last to the start of the first.
bool is_whole_border(const SeamModel& model, SeamGluing gluing, const std::vector<Index>& runs);

}  // namespace toile::seams
