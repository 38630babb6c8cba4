#include "core/pattern/loop_part.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/pattern/curve.h"

namespace toile::pattern {
namespace {

constexpr double kStep = 0.05;  // mm between the places of a curve that are tried

/// A place on the loop, by the parameter of its curve.
struct At {
  std::size_t edge = 0, curve = 0;
  double t = 0, off = HUGE_VAL;
};

At nearest(const Loop& loop, Vec2 p) {
  At best;
  for (std::size_t e = 0; e < loop.edges.size(); ++e)
    for (std::size_t c = 0; c < loop.edges[e].curves.size(); ++c) {
      const CubicBezier& curve = loop.edges[e].curves[c];
      const int steps = std::max(2, static_cast<int>(arc_length(curve) / kStep));
      for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps, off = length(evaluate(curve, t) - p);
        if (off < best.off - 1e-9) best = {e, c, t, off};
      }
    }
  return best;
}

/// The curve between two of its parameters; nothing where they are one.
void take(CubicBezier curve, double t0, double t1, PanelEdge& edge) {
  if (t1 - t0 < 1e-6) return;
  if (t1 < 1) curve = split(curve, t1).first;
  if (t0 > 0) curve = split(curve, t0 / t1).second;
  edge.curves.push_back(curve);
}

}  // namespace

std::vector<PanelEdge> edges_between(const Loop& loop, Vec2 from, Vec2 to) {
  const At a = nearest(loop, from), b = nearest(loop, to);
  const std::size_t n = loop.edges.size();
  std::vector<PanelEdge> out;
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t e = (a.edge + k) % n;
    const bool first = k == 0;
    const bool last = e == b.edge && (k > 0 || b.curve > a.curve || (b.curve == a.curve && b.t > a.t));
    PanelEdge edge;
    for (std::size_t c = first ? a.curve : 0; c < loop.edges[e].curves.size(); ++c) {
      const bool ends = last && c == b.curve;
      take(loop.edges[e].curves[c], first && c == a.curve ? a.t : 0, ends ? b.t : 1, edge);
      if (ends) break;
    }
    if (!edge.curves.empty()) out.push_back(std::move(edge));
    if (last) break;
  }
  return out;
}

std::vector<CubicBezier> curves_between(const PanelEdge& edge, double from, double to) {
  constexpr double kWhole = 1e-6;  // mm; a curve that is taken whole keeps its ends exactly
  const double all = arc_length(edge);
  std::vector<CubicBezier> curves;
  double start = 0;
  for (CubicBezier curve : edge.curves) {
    const double here = arc_length(curve), first = from * all - start, last = to * all - start;
    start += here;
    if (last <= kWhole || first >= here - kWhole) continue;
    if (last < here - kWhole) curve = split(curve, parameter_at_length(curve, last)).first;
    if (first > kWhole) curve = split(curve, parameter_at_length(curve, first)).second;
    curves.push_back(curve);
  }
  return curves;
}

}  // namespace toile::pattern
