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

FoundSeam begun_at_an_end(const FoundSeams& found, FoundSeam seam) {
  // From one end of an edge to its other, which the ring brings together. Side b is walked against outlines.
  const auto wraps = [&](const std::vector<Index>& side, std::size_t k, bool is_b) {
    const SeamRun &x = found.model.runs[side[k - 1]], &y = found.model.runs[side[k]];
    return on_one_edge(x, y) && !goes_on(x, y, is_b != (found.gluing.turned[x.panel] != 0));
  };
  for (std::size_t k = 1; k < seam.a.size(); ++k) {
    if (!wraps(seam.a, k, false) && !wraps(seam.b, k, true)) continue;
    for (std::vector<Index>* side : {&seam.a, &seam.b})
      std::rotate(side->begin(), side->begin() + static_cast<std::ptrdiff_t>(k), side->end());
    break;
  }
  return seam;
}

}  // namespace toile::seams
