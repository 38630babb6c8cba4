#include "core/collision/crossings.h"

#include <algorithm>
#include <cmath>

#include "core/base/crew.h"

namespace toile::collision {

namespace {

constexpr double kGridPerMetre = 1 << 20;
/// Share of the triangles up to which those that moved are asked for one by one.
constexpr double kFewMoved = 0.3;

using Int128 = __int128;

int sign_of(Int128 v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// The determinant in doubles decides unless it is smaller than its rounding can be. Differences of grid
/// points are exact in double; six products of three factors err by less than 2⁻⁵⁰ of their magnitudes' sum.
int orientation_exact(Int128 ax, Int128 ay, Int128 az, Int128 bx, Int128 by, Int128 bz, Int128 cx, Int128 cy,
                      Int128 cz) {
  return sign_of(ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx));
}

// The grid moves a point by up to half a unit.
geometry::Box3 box_of(const Tri& t, std::span<const Vec3> positions) {
  return geometry::box_around({positions[t[0]], positions[t[1]], positions[t[2]]}, 1 / kGridPerMetre);
}

std::vector<geometry::Box3> boxes_of(std::span<const Tri> triangles, std::span<const Vec3> positions) {
  std::vector<geometry::Box3> boxes;
  boxes.reserve(triangles.size());
  for (const Tri& t : triangles) boxes.push_back(box_of(t, positions));
  return boxes;
}

std::vector<ExactPoint> grid_of(std::span<const Vec3> positions) {
  std::vector<ExactPoint> points;
  points.reserve(positions.size());
  for (const Vec3& p : positions) points.push_back(to_grid(p));
  return points;
}

using Corners = std::array<const ExactPoint*, 3>;

Corners corners(const Tri& t, const std::vector<ExactPoint>& points) {
  return {&points[t[0]], &points[t[1]], &points[t[2]]};
}

CrossingFace face_of(const Corners& t) {
  CrossingFace face{t};
  double u[3], v[3], most = 0;
  const auto at = [](const ExactPoint& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; };
  for (int k = 0; k < 3; ++k) {
    u[k] = static_cast<double>(at(*t[1], k) - at(*t[0], k));
    v[k] = static_cast<double>(at(*t[2], k) - at(*t[0], k));
    most = std::max({most, std::abs(u[k]), std::abs(v[k])});
  }
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    face.normal[k] = u[l] * v[m] - u[m] * v[l];
  }
  // Differences are exact; products and sums of three round by less than eight units of 2⁻⁵³ of 2 most².
  face.slack = most * most * 0x1p-48;
  return face;
}

/// Side of the face's plane that p lies on; 0 where doubles cannot tell.
int side_of(const CrossingFace& face, const ExactPoint& p) {
  const ExactPoint& origin = *face.corners[0];
  const double d[3] = {static_cast<double>(p.x - origin.x), static_cast<double>(p.y - origin.y),
                       static_cast<double>(p.z - origin.z)};
  const double side = face.normal[0] * d[0] + face.normal[1] * d[1] + face.normal[2] * d[2];
  const double unsure = face.slack * (std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]));
  return (side > unsure) - (side < -unsure);
}

/// True when all of `t` certainly lies on one side of `face`.
bool all_aside(const CrossingFace& face, const Corners& t) {
  const int side = side_of(face, *t[0]);
  return side != 0 && side == side_of(face, *t[1]) && side == side_of(face, *t[2]);
}

bool any_edge_crosses(const Corners& edges_of, const Corners& face) {
  for (int k = 0; k < 3; ++k) {
    if (segment_crosses_triangle(*edges_of[k], *edges_of[(k + 1) % 3], *face[0], *face[1], *face[2]))
      return true;
  }
  return false;
}

/// Where an edge of one passes through the other, each has corners on both sides of the other.
bool cross(const CrossingFace& a, const CrossingFace& b) {
  if (all_aside(b, a.corners) || all_aside(a, b.corners)) return false;
  return any_edge_crosses(a.corners, b.corners) || any_edge_crosses(b.corners, a.corners);
}

/// How two triangles of a cloth meet in the flat pattern.
struct Meeting {
  int shared = 0;  ///< corners of the same class
  int corner_a = 0, corner_b = 0;
};

Meeting meeting_of(const Surface& cloth, const Tri& a, const Tri& b) {
  Meeting m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (cloth.vertex_class[a[i]] == cloth.vertex_class[b[j]]) {
        ++m.shared;
        m.corner_a = i;
        m.corner_b = j;
      }
    }
  }
  return m;
}

/// Whether a plane across an axis parts the segment from the triangle.
bool axis_parts(const ExactPoint& p, const ExactPoint& q, const Corners& t) {
  const auto parted = [](std::int64_t from, std::int64_t to, std::int64_t a, std::int64_t b, std::int64_t c) {
    return std::max(from, to) < std::min({a, b, c}) || std::min(from, to) > std::max({a, b, c});
  };
  return parted(p.x, q.x, t[0]->x, t[1]->x, t[2]->x) || parted(p.y, q.y, t[0]->y, t[1]->y, t[2]->y) ||
         parted(p.z, q.z, t[0]->z, t[1]->z, t[2]->z);
}

/// The edge opposite a shared corner is the only one that can pass through the other triangle. Most edges of
/// neighbours lie beside it, near its plane or not.
bool opposite_edge_crosses(const CrossingFace& of, int corner, const CrossingFace& face) {
  const ExactPoint &p = *of.corners[(corner + 1) % 3], &q = *of.corners[(corner + 2) % 3];
  if (axis_parts(p, q, face.corners)) return false;
  const int side = side_of(face, p);
  if (side != 0 && side == side_of(face, q)) return false;
  const Corners& t = face.corners;
  return segment_crosses_triangle(p, q, *t[0], *t[1], *t[2]);
}

/// What all parts find, in order.
template <typename Look>
CrossingPairs found_in(std::span<const geometry::BoxGroups::Part> parts, Crew& crew, const Look& look) {
  std::vector<CrossingPairs> found(parts.size());
  crew.each(static_cast<int>(parts.size()),
            [&](int i) { look(parts[static_cast<std::size_t>(i)], found[static_cast<std::size_t>(i)]); });
  CrossingPairs all;
  for (const CrossingPairs& some : found) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

ExactPoint to_grid(Vec3 p) {
  return {std::llround(p.x * kGridPerMetre), std::llround(p.y * kGridPerMetre),
          std::llround(p.z * kGridPerMetre)};
}

int orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  const std::int64_t ux = a.x - d.x, uy = a.y - d.y, uz = a.z - d.z;
  const std::int64_t vx = b.x - d.x, vy = b.y - d.y, vz = b.z - d.z;
  const std::int64_t wx = c.x - d.x, wy = c.y - d.y, wz = c.z - d.z;
  const auto f = [](std::int64_t i) { return static_cast<double>(i); };
  const double t1 = f(ux) * (f(vy) * f(wz)), t2 = f(ux) * (f(vz) * f(wy)), t3 = f(uy) * (f(vz) * f(wx));
  const double t4 = f(uy) * (f(vx) * f(wz)), t5 = f(uz) * (f(vx) * f(wy)), t6 = f(uz) * (f(vy) * f(wx));
  const double det = (t1 - t2) + (t3 - t4) + (t5 - t6);
  const double bound =
      (std::abs(t1) + std::abs(t2) + std::abs(t3) + std::abs(t4) + std::abs(t5) + std::abs(t6)) * 0x1p-49;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return orientation_exact(ux, uy, uz, vx, vy, vz, wx, wy, wz);
}

bool segment_crosses_triangle(const ExactPoint& p, const ExactPoint& q, const ExactPoint& a,
                              const ExactPoint& b, const ExactPoint& c) {
  const int side_p = orientation(a, b, c, p), side_q = orientation(a, b, c, q);
  if (side_p * side_q >= 0) return false;
  const int ab = orientation(p, q, a, b);
  if (ab == 0) return false;
  return orientation(p, q, b, c) == ab && orientation(p, q, c, a) == ab;
}

CrossingBody make_crossing_body(std::span<const Vec3> vertices, std::span<const Tri> triangles) {
  return {grid_of(vertices),
          {triangles.begin(), triangles.end()},
          geometry::BoxGroups(boxes_of(triangles, vertices))};
}

void CrossingCounter::find_moved(const std::vector<ExactPoint>& before) {
  const auto same = [&](Index v) {
    return before[v].x == points_[v].x && before[v].y == points_[v].y && before[v].z == points_[v].z;
  };
  moved_.clear();
  has_moved_.assign(cloth_.triangles.size(), false);
  for (std::size_t t = 0; t < cloth_.triangles.size(); ++t) {
    const Tri& corners = cloth_.triangles[t];
    if (!before.empty() && same(corners[0]) && same(corners[1]) && same(corners[2])) continue;
    has_moved_[t] = true;
    moved_.push_back(static_cast<Index>(t));
  }
}

void CrossingCounter::place(std::span<const Vec3> positions) {
  std::vector<ExactPoint> before = std::move(points_);
  points_ = grid_of(positions);
  find_moved(before);
  faces_.resize(cloth_.triangles.size());
  boxes_.resize(cloth_.triangles.size());
  for (const Index t : moved_) {
    faces_[t] = face_of(corners(cloth_.triangles[t], points_));
    boxes_[t] = box_of(cloth_.triangles[t], positions);
  }
  // Faces point to their corners, which lie elsewhere now.
  for (std::size_t t = 0; t < faces_.size(); ++t) faces_[t].corners = corners(cloth_.triangles[t], points_);
  if (groups_.empty()) {
    groups_ = geometry::BoxGroups(boxes_);
  } else {
    groups_.refit(boxes_, moved_);
  }
}

bool CrossingCounter::few_moved() const {
  return static_cast<double>(moved_.size()) <= kFewMoved * static_cast<double>(cloth_.triangles.size());
}

bool CrossingCounter::crosses(Index t, const CrossingBody& body, Index s) const {
  const Corners skin = corners(body.triangles[s], body.points);
  return !all_aside(faces_[t], skin) && cross(faces_[t], face_of(skin));
}

bool CrossingCounter::cross_each_other(Index s, Index t) const {
  const Meeting m = meeting_of(cloth_, cloth_.triangles[s], cloth_.triangles[t]);
  if (m.shared > 1) return false;
  const CrossingFace &a = faces_[s], &b = faces_[t];
  return m.shared == 0 ? cross(a, b)
                       : opposite_edge_crosses(a, m.corner_a, b) || opposite_edge_crosses(b, m.corner_b, a);
}

CrossingPairs CrossingCounter::with(const CrossingBody& body, Crew& crew) const {
  const std::vector<geometry::BoxGroups::Part> parts = groups_.parts(body.groups, crew.parts());
  return found_in(parts, crew, [&](const geometry::BoxGroups::Part& part, CrossingPairs& found) {
    groups_.pairs_in(part, body.groups, [&](Index t, Index s) {
      if (crosses(t, body, s)) found.push_back({t, s});
    });
  });
}

CrossingPairs CrossingCounter::with(const CrossingBody& body, CrossingPairs before, Crew& crew) const {
  if (!few_moved()) return with(body, crew);
  std::erase_if(before, [&](const std::array<Index, 2>& pair) { return has_moved_[pair[0]]; });
  for (const Index t : moved_) {
    body.groups.query(boxes_[t], [&](Index s) {
      if (crosses(t, body, s)) before.push_back({t, s});
    });
  }
  std::sort(before.begin(), before.end());
  return before;
}

CrossingPairs CrossingCounter::with_itself(Crew& crew) const {
  const std::vector<geometry::BoxGroups::Part> parts = groups_.self_parts(crew.parts());
  return found_in(parts, crew, [&](const geometry::BoxGroups::Part& part, CrossingPairs& found) {
    groups_.self_pairs_in(part, [&](Index s, Index t) {
      if (cross_each_other(s, t)) found.push_back({std::min(s, t), std::max(s, t)});
    });
  });
}

CrossingPairs CrossingCounter::with_itself(CrossingPairs before, Crew& crew) const {
  if (!few_moved()) return with_itself(crew);
  std::erase_if(before,
                [&](const std::array<Index, 2>& pair) { return has_moved_[pair[0]] || has_moved_[pair[1]]; });
  for (const Index t : moved_) {
    groups_.query(boxes_[t], [&](Index s) {
      if (s == t || (has_moved_[s] && s < t)) return;  // asked from the other already
      if (cross_each_other(s, t)) before.push_back({std::min(s, t), std::max(s, t)});
    });
  }
  std::sort(before.begin(), before.end());
  return before;
}

std::vector<std::array<Index, 2>> body_crossings(const Surface& cloth, std::span<const Vec3> positions,
                                                 const CrossingBody& body) {
  CrossingCounter counter(cloth);
  counter.place(positions);
  Crew alone;
  return counter.with(body, alone);
}

std::vector<std::array<Index, 2>> self_crossings(const Surface& cloth, std::span<const Vec3> positions) {
  CrossingCounter counter(cloth);
  counter.place(positions);
  Crew alone;
  return counter.with_itself(alone);
}

}  // namespace toile::collision
