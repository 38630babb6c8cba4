#pragma once
// How far a solid may move while the cloth stands still, so that it goes through none of it. Each pair of
// features that could meet on the way keeps the plane between its closest points (as in
// core/collision/contacts.h), and the solid's side stays behind it: sliding along cloth is free.

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/collision/obstacle.h"
#include "core/collision/surface.h"

namespace toile::collision {

struct ObstacleWay {
  double share = 1;      ///< of the way, at which no pair has lost more than half of its gap
  Index vertex = kNone;  ///< of the cloth, in the way; kNone when nothing is
};

class ObstacleWays {
 public:
  explicit ObstacleWays(Surface cloth);

  /// Where the cloth stands (m); needed first.
  void place(std::span<const Vec3> x);
  /// Straight from where the obstacle is to `to` (m, one a vertex). `boxes` are kept for the next time and
  /// belong to that obstacle.
  ObstacleWay way(const Obstacle& obstacle, std::span<const Vec3> to, FeatureBoxes& boxes) const;

 private:
  Surface cloth_;
  std::vector<Vec3> x_;
  FeatureBoxes boxes_;
};

}  // namespace toile::collision
