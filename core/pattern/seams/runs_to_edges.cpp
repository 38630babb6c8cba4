#include "core/pattern/seams/runs_to_edges.h"

#include <algorithm>
#include <cstddef>

namespace toile::seams {
namespace {

bool on_one_edge(const SeamRun& x, const SeamRun& y) { return x.panel == y.panel && x.edge == y.edge; }

/// Whether y goes on from x along their edge, which is walked along the outline or, `against`, the other way.
bool goes_on(const SeamRun& x, const SeamRun& y, bool against) {
  return on_one_edge(x, y) && (against ? x.from == y.to : x.to == y.from);
}

/// Whether the corner at which x is left and y is entered is below them both, as the one under the arm is.
bool is_below(const SeamModel& m, const SeamRun& x, const SeamRun& y, bool against) {
  const auto rise = [&](const SeamRun& run) { return dot(run.at.back() - run.at.front(), m.up[run.panel]); };
  return against ? rise(x) > 0 && rise(y) < 0 : rise(x) < 0 && rise(y) > 0;
}

/// At which run of a ring it may begin for a seam to the whole of `other`: where the ring goes on along
/// another edge; for a sleeve under the arm, between two pieces.
std::size_t start_of_ring(const SeamModel& m, const std::vector<Index>& ring, const SeamRun& other,
                          bool against) {
  const bool is_sleeve = m.words[other.panel].kind == PieceKind::kSleeve;
  std::size_t start = ring.size();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const SeamRun &x = m.runs[ring[(k + ring.size() - 1) % ring.size()]], &y = m.runs[ring[k]];
    if (on_one_edge(x, y)) continue;
    if (is_sleeve && x.panel != y.panel && is_below(m, x, y, against)) return k;
    start = std::min(start, k);
  }
  return start == ring.size() ? 0 : start;
}

}  // namespace

std::vector<pattern::SeamEdge> edges_of_runs(const FoundSeams& found, const std::vector<Index>& runs,
                                             double& length) {
  std::vector<pattern::SeamEdge> edges;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const SeamRun& run = found.model.runs[runs[k]];
    const bool turned = found.gluing.turned[run.panel] != 0;
    length += run.length;
    if (k > 0 && goes_on(found.model.runs[runs[k - 1]], run, turned)) {
      edges.back().from = std::min(edges.back().from, run.from);
      edges.back().to = std::max(edges.back().to, run.to);
      continue;
    }
    edges.push_back({run.panel, run.edge, turned, run.from, run.to});
  }
  return edges;
}

FoundSeam begun_at_an_end(const FoundSeams& found, FoundSeam seam, bool around) {
  const std::vector<SeamRun>& runs = found.model.runs;
  const auto is_one_edge = [&](const std::vector<Index>& side) {
    return std::all_of(side.begin(), side.end(),
                       [&](Index r) { return on_one_edge(runs[r], runs[side.front()]); });
  };
  const bool one_is_a = is_one_edge(seam.a);
  if (one_is_a == is_one_edge(seam.b)) return seam;
  std::vector<Index>&one = one_is_a ? seam.a : seam.b, &ring = one_is_a ? seam.b : seam.a;
  // Side b is walked against outlines.
  const auto against = [&](const std::vector<Index>& side, bool is_b) {
    return is_b != (found.gluing.turned[runs[side.front()].panel] != 0);
  };
  if (around) {
    const std::size_t start = start_of_ring(found.model, ring, runs[one.front()], against(ring, one_is_a));
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
  }
  const bool down = against(one, !one_is_a);
  std::sort(one.begin(), one.end(), [&](Index x, Index y) {
    return down ? runs[x].from > runs[y].from : runs[x].from < runs[y].from;
  });
  return seam;
}

}  // namespace toile::seams
