#pragma once
// Boxes along the axes, in the plane and in space. Units are the caller's. The boxes that the trees ask are
// floats (core/geometry/bvh.h): they are rounded outwards, which a measured box must not be.

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/types.h"

namespace toile {

// Of equal numbers, +0 and -0 among them, the first argument's stays: what is told of a box does not depend
// on how its loop was written.
constexpr Vec2 least_of(Vec2 a, Vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
constexpr Vec2 most_of(Vec2 a, Vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }
constexpr Vec3 least_of(Vec3 a, Vec3 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
constexpr Vec3 most_of(Vec3 a, Vec3 b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
constexpr bool none_above(Vec2 a, Vec2 b) { return a.x <= b.x && a.y <= b.y; }
constexpr bool none_above(Vec3 a, Vec3 b) { return a.x <= b.x && a.y <= b.y && a.z <= b.z; }

/// A box of points `V` (Vec2 or Vec3); its sides belong to it. The default is empty: it holds nothing, and
/// the first point that is added becomes the whole of it. REQUIRES a box that is not empty of size() and
/// middle().
template <typename V>
struct Aabb {
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  V low = filled(kFar);
  V high = filled(-kFar);

  static constexpr V filled(double value) {
    if constexpr (requires(V v) { v.z; }) {
      return {value, value, value};
    } else {
      return {value, value};
    }
  }

  constexpr bool empty() const { return low.x > high.x; }
  constexpr void add(V p) {
    low = least_of(low, p);
    high = most_of(high, p);
  }
  constexpr V size() const { return high - low; }
  constexpr V middle() const { return (low + high) * 0.5; }
  constexpr bool contains(V p) const { return none_above(low, p) && none_above(p, high); }
  constexpr bool contains(const Aabb& b) const { return contains(b.low) && contains(b.high); }
  /// `by` wider to every side.
  constexpr Aabb grown(double by) const { return {low - filled(by), high + filled(by)}; }
  friend bool operator==(const Aabb&, const Aabb&) = default;
};

using Aabb2 = Aabb<Vec2>;
using Aabb3 = Aabb<Vec3>;

/// The smallest box around the points; a null box at the origin when there are none. A first point that is
/// not a number shows in the box.
template <typename V>
constexpr Aabb<V> box_of_points(std::span<const V> points) {
  if (points.empty()) return {V{}, V{}};
  Aabb<V> box{points[0], points[0]};
  for (const V& p : points) box.add(p);
  return box;
}
constexpr Aabb2 bounding_box(std::span<const Vec2> points) { return box_of_points(points); }
constexpr Aabb3 bounding_box(std::span<const Vec3> points) { return box_of_points(points); }

}  // namespace toile
