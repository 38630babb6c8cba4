#pragma once
// How two features lie to each other, and what that asks of their vertices: entries for the lists of
// Contacts.

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/collision/contacts.h"
#include "core/collision/obstacle.h"

namespace toile::collision {

struct ContactSettings {
  double thickness = 1e-3;  ///< m, distance that layers of cloth keep
  /// m, at most, of each vertex; empty: `thickness` for all. Where triangles are narrower than the cloth is
  /// thick, neighbours in the flat would push each other apart.
  std::vector<double> vertex_thickness;
  double cloth_friction = 0.3;
  double trust_radius_least = 1e-3;  ///< m
  double trust_radius_most = 5e-3;   ///< m; at most a quarter of the mean edge
  double trust_radius_seconds =
      4e-3;  ///< s, time ahead that a trust region covers at 1.5 times the present speed
};

/// A pair is listed when its features, each with its vertices at their centres, come nearer than their trust
/// regions reach. What it asks for is measured where they are now, which is elsewhere for vertices that were
/// measured earlier.
class PairMeasure {
 public:
  /// `x` (m) is where the vertices are, `at` has their centres and trust regions.
  PairMeasure(const ContactSettings& settings, std::span<const Vec3> x, const Contacts& at, FoundPairs& out)
      : settings_(settings), x_(x), at_(at), out_(out) {}

  void vertex_on_obstacle(const Obstacle& obstacle, Index vertex, Index face);
  void obstacle_vertex_on_cloth(const Obstacle& obstacle, Index theirs, const Tri& triangle);
  void edge_on_obstacle(const Obstacle& obstacle, std::array<Index, 2> mine, Index theirs);
  void vertex_on_cloth(Index vertex, const Tri& triangle);
  void edges_of_cloth(std::array<Index, 2> mine, std::array<Index, 2> theirs);

 private:
  /// Of a vertex, before the share that pairs which are not listed keep free.
  double radius(Index v) const { return at_.trust_radius[v] + 0.5 * kContactFloor; }
  double largest_radius(std::span<const Index> vertices) const;
  bool at_centres(std::span<const Index> vertices) const;
  double thickness_at(std::span<const Index> vertices) const;
  /// Notes a pair's gap; false when there is none to push along (the features touch).
  bool has_gap(double gap, Index vertex);
  Index list(std::span<const Index> vertices);
  void bound(Index pair, Index vertex, Vec3 n, Vec3 closest, double allowance);

  const ContactSettings& settings_;
  std::span<const Vec3> x_;
  const Contacts& at_;
  FoundPairs& out_;
};

}  // namespace toile::collision
