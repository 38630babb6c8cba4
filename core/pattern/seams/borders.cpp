// The free borders of what is sewn together.

#include "core/base/disjoint_sets.h"
#include "core/pattern/seams/gluing.h"

namespace toile::seams {
namespace {

/// Corners by the point that they come to; corner i is the start of run i.
void join_corners(const SeamModel& m, const SeamGluing& g, DisjointSets& corners) {
  corners.reset(m.runs.size());
  for (Index a = 0; a < static_cast<Index>(m.runs.size()); ++a) {
    const Index b = g.partner[a];
    if (b <= a) continue;
    const bool along = g.along(m, a, b);
    corners.join(a, along ? b : m.runs[b].next);
    corners.join(m.runs[a].next, along ? m.runs[b].next : b);
  }
}

/// The corners where one comes to a run and leaves it, with the cloth at the left.
Index start_of(const SeamModel& m, const SeamGluing& g, Index run) {
  return g.turned[m.runs[run].panel] ? m.runs[run].next : run;
}
Index end_of(const SeamModel& m, const SeamGluing& g, Index run) {
  return g.turned[m.runs[run].panel] ? run : m.runs[run].next;
}

}  // namespace

bool is_whole_border(const SeamModel& m, SeamGluing g, const std::vector<Index>& runs) {
  for (const Index r : runs) g.undo(r);
  DisjointSets corners;
  join_corners(m, g, corners);
  return !runs.empty() &&
         corners.root(end_of(m, g, runs.back())) == corners.root(start_of(m, g, runs.front()));
}

std::vector<std::vector<Index>> free_borders(const SeamModel& m, const SeamGluing& g) {
  DisjointSets corners;
  join_corners(m, g, corners);
  const auto start = [&](Index i) { return corners.root(start_of(m, g, i)); };
  const auto end = [&](Index i) { return corners.root(end_of(m, g, i)); };
  const Index count = static_cast<Index>(m.runs.size());
  std::vector<Index> starts_at(m.runs.size(), kNone);
  for (Index i = 0; i < count; ++i)
    if (g.partner[i] == kNone) starts_at[start(i)] = i;
  std::vector<bool> seen(m.runs.size(), false);
  std::vector<std::vector<Index>> borders;
  for (Index i = 0; i < count; ++i) {
    if (g.partner[i] != kNone || seen[i]) continue;
    std::vector<Index> border;
    for (Index at = i; at != kNone && !seen[at]; at = starts_at[end(at)]) {
      seen[at] = true;
      border.push_back(at);
    }
    borders.push_back(std::move(border));
  }
  return borders;
}

}  // namespace toile::seams
