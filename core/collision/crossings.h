#pragma once
// Counting crossings exactly. A crossing is an edge's interior through a triangle's interior. Positions are
// rounded to 2⁻²⁰ m (about a micrometre) and compared with integers, so that the answer has no tolerance and
// is the same everywhere. Touching is no crossing; elements that share a vertex (or a sewn one) meet there
// by right and count only where another part of them crosses.

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/collision/surface.h"
#include "core/geometry/box_groups.h"

namespace toile {
class Crew;
}

namespace toile::collision {

/// A position in units of 2⁻²⁰ m. |x| stays below 2³¹ for positions within two kilometres.
struct ExactPoint {
  std::int64_t x = 0, y = 0, z = 0;
};
ExactPoint to_grid(Vec3 p);

/// Sign of the volume of the tetrahedron (a, b, c, d): +1 when d lies on the side of triangle abc from which
/// abc runs clockwise, −1 on the other, 0 in its plane. Exact.
int orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);

/// True when the open segment pq passes through the open triangle abc. Exact.
bool segment_crosses_triangle(const ExactPoint& p, const ExactPoint& q, const ExactPoint& a,
                              const ExactPoint& b, const ExactPoint& c);

/// A triangle's corners, and its plane in doubles for the questions that need no exactness.
struct CrossingFace {
  std::array<const ExactPoint*, 3> corners;
  double normal[3] = {};
  double slack = 0;  ///< normal · d is right to slack · Σ|d|, d the way from the first corner
};

/// A solid's surface, ready for repeated counting.
struct CrossingBody {
  std::vector<ExactPoint> points;
  std::vector<Tri> triangles;
  geometry::BoxGroups groups;
};
CrossingBody make_crossing_body(std::span<const Vec3> vertices, std::span<const Tri> triangles);

/// Pairs of triangles, in order.
using CrossingPairs = std::vector<std::array<Index, 2>>;

/// Pairs of triangles (cloth, body) that cross.
CrossingPairs body_crossings(const Surface& cloth, std::span<const Vec3> positions, const CrossingBody& body);

/// Pairs of cloth triangles that cross, first < second. Pairs that share two vertices or more cannot.
CrossingPairs self_crossings(const Surface& cloth, std::span<const Vec3> positions);

/// Counts for one cloth again and again while it moves: boxes are grouped once.
class CrossingCounter {
 public:
  explicit CrossingCounter(Surface cloth) : cloth_(std::move(cloth)) {}

  const Surface& cloth() const { return cloth_; }
  /// Where the cloth is now; needed first. As many positions (m) as the surface has vertices.
  void place(std::span<const Vec3> positions);
  CrossingPairs with(const CrossingBody& body, Crew& crew) const;  ///< as body_crossings()
  CrossingPairs with_itself(Crew& crew) const;                     ///< as self_crossings()
  /// The same where `before` was the answer for the places before these: what did not move since is not
  /// looked at again. Untangling moves a few triangles of many.
  CrossingPairs with(const CrossingBody& body, CrossingPairs before, Crew& crew) const;
  CrossingPairs with_itself(CrossingPairs before, Crew& crew) const;

 private:
  void find_moved(const std::vector<ExactPoint>& before);
  bool few_moved() const;
  bool crosses(Index t, const CrossingBody& body, Index s) const;
  bool cross_each_other(Index s, Index t) const;

  Surface cloth_;
  std::vector<bool> has_moved_;  ///< which triangles did when they were placed last
  std::vector<Index> moved_;     ///< the same as a list
  std::vector<geometry::Box3> boxes_;
  std::vector<ExactPoint> points_;
  std::vector<CrossingFace> faces_;
  geometry::BoxGroups groups_;
};

}  // namespace toile::collision
