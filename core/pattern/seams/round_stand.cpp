#include "core/pattern/seams/round_stand.h"

namespace toile::seams {
namespace {

double whole_length(const SeamRun& run) { return run.length / (run.to - run.from); }

bool is_collar_on_stand(const PieceWords& words) {
  return words.kind == PieceKind::kCollar && !words.stand && !words.layer;
}

bool passes(const SeamModel& model, const SeamRun& stand, const SeamRun& other) {
  constexpr double kEnd = 0.25;  // of its outline at most is an end of a collar
  const int edge = round_stand_edge(model, stand);
  const bool collar = is_collar_on_stand(model.words[other.panel]);
  if (edge > 0 && collar) return whole_length(other) < kEnd * model.girth[other.panel];
  return edge != 0 && collar != (edge > 0);
}

}  // namespace

int round_stand_edge(const SeamModel& model, const SeamRun& run) {
  const PieceWords& words = model.words[run.panel];
  if (words.kind != PieceKind::kCollar || !words.stand || model.lines[run.panel] != 2) return 0;
  return whole_length(run) > model.girth[run.panel] / 2 ? 1 : -1;
}

bool misses_round_stand(const SeamModel& model, const SeamRun& a, const SeamRun& b) {
  return passes(model, a, b) || passes(model, b, a);
}

bool is_inner_of_collar(const SeamModel& model, const SeamRun& run) {
  constexpr double kLong = 0.8;  // times as long as the run, so that it is the other long edge
  for (const SeamRun& other : model.runs)
    if (other.panel == run.panel && other.edge != run.edge && other.length > kLong * run.length &&
        other.length < run.length)
      return false;
  return is_collar_on_stand(model.words[run.panel]);
}

}  // namespace toile::seams
