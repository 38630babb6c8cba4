#pragma once
// Cubic Bézier curves of the pattern. Parameters t run from 0 to 1; lengths are in the curve's unit (mm).

#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::pattern {

/// The straight segment from a to b, with its handles at the thirds: its parameter is proportional to length.
CubicBezier line_segment(Vec2 a, Vec2 b);

Vec2 evaluate(const CubicBezier& curve, double t);

/// d/dt, mm per unit of t.
Vec2 derivative(const CubicBezier& curve, double t);

Vec2 second_derivative(const CubicBezier& curve, double t);

/// Length between two parameters, to about 1e-9 of the curve's size (Gauss-Legendre, halved where needed).
/// REQUIRES t0 <= t1.
double arc_length(const CubicBezier& curve, double t0 = 0, double t1 = 1);
double arc_length(const PanelEdge& edge);

/// The parameter at distance `s` along the curve from its start; clamped to [0, 1].
double parameter_at_length(const CubicBezier& curve, double s);
/// The same where the curve's arc_length() is known.
double parameter_at_length(const CubicBezier& curve, double s, double whole);

/// The point at distance `s` along the edge from its start; clamped to its ends. REQUIRES edge.curves not
/// empty.
Vec2 point_at_length(const PanelEdge& edge, double s);

/// The two parts before and after t. They share the split point exactly and keep the outer ends exactly.
std::pair<CubicBezier, CubicBezier> split(const CubicBezier& curve, double t);

CubicBezier reversed(const CubicBezier& curve);
/// The edge run the other way, under the same id.
PanelEdge reversed(const PanelEdge& edge);
/// The loop run the other way. Its first edge stays first.
Loop reversed(const Loop& loop);

/// True when the curve stays within `tolerance` of its chord and runs along it without turning back.
bool is_straight(const CubicBezier& curve, double tolerance_mm = 1e-6);

/// Number of equal parameter steps after which no chord is farther than `tolerance_mm` from the curve,
/// at most 4096. A straight curve needs 1.
std::size_t flat_steps(const CubicBezier& curve, double tolerance_mm);

/// Points along the curve, both ends included, whose chords stay within `tolerance_mm` of it.
std::vector<Vec2> flatten(const CubicBezier& curve, double tolerance_mm);
/// As above along all curves of the edge; shared ends appear once.
std::vector<Vec2> flatten(const PanelEdge& edge, double tolerance_mm);
/// The closed polyline of the loop; the first point is not repeated at the end.
std::vector<Vec2> flatten(const Loop& loop, double tolerance_mm);

/// Exact area that the loop's curves enclose, mm², positive when it runs counter-clockwise.
double signed_area(const Loop& loop);

}  // namespace toile::pattern
