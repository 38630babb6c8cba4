#pragma once
// Orientation and in-circle tests that are exact: points stand on an integer grid, the determinants fit in
// 64 and 128 bits. Same answer on every machine, and never a triangle that two tests see differently.

#include <cstdint>

namespace toile::mesh {

/// A point of the grid. |x| and |y| stay below 2^29 (kGridLimit), so that no determinant overflows.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

inline constexpr std::int64_t kGridLimit = std::int64_t{1} << 29;

/// Twice the signed area of a, b, c: positive when counter-clockwise.
constexpr std::int64_t orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// True when d lies strictly inside the circle through a, b, c, which are counter-clockwise. Differences
/// are below 2^30, lifts and minors below 2^61, their products below 2^122.
constexpr bool in_circle(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  __extension__ using Wide = __int128;
  const std::int64_t ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y;
  const std::int64_t cx = c.x - d.x, cy = c.y - d.y;
  const Wide determinant = Wide{ax * ax + ay * ay} * (bx * cy - by * cx) +
                           Wide{bx * bx + by * by} * (cx * ay - cy * ax) +
                           Wide{cx * cx + cy * cy} * (ax * by - ay * bx);
  return determinant > 0;
}

}  // namespace toile::mesh
