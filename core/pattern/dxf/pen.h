#pragma once
// Curves of a DXF drawing as points.

#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf/entities.h"

namespace toile {

/// Draws curves within a limit on the number of points.
class DxfPen {
 public:
  /// `drawn` counts the points over the whole drawing.
  DxfPen(const DxfSettings& settings, double mm_per_unit, std::size_t& drawn)
      : settings_(settings), unit_(mm_per_unit), drawn_(drawn) {}

  /// The points of the curve, mm, before any transform; the first of a closed one is not repeated.
  /// Error: dxf.too_large.
  Result<std::vector<Vec2>> draw(const DxfCurve& curve);

 private:
  bool take(std::size_t n) { return (drawn_ += n) <= settings_.max_drawn_points; }
  bool polyline(const DxfCurve& c, std::vector<Vec2>& points);
  bool bulge(Vec2 a, Vec2 b, double bulge, std::vector<Vec2>& points);
  bool arc(const DxfCurve& c, std::vector<Vec2>& points);
  bool ellipse(const DxfCurve& c, std::vector<Vec2>& points);
  bool spline(const DxfCurve& c, std::vector<Vec2>& points);
  bool through(const DxfCurve& c, std::vector<Vec2>& points);

  const DxfSettings& settings_;
  double unit_;
  std::size_t& drawn_;
};

}  // namespace toile
