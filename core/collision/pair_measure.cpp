#include "core/collision/pair_measure.h"

#include <algorithm>
#include <utility>

#include "core/collision/nearest.h"

namespace toile::collision {

namespace {

/// Of a gap to the still skin a vertex may use most; of a gap between two moving layers each side less than
/// half.
constexpr double kShareOfBodyGap = 0.7;
constexpr double kShareOfClothGap = 0.45;

/// Where cloth hangs over a rim, its vertices are clear while its edges and faces come near. Those are pushed
/// off to a share of the distance that vertices keep, so that on even ground vertices alone carry the cloth.
constexpr double kRimShare = 0.5;

/// Of the gap to a body, or of its skin offset if that is less, how far cloth must lie above its own plane
/// for that one to serve.
constexpr double kFlatShare = 0.5;

double body_allowance(double gap) {
  return std::max(0.0, std::min(kShareOfBodyGap * gap, gap - kContactFloor));
}
double cloth_allowance(double gap) {
  return std::max(0.0, std::min(kShareOfClothGap * gap, 0.5 * (gap - kContactFloor)));
}

/// A plane that keeps a feature of the cloth and one of a body apart: c is n·x on the body's side, gap how
/// far above the cloth's lies.
struct Separation {
  Vec3 n;
  double c = 0, gap = 0;
  bool flat = false;
};

/// Where the closest points lie on a border, the plane between them slants across the way of cloth that
/// slides past, which would be held up by ground that is as flat there as before. If the cloth, `lowest` by
/// its lowest point, lies well above the body's own plane with normal `normal` through q, that one serves.
Separation flattest(const Separation& between, Vec3 normal, Vec3 q, Vec3 lowest, double skin_offset) {
  const double gap = dot(normal, lowest - q);
  if (gap < kFlatShare * std::min(between.gap, skin_offset)) return between;
  return {normal, dot(normal, q), gap, true};
}

/// m/s, of a place on a solid that moves, by shares of its vertices.
Vec3 velocity_at(const Obstacle& obstacle, std::initializer_list<std::pair<Index, double>> shares) {
  Vec3 v;
  if (obstacle.velocities.empty()) return v;
  for (const auto& [vertex, share] : shares) v += obstacle.velocities[vertex] * share;
  return v;
}

bool inside_both(geometry::EdgePoints at) { return at.s > 0 && at.s < 1 && at.t > 0 && at.t < 1; }

}  // namespace

double PairMeasure::largest_radius(std::span<const Index> vertices) const {
  double most = 0;
  for (const Index v : vertices) most = std::max(most, radius(v));
  return most;
}

bool PairMeasure::at_centres(std::span<const Index> vertices) const {
  return std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return x_[v] == at_.centre[v]; });
}

double PairMeasure::thickness_at(std::span<const Index> vertices) const {
  double thickness = settings_.thickness;
  if (settings_.vertex_thickness.empty()) return thickness;
  for (const Index v : vertices) thickness = std::min(thickness, settings_.vertex_thickness[v]);
  return thickness;
}

bool PairMeasure::has_gap(double gap, Index vertex) {
  if (gap < out_.least_gap) {
    out_.least_gap = gap;
    out_.least_gap_vertex = vertex;
  }
  return gap > 0;
}

Index PairMeasure::list(std::span<const Index> vertices) {
  ListedPair pair;
  std::copy(vertices.begin(), vertices.end(), pair.v.begin());
  out_.pairs.push_back(pair);
  return static_cast<Index>(out_.pairs.size()) - 1;
}

/// The plane through `closest` separates the pair; a vertex behind it by some way may come that much closer.
/// What its trust region never reaches needs no plane.
void PairMeasure::bound(Index pair, Index vertex, Vec3 n, Vec3 closest, double allowance) {
  const double room = std::max(0.0, dot(n, x_[vertex] - closest)) + allowance;
  const double slack = room + dot(n, at_.centre[vertex] - x_[vertex]);
  if (slack < radius(vertex)) out_.bounds.push_back({vertex, {n, slack, pair}});
}

void PairMeasure::vertex_on_obstacle(const Obstacle& obstacle, Index vertex, Index face) {
  const Tri& corners = obstacle.surface.triangles[face];
  const Vec3 p = x_[vertex];
  const OnTriangle there = nearest_on(p, obstacle.vertices, corners);
  const double gap = length(p - there.q);
  if (gap >= radius(vertex) + obstacle.skin_offset || !has_gap(gap, vertex)) return;
  const Vec3 n = (p - there.q) * (1 / gap);
  const Separation apart = flattest({n, dot(n, there.q), gap}, obstacle.face_normals[face],
                                    obstacle.vertices[corners[0]], p, obstacle.skin_offset);
  const Index pair = list({{vertex}});
  bound(pair, vertex, apart.n, p, body_allowance(apart.gap));
  Contact contact;
  contact.count = 1;
  contact.v[0] = vertex;
  contact.w[0] = 1;
  contact.n = apart.n;
  contact.c = apart.c;
  contact.rest = obstacle.skin_offset;
  contact.friction = obstacle.friction;
  contact.restitution = obstacle.restitution;
  contact.carried =
      velocity_at(obstacle, {{corners[0], there.at.a}, {corners[1], there.at.b}, {corners[2], there.at.c}});
  out_.vertex_contacts.push_back({pair, gap, false, contact});
}

void PairMeasure::obstacle_vertex_on_cloth(const Obstacle& obstacle, Index theirs, const Tri& triangle) {
  const Vec3 point = obstacle.vertices[theirs];
  OnTriangle here = nearest_on(point, at_.centre, triangle);
  if (length(here.q - point) >= largest_radius(triangle)) return;
  if (!at_centres(triangle)) here = nearest_on(point, x_, triangle);
  const double gap = length(here.q - point);
  if (!has_gap(gap, triangle[0])) return;
  const Vec3 n = (here.q - point) * (1 / gap);
  const Vec3 normal = obstacle.vertex_normals[theirs];
  Vec3 lowest = x_[triangle[0]];
  for (const Index v : {triangle[1], triangle[2]}) {
    if (dot(normal, x_[v] - lowest) < 0) lowest = x_[v];
  }
  const Separation apart = flattest({n, dot(n, point), gap}, normal, point, lowest, obstacle.skin_offset);
  const Index pair = list(triangle);
  for (const Index v : triangle)
    bound(pair, v, apart.n, apart.flat ? lowest : here.q, body_allowance(apart.gap));
  if (gap < obstacle.skin_offset && std::min({here.at.a, here.at.b, here.at.c}) > 0) {
    out_.rims.push_back({pair,
                         {3,
                          {triangle[0], triangle[1], triangle[2], kNone},
                          {here.at.a, here.at.b, here.at.c, 0},
                          n,
                          dot(n, point),
                          kRimShare * obstacle.skin_offset,
                          obstacle.friction,
                          obstacle.restitution,
                          velocity_at(obstacle, {{theirs, 1}})}});
  }
}

void PairMeasure::edge_on_obstacle(const Obstacle& obstacle, std::array<Index, 2> mine, Index theirs) {
  const auto [a0, a1] = mine;
  const Vec3 b0 = obstacle.vertices[obstacle.surface.edges[theirs][0]],
             b1 = obstacle.vertices[obstacle.surface.edges[theirs][1]];
  BetweenEdges between = nearest_between(at_.centre[a0], at_.centre[a1], b0, b1);
  if (length(between.p - between.q) >= largest_radius(mine)) return;
  if (!at_centres(mine)) between = nearest_between(x_[a0], x_[a1], b0, b1);
  const auto& [at, p, q] = between;
  const double gap = length(p - q);
  if (!has_gap(gap, a0)) return;
  const Vec3 n = (p - q) * (1 / gap);
  const Vec3 normal = obstacle.edge_normals[theirs];
  const Vec3 lowest = dot(normal, x_[a1] - x_[a0]) > 0 ? x_[a0] : x_[a1];
  const Separation apart = flattest({n, dot(n, q), gap}, normal, b0, lowest, obstacle.skin_offset);
  const Index pair = list(mine);
  for (const Index v : mine) bound(pair, v, apart.n, apart.flat ? lowest : p, body_allowance(apart.gap));
  // On flat ground the ends carry an edge.
  const bool clear = apart.flat && apart.gap >= kRimShare * obstacle.skin_offset;
  if (gap < obstacle.skin_offset && inside_both(at) && !clear) {
    out_.rims.push_back({pair,
                         {2,
                          {a0, a1, kNone, kNone},
                          {1 - at.s, at.s, 0, 0},
                          n,
                          dot(n, q),
                          kRimShare * obstacle.skin_offset,
                          obstacle.friction,
                          obstacle.restitution,
                          velocity_at(obstacle, {{obstacle.surface.edges[theirs][0], 1 - at.t},
                                                 {obstacle.surface.edges[theirs][1], at.t}})}});
  }
}

void PairMeasure::vertex_on_cloth(Index vertex, const Tri& triangle) {
  const Index four[] = {vertex, triangle[0], triangle[1], triangle[2]};
  OnTriangle there = nearest_on(at_.centre[vertex], at_.centre, triangle);
  const double both = radius(vertex) + largest_radius(triangle);
  if (length(at_.centre[vertex] - there.q) >= std::max(both, settings_.thickness)) return;
  if (!at_centres(four)) there = nearest_on(x_[vertex], x_, triangle);
  const Vec3 p = x_[vertex];
  const double gap = length(p - there.q);
  if (!has_gap(gap, vertex)) return;
  const Vec3 n = (p - there.q) * (1 / gap);
  const double allowance = cloth_allowance(gap);
  const Index pair = list(four);
  bound(pair, vertex, n, p, allowance);
  for (const Index v : triangle) bound(pair, v, -n, there.q, allowance);
  out_.vertex_contacts.push_back({pair,
                                  gap,
                                  false,
                                  {4,
                                   {vertex, triangle[0], triangle[1], triangle[2]},
                                   {1, -there.at.a, -there.at.b, -there.at.c},
                                   n,
                                   0,
                                   thickness_at(four),
                                   settings_.cloth_friction}});
}

void PairMeasure::edges_of_cloth(std::array<Index, 2> mine, std::array<Index, 2> theirs) {
  const auto [a0, a1] = mine;
  const auto [b0, b1] = theirs;
  const Index four[] = {a0, a1, b0, b1};
  const std::vector<Vec3>& c = at_.centre;
  BetweenEdges between = nearest_between(c[a0], c[a1], c[b0], c[b1]);
  if (length(between.p - between.q) >= largest_radius(mine) + largest_radius(theirs)) return;
  if (!at_centres(four)) between = nearest_between(x_[a0], x_[a1], x_[b0], x_[b1]);
  const auto& [at, p, q] = between;
  const double gap = length(p - q);
  if (!has_gap(gap, a0)) return;
  const Vec3 n = (p - q) * (1 / gap);
  const double allowance = cloth_allowance(gap);
  const Index pair = list(four);
  for (const Index v : mine) bound(pair, v, n, p, allowance);
  for (const Index v : theirs) bound(pair, v, -n, q, allowance);
  const double thickness = thickness_at(four);
  if (gap < thickness && inside_both(at)) {
    out_.rims.push_back({pair,
                         {4,
                          {a0, a1, b0, b1},
                          {1 - at.s, at.s, at.t - 1, -at.t},
                          n,
                          0,
                          kRimShare * thickness,
                          settings_.cloth_friction}});
  }
}

}  // namespace toile::collision
