#include "core/pattern/seams/round_stand.h"

#include <algorithm>

namespace toile::seams {
namespace {

bool is_collar_on_stand(const PieceWords& words) {
  return words.kind == PieceKind::kCollar && !words.stand && !words.layer;
}

bool passes(const SeamModel& model, const SeamRun& stand, const SeamRun& other) {
  constexpr double kEnd = 0.25;  // of its outline at most is an end of a collar
  const int edge = round_stand_edge(model, stand);
  if (edge < 0 && model.words[other.panel].kind == PieceKind::kCollar) return true;
  const bool collar = is_collar_on_stand(model.words[other.panel]);
  if (edge > 0 && collar) return edge_length(other) < kEnd * model.girth[other.panel];
  return edge != 0 && collar != (edge > 0);
}

}  // namespace

int round_stand_edge(const SeamModel& model, const SeamRun& run) {
  constexpr double kShaped = 0.98;  // of the longer edge at most is a shorter one at most is a shorter one
  const PieceWords& words = model.words[run.panel];
  if (words.kind != PieceKind::kCollar || !words.stand) return 0;
  double longest = 0, second = 0;
  for (const SeamRun& other : model.runs) {
    if (other.panel != run.panel || other.from > 0) continue;
    const double here = edge_length(other);
    second = std::max(second, std::min(longest, here));
    longest = std::max(longest, here);
  }
  const double length = edge_length(run);
  const bool round = model.lines[run.panel] < 4;  // at both ends, or at one of a half
  if (length < kShaped * second || (!round && second > kShaped * longest)) return 0;
  const bool longer = length > (longest + second) / 2;  // lengths of parts are rounded
  return longer == round ? 1 : -1;
}

bool misses_round_stand(const SeamModel& model, const SeamRun& a, const SeamRun& b) {
  return passes(model, a, b) || passes(model, b, a);
}

bool is_inner_of_collar(const SeamModel& model, const std::vector<Index>& runs) {
  constexpr double kLong = 0.8;  // times as long, so that it is the other long edge
  const SeamRun& run = model.runs[runs.front()];
  const double length = edge_length(run);
  const bool one_edge = std::all_of(runs.begin(), runs.end(), [&](Index r) {
    return model.runs[r].panel == run.panel && model.runs[r].edge == run.edge;
  });
  const bool inner = std::none_of(model.runs.begin(), model.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.edge != run.edge && edge_length(other) > kLong * length &&
           edge_length(other) < length;
  });
  return one_edge && inner && is_collar_on_stand(model.words[run.panel]);
}

}  // namespace toile::seams
