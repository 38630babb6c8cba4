#include "core/pattern/seams/taken_edges.h"

#include <algorithm>

namespace toile::seams {

std::vector<pattern::SeamEdge> both_sides(const pattern::Seam& seam) {
  std::vector<pattern::SeamEdge> edges = seam.a;
  edges.insert(edges.end(), seam.b.begin(), seam.b.end());
  return edges;
}

void say_plainly(pattern::Seam& seam) {
  for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b}) {
    if (std::any_of(side->begin(), side->end(), [](const pattern::SeamEdge& e) { return !e.reversed; }))
      continue;
    std::reverse(side->begin(), side->end());
    for (pattern::SeamEdge& e : *side) e.reversed = false;
    seam.same_direction = !seam.same_direction;
  }
}

bool TakenEdges::clashes(const pattern::Seam& seam) const {
  constexpr double kTouching = 1e-6;  // of an edge's length
  const std::vector<pattern::SeamEdge> edges = both_sides(seam);
  return std::any_of(edges.begin(), edges.end(), [&](const pattern::SeamEdge& e) {
    return std::any_of(taken_.begin(), taken_.end(), [&](const pattern::SeamEdge& t) {
      return t.panel == e.panel && t.edge == e.edge &&
             std::min(t.to, e.to) - std::max(t.from, e.from) > kTouching;
    });
  });
}

bool TakenEdges::goes_on(const pattern::Seam& seam) const {
  const std::vector<pattern::SeamEdge> edges = both_sides(seam);
  return std::any_of(edges.begin(), edges.end(), [&](const pattern::SeamEdge& e) {
    return std::any_of(taken_.begin(), taken_.end(),
                       [&](const pattern::SeamEdge& t) { return t.panel == e.panel && t.edge == e.edge; });
  });
}

void TakenEdges::take(const pattern::Seam& seam) {
  for (const pattern::SeamEdge& e : both_sides(seam)) taken_.push_back(e);
}

}  // namespace toile::seams
