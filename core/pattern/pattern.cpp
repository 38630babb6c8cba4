#include "core/pattern/pattern.h"

namespace toile::pattern {

std::vector<const PanelEdge*> edges_of(const Panel& panel) {
  std::vector<const PanelEdge*> edges;
  for (const PanelEdge& edge : panel.outline.edges) edges.push_back(&edge);
  for (const Loop& hole : panel.holes)
    for (const PanelEdge& edge : hole.edges) edges.push_back(&edge);
  return edges;
}

}  // namespace toile::pattern
