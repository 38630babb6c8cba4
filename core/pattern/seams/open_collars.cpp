#include "core/pattern/seams/open_collars.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace toile::seams {
namespace {

using Series = std::vector<pattern::SeamEdge>;

bool is_collar(const SeamModel& m, const Series& side) {
  return std::all_of(side.begin(), side.end(),
                     [&](const pattern::SeamEdge& e) { return m.words[e.panel].kind == PieceKind::kCollar; });
}

bool is_of(const SeamModel& m, const pattern::SeamEdge& e, int face) {
  const PieceWords& words = m.words[e.panel];
  return words.kind == PieceKind::kTorso && !words.layer && words.face == face;
}

/// Whether the whole of an edge is sewn whose halves mirror each other.
bool is_whole_and_even(const SeamModel& m, const pattern::SeamEdge& e) {
  return e.from <= 0 && e.to >= 1 && std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
           return run.panel == e.panel && run.edge == e.edge && run.mirror_panel == e.panel &&
                  run.mirror_edge == e.edge;
         });
}

/// Whether front and back are in it, and with each half of a pair the other one.
bool goes_all_around(const SeamModel& m, const Series& side) {
  const auto any = [&](auto is) { return std::any_of(side.begin(), side.end(), is); };
  return any([&](const auto& e) { return is_of(m, e, 1); }) &&
         any([&](const auto& e) { return is_of(m, e, -1); }) &&
         std::all_of(side.begin(), side.end(), [&](const pattern::SeamEdge& e) {
           return m.twin[e.panel] == kNone ||
                  any([&](const pattern::SeamEdge& o) { return o.panel == m.twin[e.panel]; });
         });
}

/// Whether a front on the fold has a neck that comes to a point in its middle: a V.
bool has_v_neck(const SeamModel& m) {
  constexpr double kPointed = 215;  // degrees, of the cloth around it
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& before) {
    const SeamRun& after = m.runs[before.next];
    const PieceWords& words = m.words[before.panel];
    return words.kind == PieceKind::kTorso && words.face > 0 && !words.layer && after.angle > kPointed &&
           before.edge != after.edge && before.mirror_panel == before.panel &&
           before.mirror_edge == after.edge;
  });
}

/// Whether the piece is broader than what only finishes a neck, by its area over its longest edge.
bool is_broad(const SeamModel& m, Index panel) {
  constexpr double kBroad = 60;  // mm
  double twice_area = 0, longest = 0;
  for (const SeamRun& run : m.runs) {
    if (run.panel != panel) continue;
    for (std::size_t k = 1; k < run.at.size(); ++k) twice_area += cross(run.at[k - 1], run.at[k]);
    longest = std::max(longest, run.length);
  }
  return std::abs(twice_area) / 2 > kBroad * longest;
}

/// From the middle of element `k` on, around to there.
Series begun_within(const Series& side, std::size_t k) {
  Series begun{side[k]};
  begun.insert(begun.end(), side.begin() + static_cast<std::ptrdiff_t>(k) + 1, side.end());
  begun.insert(begun.end(), side.begin(), side.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  (side[k].reversed ? begun.front().to : begun.front().from) = 0.5;
  (side[k].reversed ? begun.back().from : begun.back().to) = 0.5;
  return begun;
}

}  // namespace

bool closes_open_collar(const SeamModel& m, const pattern::Seam& seam) {
  const Index panel = seam.a.front().panel;
  return is_collar(m, seam.a) && is_collar(m, seam.b) && panel == seam.b.front().panel &&
         (m.open_neck || (is_broad(m, panel) && has_v_neck(m)));
}

void begin_in_front(const SeamModel& m, pattern::Seam& seam) {
  if (!m.open_neck) return;
  for (auto [neck, other] : {std::pair{&seam.a, &seam.b}, std::pair{&seam.b, &seam.a}}) {
    if (!is_collar(m, *other) || !goes_all_around(m, *neck)) continue;
    for (std::size_t k = 0; k < neck->size(); ++k) {
      const pattern::SeamEdge &here = (*neck)[k], &next = (*neck)[(k + 1) % neck->size()];
      if (!is_of(m, here, 1)) continue;
      if (m.twin[here.panel] == here.panel && is_whole_and_even(m, here)) {
        *neck = begun_within(*neck, k);
        return;
      }
      if (is_of(m, next, 1) && here.panel != next.panel && m.twin[here.panel] == next.panel) {
        std::rotate(neck->begin(), neck->begin() + static_cast<std::ptrdiff_t>((k + 1) % neck->size()),
                    neck->end());
        return;
      }
    }
  }
}

}  // namespace toile::seams
