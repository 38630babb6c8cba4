#include "core/pattern/seams/folds.h"

#include <algorithm>
#include <cmath>

namespace toile::seams {
namespace {

bool is_as_long(const SeamRun& a, const SeamRun& b, double share) {
  return std::abs(edge_length(a) - edge_length(b)) < share * edge_length(b);
}

/// Whether the run's piece is folded along an edge that is as long.
bool is_along_fold(const SeamModel& model, const SeamRun& run) {
  constexpr double kAsLong = 0.02;
  return std::any_of(model.runs.begin(), model.runs.end(), [&](const SeamRun& fold) {
    return fold.fold && fold.panel == run.panel && is_as_long(fold, run, kAsLong);
  });
}

bool is_as_long_as_front(const SeamModel& model, const SeamRun& fold) {
  constexpr double kAsLong = 0.01;
  return std::any_of(model.runs.begin(), model.runs.end(), [&](const SeamRun& run) {
    const PieceWords& words = model.words[run.panel];
    return words.kind == PieceKind::kTorso && words.face >= 0 && is_as_long(run, fold, kAsLong);
  });
}

}  // namespace

bool never_at_fold(const SeamModel& model, const SeamRun& a, const SeamRun& b) {
  const bool images = a.panel != b.panel && a.mirror_panel == b.panel && a.mirror_edge == b.edge;
  if (!a.fold && !b.fold) return images && is_along_fold(model, a);
  return !images || !is_as_long_as_front(model, a);
}

}  // namespace toile::seams
