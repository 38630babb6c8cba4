#include "core/pattern/edge_ruler.h"

#include "core/pattern/curve.h"

namespace toile::pattern {

EdgeRuler::EdgeRuler(const PanelEdge& edge) : edge_(edge) {
  lengths_.reserve(edge.curves.size());
  for (const CubicBezier& c : edge.curves) length_ += lengths_.emplace_back(arc_length(c));
}

Vec2 EdgeRuler::at(double s) const {
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    const CubicBezier& c = edge_.curves[i];
    if (s <= lengths_[i]) return evaluate(c, parameter_at_length(c, s, lengths_[i]));
    s -= lengths_[i];
  }
  return edge_.curves.back().p3;
}

}  // namespace toile::pattern
