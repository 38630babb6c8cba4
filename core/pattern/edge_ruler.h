#pragma once
// Points of an edge at distances along it.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::pattern {

/// Measures an edge's curves once, however many points are asked for. The edge must outlive it.
class EdgeRuler {
 public:
  explicit EdgeRuler(const PanelEdge& edge);

  /// arc_length() of the edge, mm.
  double length() const { return length_; }
  /// As point_at_length().
  Vec2 at(double s) const;

 private:
  const PanelEdge& edge_;
  std::vector<double> lengths_;  ///< of each curve
  double length_ = 0;
};

}  // namespace toile::pattern
