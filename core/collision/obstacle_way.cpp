#include "core/collision/obstacle_way.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "core/base/check.h"
#include "core/collision/contacts.h"
#include "core/collision/nearest.h"

namespace toile::collision {

namespace {

/// Of a gap, what the solid may take at once; contact pushes the cloth off again before the next time.
constexpr double kShareOfGap = 0.5;

double allowance(double gap) { return std::max(0.0, std::min(kShareOfGap * gap, gap - 2 * kContactFloor)); }

/// The shortest way so far.
struct Shortest {
  const Obstacle& obstacle;
  std::span<const Vec3> to;
  ObstacleWay way = {};

  /// `p` on the cloth and `q` on the obstacle are the closest points of a pair, `theirs` its vertices.
  void meet(Vec3 p, Vec3 q, std::initializer_list<Index> theirs, Index mine) {
    const double gap = length(p - q);
    if (!(gap > 0)) return shorten(0, mine);  // no plane is between them
    const Vec3 n = (p - q) * (1 / gap);
    for (const Index v : theirs) {
      const Vec3 from = obstacle.vertices[v];
      const double towards = dot(n, to[v] - from);
      const double room = std::max(0.0, dot(n, q - from)) + allowance(gap);
      if (towards > room) shorten(room / towards, mine);
    }
  }

  /// Of equal ones the least vertex counts, so that the order of the pairs does not matter.
  void shorten(double share, Index mine) {
    if (share < way.share || (share == way.share && mine < way.vertex)) way = {share, mine};
  }
};

}  // namespace

ObstacleWays::ObstacleWays(Surface cloth) : cloth_(std::move(cloth)) {}

void ObstacleWays::place(std::span<const Vec3> x) {
  TOILE_CHECK(x.size() == cloth_.vertex_class.size());
  x_.assign(x.begin(), x.end());
  boxes_.vertices.resize(x.size());
  for (const Index v : cloth_.vertices) boxes_.vertices[v] = geometry::box_around({x[v]}, 2 * kContactFloor);
  boxes_.lay_around(cloth_);
}

ObstacleWay ObstacleWays::way(const Obstacle& obstacle, std::span<const Vec3> to, FeatureBoxes& boxes) const {
  TOILE_CHECK(to.size() == obstacle.vertices.size());
  boxes.vertices.resize(to.size());
  for (const Index v : obstacle.surface.vertices)
    boxes.vertices[v] = geometry::box_around({obstacle.vertices[v], to[v]}, 0);
  boxes.lay_around(obstacle.surface);
  Shortest shortest{obstacle, to};
  boxes_.vertex_groups.pairs(boxes.face_groups, [&](Index v, Index t) {
    const Tri& face = obstacle.surface.triangles[t];
    const Vec3 q = nearest_on(x_[v], obstacle.vertices, face).q;
    shortest.meet(x_[v], q, {face[0], face[1], face[2]}, v);
  });
  boxes_.face_groups.pairs(boxes.vertex_groups, [&](Index t, Index v) {
    const Tri& mine = cloth_.triangles[t];
    const Vec3 q = obstacle.vertices[v];
    shortest.meet(nearest_on(q, x_, mine).q, q, {v}, mine[0]);
  });
  boxes_.edge_groups.pairs(boxes.edge_groups, [&](Index e, Index f) {
    const auto [a0, a1] = cloth_.edges[e];
    const auto [b0, b1] = obstacle.surface.edges[f];
    const BetweenEdges at = nearest_between(x_[a0], x_[a1], obstacle.vertices[b0], obstacle.vertices[b1]);
    shortest.meet(at.p, at.q, {b0, b1}, a0);
  });
  return shortest.way;
}

}  // namespace toile::collision
