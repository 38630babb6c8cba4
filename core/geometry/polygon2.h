#pragma once
// Closed polylines ("loops") in the plane. A loop lists each vertex once: its last segment runs from the last
// vertex back to the first. Units are the caller's.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/aabb.h"

namespace toile::geometry {

/// Distance from p to the box, 0 inside.
double distance(const Aabb2& box, Vec2 p);

/// Area of the loop, positive when it runs counter-clockwise; areas wound twice count twice.
double signed_area(std::span<const Vec2> loop);

/// Whether all points lie within `tolerance` of one line (through the first and the one farthest from it).
bool is_flat(std::span<const Vec2> points, double tolerance);

/// Length of the open polyline.
double polyline_length(std::span<const Vec2> points);

/// Whether p lies inside the loop by the even-odd rule. A point on the outline may count either way.
bool contains(std::span<const Vec2> loop, Vec2 p);

/// Distance from p to the segment ab.
double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);

/// The point of the loop nearest to p. REQUIRES a vertex.
Vec2 nearest_on(std::span<const Vec2> loop, Vec2 p);

/// Twice the signed area of the triangle abc: positive when c lies left of a→b.
double orientation(Vec2 a, Vec2 b, Vec2 c);

/// A point common to the closed segments ab and cd, ends included; of an overlap, one of its points.
std::optional<Vec2> segment_intersection(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Where two segments of loops meet other than as neighbours.
struct Crossing {
  std::size_t loop_a = 0, segment_a = 0;  ///< segment i runs from vertex i of its loop to the next
  std::size_t loop_b = 0, segment_b = 0;
  Vec2 point;
};

/// The leftmost place (about) where the loops cross or touch themselves or each other: two segments that
/// share a point without being neighbours, or neighbours that fold back onto each other. Nothing when all
/// loops are simple and apart. Repeated vertices are passed over. O(n log n) for n vertices in all, by a
/// sweep from left to right: M. I. Shamos and D. Hoey, "Geometric intersection problems", FOCS 1976. REQUIRES
/// finite coordinates. `compared` counts how often two segments were held against each other.
std::optional<Crossing> find_crossing(std::span<const std::vector<Vec2>> loops,
                                      std::size_t* compared = nullptr);

}  // namespace toile::geometry
