#pragma once
// One cubic Bézier for a run of points, and the tangents at its ends.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/base/types.h"
#include "core/base/units.h"
#include "core/pattern/pattern.h"

namespace toile::pattern {

/// mm; nearer points would show the rounding of files.
inline constexpr double kTangentReach = 0.5;
/// rad; a bend beyond it is meant to be one, and no curve goes around it.
inline constexpr double kSharpBend = 35 * (kPi / 180);

/// Angle between two directions, rad, 0 to π.
double turn_between(Vec2 from, Vec2 to);

/// Unit tangent at the middle of three points, of the parabola in chord length through them.
Vec2 middle_tangent(Vec2 a, Vec2 b, Vec2 c);

/// Unit tangents of a smooth run, forward: at its first point, at its last, at an inner one. Of parabolas
/// through points about `far` mm apart. REQUIRES two points or more.
Vec2 start_tangent(std::span<const Vec2> p);
Vec2 last_tangent(std::span<const Vec2> p);
Vec2 inner_tangent(std::span<const Vec2> p, std::size_t i, double far = kTangentReach);

/// One cubic for the smooth run p with forward end tangents t0, t1, within `tolerance` of each point; nothing
/// when none comes close enough, and then the point farthest off it.
std::optional<CubicBezier> fit_cubic(std::span<const Vec2> p, Vec2 t0, Vec2 t1, double tolerance,
                                     std::size_t& farthest);

}  // namespace toile::pattern
