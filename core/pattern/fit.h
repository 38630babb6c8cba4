#pragma once
// From a polyline to few cubic Béziers.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::pattern {

/// Cubics through the ends of an open polyline that stay within `tolerance_mm` of each of its points; with
/// consecutive curves sharing ends exactly. Straight runs become exact lines. A sharp bend amid the points
/// (more than about 35°, or a lesser one between segments too long to be samples of a curve) stays sharp.
///
/// Method: P. J. Schneider, "An algorithm for automatically fitting digitized curves", Graphics Gems, 1990:
/// least squares for the handle lengths with chord-length parameters, Newton reparametrisation; and splits
/// where that does not suffice, sought so that few curves come out. Tangents come from parabolas through
/// neighbouring points, between two curves from whichever of several serves best.
/// At the points `ends` (indices, ascending, none first or last) a curve ends too, smoothly.
/// `compared` counts how often a point was held against a cubic.
/// REQUIRES at least two points, finite, neighbours apart.
std::vector<CubicBezier> fit_polyline(std::span<const Vec2> points, double tolerance_mm,
                                      std::span<const std::size_t> ends = {},
                                      std::size_t* compared = nullptr);

/// The same for a closed line without corners: `loop` lists each vertex once, the result starts and ends at
/// loop[0], smooth there too, in four or more curves (a loop with sharp bends is fitted as an open polyline
/// that starts and ends at loop[0]). REQUIRES at least four points.
std::vector<CubicBezier> fit_smooth_loop(std::span<const Vec2> loop, double tolerance_mm,
                                         std::span<const std::size_t> ends = {});

}  // namespace toile::pattern
