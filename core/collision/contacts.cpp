#include "core/collision/contacts.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/geometry/distance.h"

namespace toile::collision {

namespace {

/// Of a gap to the still skin a vertex may use most; of a gap between two moving layers each side less than
/// half.
constexpr double kShareOfBodyGap = 0.7;
constexpr double kShareOfClothGap = 0.45;

/// Where cloth hangs over a rim, its vertices are clear while its edges and faces come near. Those are pushed
/// off to a share of the distance that vertices keep, so that on even ground vertices alone carry the cloth.
constexpr double kRimShare = 0.5;

/// Keeps what rounds to the rim of a vertex's free radius within its bounds.
constexpr double kInsideRounding = 1 - 1e-9;

/// Cosine above which two contacts of a vertex count as on the same side.
constexpr double kSameSide = 0.2;

/// Of the gap to a body, or of its skin offset if that is less, how far cloth must lie above its own plane
/// for that one to serve.
constexpr double kFlatShare = 0.5;

/// Planes that a vertex is led along before it is stopped.
constexpr int kMostTurns = 3;

/// Of a way, what may seem to lead into a plane that it runs along: rounding.
constexpr double kAlong = 1e-12;

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

/// A null vector where there is none.
void lay_normals(Obstacle& obstacle) {
  const Surface& surface = obstacle.surface;
  obstacle.vertex_normals.resize(obstacle.vertices.size());
  std::map<std::array<Index, 2>, Vec3> sums;  // by ends, the lesser first
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 p = obstacle.vertices[a];
    const Vec3 n = normalized(cross(obstacle.vertices[b] - p, obstacle.vertices[c] - p));
    obstacle.face_normals.push_back(n);
    for (const Index v : {a, b, c}) obstacle.vertex_normals[v] += n;
    for (const auto& [i, j] : {std::pair{a, b}, {b, c}, {c, a}}) sums[{std::min(i, j), std::max(i, j)}] += n;
  }
  for (Vec3& n : obstacle.vertex_normals) n = normalized(n);
  for (const auto& [i, j] : surface.edges)
    obstacle.edge_normals.push_back(normalized(sums[{std::min(i, j), std::max(i, j)}]));
}

double largest_radius(const std::vector<double>& radius, const Tri& t) {
  return std::max({radius[t[0]], radius[t[1]], radius[t[2]]});
}

/// Largest t in [0, 1] with |start + t·way| within the radius; start lies inside.
double within_ball(Vec3 start, Vec3 way, double radius) {
  const Vec3 end = start + way;
  if (dot(end, end) <= radius * radius) return 1;
  const double a = dot(way, way), b = dot(start, way), c = dot(start, start) - radius * radius;
  const double root = b * b - a * c;
  return root > 0 && a > 0 ? std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0) : 0;
}

bool inside_both(geometry::EdgePoints at) { return at.s > 0 && at.s < 1 && at.t > 0 && at.t < 1; }

}  // namespace

void FeatureBoxes::lay_around(const Surface& surface) {
  edges.resize(surface.edges.size());
  faces.resize(surface.triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    edges[e] = geometry::join(vertices[surface.edges[e][0]], vertices[surface.edges[e][1]]);
  }
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const Tri& v = surface.triangles[t];
    faces[t] = geometry::join(geometry::join(vertices[v[0]], vertices[v[1]]), vertices[v[2]]);
  }
  for (const auto& [groups, boxes] :
       {std::pair{&vertex_groups, &vertices}, {&edge_groups, &edges}, {&face_groups, &faces}}) {
    if (groups->empty()) {
      *groups = geometry::BoxGroups(*boxes);
    } else {
      groups->refit(*boxes);
    }
  }
}

Obstacle make_obstacle(std::span<const Vec3> vertices, std::span<const Tri> triangles, double friction,
                       double skin_offset, double restitution) {
  Obstacle obstacle;
  obstacle.vertices.assign(vertices.begin(), vertices.end());
  obstacle.surface = make_surface(triangles, static_cast<Index>(vertices.size()));
  obstacle.boxes.vertices.resize(vertices.size());
  for (const Index v : obstacle.surface.vertices) {
    obstacle.boxes.vertices[v] = geometry::box_around({vertices[v]}, skin_offset);
  }
  obstacle.boxes.lay_around(obstacle.surface);
  for (const auto& [a, b] : obstacle.surface.edges) {
    obstacle.edge_lines.push_back(edge_line(vertices[a], vertices[b], 0));
  }
  lay_normals(obstacle);
  obstacle.friction = friction;
  obstacle.skin_offset = skin_offset;
  obstacle.restitution = restitution;
  return obstacle;
}

bool Contacts::inside_trust_region(Index v, Vec3 x) const {
  const Vec3 d = x - centre[v];
  return dot(d, d) <= trust_radius[v] * trust_radius[v];
}

bool Contacts::inside_planes(Index v, Vec3 x) const {
  const Vec3 d = x - centre[v];
  for (Index k = plane_start[v]; k < plane_start[v + 1]; ++k) {
    if (dot(planes[k].n, d) < -planes[k].slack) return false;
  }
  return true;
}

double Contacts::plane_reach(Index v, Vec3 from, Vec3 to) const {
  const Vec3 start = from - centre[v], way = to - from;
  double t = 1;
  for (Index k = plane_start[v]; k < plane_start[v + 1]; ++k) {
    const double speed = dot(planes[k].n, way);
    if (speed >= 0) continue;
    const double room = dot(planes[k].n, start) + planes[k].slack;
    if (room + t * speed < 0) t = std::max(0.0, room / -speed);
  }
  return t;
}

Vec3 Contacts::reached(Index v, Vec3 from, Vec3 to) const {
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const Vec3 start = from - centre[v], way = to - from;
    const double along = kAlong * length(way);
    const DivisionPlane* met = nullptr;
    double t = 1;
    for (Index k = plane_start[v]; k < plane_start[v + 1]; ++k) {
      const double inwards = -dot(planes[k].n, way);
      if (inwards <= along) continue;
      const double free = std::max(0.0, (dot(planes[k].n, start) + planes[k].slack) / inwards);
      if (free >= t) continue;
      t = free;
      met = &planes[k];
    }
    const double ball = within_ball(start, way, trust_radius[v]);
    if (ball < t) return from + way * ball;
    if (!met) return to;
    from += way * t;
    const Vec3 left = to - from;
    to = from + (left - met->n * dot(met->n, left));
  }
  return from;
}

ContactFinder::ContactFinder(Surface cloth, std::span<const Obstacle> obstacles, ContactSettings settings)
    : cloth_(std::move(cloth)), obstacles_(obstacles), settings_(std::move(settings)) {
  for (const auto& [a, b] : cloth_.edges) {
    edge_classes_.push_back({cloth_.vertex_class[a], cloth_.vertex_class[b]});
  }
}

void ContactFinder::detect(std::span<const Vec3> positions, std::span<const double> speeds, Contacts& out) {
  out.centre.assign(positions.begin(), positions.end());
  out.least_gap = 1;
  out.least_gap_vertex = kNone;
  found_.clear();
  near_.clear();
  rims_.clear();
  size_trust_regions(speeds, out);
  lay_boxes(positions, out);
  lay_edge_lines(positions, out);
  pair_with_obstacles(out);
  pair_with_itself(out);
  sort_planes(out);
  keep_nearest(out);
  // Two vertices whose pair is not listed may both use their trust regions whole, and must not touch even
  // then.
  for (double& radius : out.trust_radius) radius -= 0.5 * kContactFloor;
  find_free_radii(out);
}

void ContactFinder::find_free_radii(Contacts& out) const {
  out.free_radius = out.trust_radius;
  for (std::size_t v = 0; v < out.free_radius.size(); ++v) {
    for (Index k = out.plane_start[v]; k < out.plane_start[v + 1]; ++k)
      out.free_radius[v] = std::min(out.free_radius[v], out.planes[k].slack);
    out.free_radius[v] *= kInsideRounding;
  }
}

void ContactFinder::size_trust_regions(std::span<const double> speeds, Contacts& out) const {
  out.trust_radius.resize(speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    out.trust_radius[i] = std::clamp(1.5 * speeds[i] * settings_.trust_radius_seconds,
                                     settings_.trust_radius_least, settings_.trust_radius_most);
  }
}

void ContactFinder::lay_boxes(std::span<const Vec3> positions, const Contacts& out) {
  boxes_.vertices.resize(positions.size());
  for (const Index v : cloth_.vertices) {
    boxes_.vertices[v] =
        geometry::box_around({positions[v]}, std::max(out.trust_radius[v], 0.5 * settings_.thickness));
  }
  boxes_.lay_around(cloth_);
}

void ContactFinder::lay_edge_lines(std::span<const Vec3> positions, const Contacts& out) {
  edge_lines_.resize(cloth_.edges.size());
  for (std::size_t e = 0; e < edge_lines_.size(); ++e) {
    const auto [a, b] = cloth_.edges[e];
    edge_lines_[e] =
        edge_line(positions[a], positions[b], std::max(out.trust_radius[a], out.trust_radius[b]));
  }
}

void ContactFinder::pair_with_obstacles(Contacts& out) {
  for (const Obstacle& obstacle : obstacles_) {
    boxes_.vertex_groups.pairs(obstacle.boxes.face_groups,
                               [&](Index v, Index t) { vertex_on_obstacle(obstacle, v, t, out); });
    boxes_.face_groups.pairs(obstacle.boxes.vertex_groups, [&](Index t, Index v) {
      obstacle_vertex_on_cloth(obstacle, v, cloth_.triangles[t], out);
    });
    edge_pairs_.clear();
    boxes_.edge_groups.pairs(obstacle.boxes.edge_groups,
                             [&](Index e, Index f) { edge_pairs_.emplace_back(e, f); });
    visit_near(edge_pairs_, edge_lines_, obstacle.edge_lines, [&](Index e, Index f) {
      const auto [a0, a1] = cloth_.edges[e];
      edge_on_obstacle(obstacle, a0, a1, f, out);
    });
  }
}

void ContactFinder::pair_with_itself(Contacts& out) {
  boxes_.vertex_groups.pairs(boxes_.face_groups,
                             [&](Index v, Index t) { vertex_on_cloth(v, cloth_.triangles[t], out); });
  edge_pairs_.clear();
  boxes_.edge_groups.self_pairs([&](Index e, Index f) {
    const auto [a0, a1] = edge_classes_[e];
    const auto [b0, b1] = edge_classes_[f];
    if (!((a0 == b0) | (a0 == b1) | (a1 == b0) | (a1 == b1))) edge_pairs_.emplace_back(e, f);
  });
  visit_near(edge_pairs_, edge_lines_, edge_lines_, [&](Index e, Index f) {
    edges_of_cloth(cloth_.edges[e][0], cloth_.edges[e][1], cloth_.edges[f][0], cloth_.edges[f][1], out);
  });
}

void ContactFinder::vertex_on_obstacle(const Obstacle& obstacle, Index vertex, Index face, Contacts& out) {
  const Tri& corners = obstacle.surface.triangles[face];
  const Vec3 p = out.centre[vertex];
  const Vec3 a = obstacle.vertices[corners[0]], b = obstacle.vertices[corners[1]],
             c = obstacle.vertices[corners[2]];
  const double reach = out.trust_radius[vertex] + obstacle.skin_offset;
  const geometry::TrianglePoint at = geometry::closest_on_triangle(p, a, b, c);
  const Vec3 q = a * at.a + b * at.b + c * at.c;
  const double gap = length(p - q);
  if (!has_gap(gap, reach, vertex, out)) return;
  const Vec3 n = (p - q) * (1 / gap);
  const Separation apart =
      flattest({n, dot(n, q), gap}, obstacle.face_normals[face], a, p, obstacle.skin_offset);
  bound(vertex, apart.n, p, body_allowance(apart.gap), out);
  Contact contact;
  contact.count = 1;
  contact.v[0] = vertex;
  contact.w[0] = 1;
  contact.n = apart.n;
  contact.c = apart.c;
  contact.rest = obstacle.skin_offset;
  contact.friction = obstacle.friction;
  contact.restitution = obstacle.restitution;
  near_.push_back({gap, contact});
}

void ContactFinder::obstacle_vertex_on_cloth(const Obstacle& obstacle, Index theirs, const Tri& triangle,
                                             Contacts& out) {
  const Vec3 point = obstacle.vertices[theirs];
  const Vec3 a = out.centre[triangle[0]], b = out.centre[triangle[1]], c = out.centre[triangle[2]];
  const double reach = largest_radius(out.trust_radius, triangle);
  const geometry::TrianglePoint at = geometry::closest_on_triangle(point, a, b, c);
  const Vec3 q = a * at.a + b * at.b + c * at.c;
  const double gap = length(q - point);
  if (!has_gap(gap, reach, triangle[0], out)) return;
  const Vec3 n = (q - point) * (1 / gap);
  const Vec3 normal = obstacle.vertex_normals[theirs];
  Vec3 lowest = a;
  for (const Vec3& corner : {b, c}) {
    if (dot(normal, corner - lowest) < 0) lowest = corner;
  }
  const Separation apart = flattest({n, dot(n, point), gap}, normal, point, lowest, obstacle.skin_offset);
  for (const Index v : triangle) bound(v, apart.n, apart.flat ? lowest : q, body_allowance(apart.gap), out);
  if (gap < obstacle.skin_offset && std::min({at.a, at.b, at.c}) > 0) {
    rims_.push_back({3,
                     {triangle[0], triangle[1], triangle[2], kNone},
                     {at.a, at.b, at.c, 0},
                     n,
                     dot(n, point),
                     kRimShare * obstacle.skin_offset,
                     obstacle.friction,
                     obstacle.restitution});
  }
}

void ContactFinder::edge_on_obstacle(const Obstacle& obstacle, Index a0, Index a1, Index theirs,
                                     Contacts& out) {
  const Vec3 b0 = obstacle.vertices[obstacle.surface.edges[theirs][0]],
             b1 = obstacle.vertices[obstacle.surface.edges[theirs][1]];
  const Vec3 p0 = out.centre[a0], p1 = out.centre[a1];
  const double reach = std::max(out.trust_radius[a0], out.trust_radius[a1]);
  const geometry::EdgePoints at = geometry::closest_on_edges(p0, p1, b0, b1);
  const Vec3 p = p0 + (p1 - p0) * at.s, q = b0 + (b1 - b0) * at.t;
  const double gap = length(p - q);
  if (!has_gap(gap, reach, a0, out)) return;
  const Vec3 n = (p - q) * (1 / gap);
  const Vec3 normal = obstacle.edge_normals[theirs];
  const Vec3 lowest = dot(normal, p1 - p0) > 0 ? p0 : p1;
  const Separation apart = flattest({n, dot(n, q), gap}, normal, b0, lowest, obstacle.skin_offset);
  for (const Index v : {a0, a1}) bound(v, apart.n, apart.flat ? lowest : p, body_allowance(apart.gap), out);
  // On flat ground the ends carry an edge.
  const bool clear = apart.flat && apart.gap >= kRimShare * obstacle.skin_offset;
  if (gap < obstacle.skin_offset && inside_both(at) && !clear) {
    rims_.push_back({2,
                     {a0, a1, kNone, kNone},
                     {1 - at.s, at.s, 0, 0},
                     n,
                     dot(n, q),
                     kRimShare * obstacle.skin_offset,
                     obstacle.friction,
                     obstacle.restitution});
  }
}

void ContactFinder::vertex_on_cloth(Index vertex, const Tri& triangle, Contacts& out) {
  for (const Index v : triangle) {
    if (neighbours(v, vertex)) return;
  }
  const Vec3 p = out.centre[vertex];
  const Vec3 a = out.centre[triangle[0]], b = out.centre[triangle[1]], c = out.centre[triangle[2]];
  const double both = out.trust_radius[vertex] + largest_radius(out.trust_radius, triangle);
  const double reach = std::max(both, settings_.thickness);
  const geometry::TrianglePoint at = geometry::closest_on_triangle(p, a, b, c);
  const Vec3 q = a * at.a + b * at.b + c * at.c;
  const double gap = length(p - q);
  if (!has_gap(gap, reach, vertex, out)) return;
  const Vec3 n = (p - q) * (1 / gap);
  const double allowance = cloth_allowance(gap);
  bound(vertex, n, p, allowance, out);
  for (const Index v : triangle) bound(v, -n, q, allowance, out);
  near_.push_back({gap,
                   {4,
                    {vertex, triangle[0], triangle[1], triangle[2]},
                    {1, -at.a, -at.b, -at.c},
                    n,
                    0,
                    thickness_at({vertex, triangle[0], triangle[1], triangle[2]}),
                    settings_.cloth_friction}});
}

void ContactFinder::edges_of_cloth(Index a0, Index a1, Index b0, Index b1, Contacts& out) {
  const Vec3 p0 = out.centre[a0], p1 = out.centre[a1], q0 = out.centre[b0], q1 = out.centre[b1];
  const double reach = std::max(out.trust_radius[a0], out.trust_radius[a1]) +
                       std::max(out.trust_radius[b0], out.trust_radius[b1]);
  const geometry::EdgePoints at = geometry::closest_on_edges(p0, p1, q0, q1);
  const Vec3 p = p0 + (p1 - p0) * at.s, q = q0 + (q1 - q0) * at.t;
  const double gap = length(p - q);
  if (!has_gap(gap, reach, a0, out)) return;
  const Vec3 n = (p - q) * (1 / gap);
  const double allowance = cloth_allowance(gap);
  bound(a0, n, p, allowance, out);
  bound(a1, n, p, allowance, out);
  bound(b0, -n, q, allowance, out);
  bound(b1, -n, q, allowance, out);
  const double thickness = thickness_at({a0, a1, b0, b1});
  if (gap < thickness && inside_both(at)) {
    rims_.push_back({4,
                     {a0, a1, b0, b1},
                     {1 - at.s, at.s, at.t - 1, -at.t},
                     n,
                     0,
                     kRimShare * thickness,
                     settings_.cloth_friction});
  }
}

double ContactFinder::thickness_at(std::initializer_list<Index> vertices) const {
  double thickness = settings_.thickness;
  if (settings_.vertex_thickness.empty()) return thickness;
  for (const Index v : vertices) thickness = std::min(thickness, settings_.vertex_thickness[v]);
  return thickness;
}

bool ContactFinder::has_gap(double gap, double reach, Index vertex, Contacts& out) {
  if (gap >= reach) return false;
  if (gap < out.least_gap) {
    out.least_gap = gap;
    out.least_gap_vertex = vertex;
  }
  return gap > 0;
}

/// The plane through `closest` separates the pair; a vertex behind it by some way may come that much closer.
/// What its trust region never reaches needs no plane.
void ContactFinder::bound(Index vertex, Vec3 n, Vec3 closest, double allowance, const Contacts& out) {
  const double slack = std::max(0.0, dot(n, out.centre[vertex] - closest)) + allowance;
  if (slack < out.trust_radius[vertex]) found_.push_back({vertex, {n, slack}});
}

void ContactFinder::sort_planes(Contacts& out) {
  out.plane_start.assign(out.trust_radius.size() + 1, 0);
  for (const VertexPlane& f : found_) ++out.plane_start[f.vertex + 1];
  for (std::size_t i = 1; i < out.plane_start.size(); ++i) out.plane_start[i] += out.plane_start[i - 1];
  out.planes.resize(found_.size());
  std::vector<Index> next(out.plane_start.begin(), out.plane_start.end() - 1);
  for (const VertexPlane& f : found_) out.planes[next[f.vertex]++] = f.plane;
}

/// A vertex rests on what is nearest on each side. The rim of a neighbouring face, seen at a slant, is
/// further away in about the same direction; pushing off from it would hold the vertex back as it slides
/// there.
void ContactFinder::keep_nearest(Contacts& out) {
  std::stable_sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) {
    return a.contact.v[0] != b.contact.v[0] ? a.contact.v[0] < b.contact.v[0] : a.gap < b.gap;
  });
  out.contacts.clear();
  std::size_t first = 0;  // of the vertex's contacts in near_
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (near_[i].contact.v[0] != near_[first].contact.v[0]) {
      first = i;
      kept.clear();
    }
    const bool hidden = std::any_of(kept.begin(), kept.end(), [&](std::size_t k) {
      return dot(near_[i].contact.n, near_[k].contact.n) > kSameSide &&
             near_[i].gap > 1.05 * near_[k].gap + kContactFloor;
    });
    if (hidden) continue;
    kept.push_back(i);
    out.contacts.push_back(near_[i].contact);
  }
  out.contacts.insert(out.contacts.end(), rims_.begin(), rims_.end());
}

}  // namespace toile::collision
