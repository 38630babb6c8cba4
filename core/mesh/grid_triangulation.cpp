#include "core/mesh/grid_triangulation.h"

#include <algorithm>
#include <deque>
#include <numeric>

#include "core/base/check.h"
#include "core/mesh/morton.h"

namespace toile::mesh {

GridTriangulation::GridTriangulation(std::vector<GridPoint> points)
    : count_(static_cast<Index>(points.size())), points_(std::move(points)) {
  for (const GridPoint& p : points_) {
    TOILE_CHECK(p.x >= 0 && p.y >= 0 && p.x <= kGridExtent && p.y <= kGridExtent);
  }
}

std::optional<GridConflict> GridTriangulation::build(std::span<const std::array<Index, 2>> constraints,
                                                     std::span<const std::array<Index, 2>> links) {
  add_frame();
  const std::vector<Index> order = morton_order(points_, count_);
  for (const Index v : order) {
    if (auto conflict = insert(v)) return conflict;
  }
  for (const auto& [a, b] : constraints) {
    if (auto conflict = lay(a, b)) return conflict;
  }
  if (auto conflict = mark_inside(constraints)) return conflict;
  if (auto conflict = lay_links(links)) return conflict;
  restore_delaunay();
  return std::nullopt;
}

/// One triangle around everything. Its corners are vertices like others; as all constraints lie strictly
/// inside of it, its being finite takes nothing away.
void GridTriangulation::add_frame() {
  constexpr std::int64_t e = kGridExtent;
  points_.push_back({-e, -e});
  points_.push_back({3 * e, -e});
  points_.push_back({-e, 3 * e});
  static_assert(3 * e < kGridLimit);
  triangles_.reserve(2 * points_.size());
  triangles_.push_back({{count_, count_ + 1, count_ + 2}});
  triangle_of_.assign(points_.size(), 0);
}

/// The triangle that holds p, on its border or inside. Walks by orientation, which ends on Delaunay meshes.
Index GridTriangulation::locate(const GridPoint& p, Index from) {
  Index t = from, previous = kNone;
  while (true) {
    ++work_;
    const Triangle& triangle = triangles_[t];
    Index out = kNone;
    for (int i = 0; i < 3 && out == kNone; ++i) {
      if (triangle.next[i] == previous && previous != kNone) continue;
      const Index a = triangle.v[(i + 1) % 3], b = triangle.v[(i + 2) % 3];
      if (orientation(points_[a], points_[b], p) < 0) out = triangle.next[i];
    }
    if (out == kNone) return t;
    previous = t;
    t = out;
  }
}

std::optional<GridConflict> GridTriangulation::insert(Index v) {
  const Index t = locate(points_[v], last_);
  const Triangle old = triangles_[t];
  for (const Index corner : old.v) {
    if (points_[corner] == points_[v]) return GridConflict{GridConflict::Kind::kSamePlace, v, corner};
  }
  const auto u = static_cast<Index>(triangles_.size()), w = u + 1;
  const auto [a, b, c] = old.v;
  triangles_[t] = {{v, b, c}, {old.next[0], u, w}};
  triangles_.push_back({{v, c, a}, {old.next[1], w, t}});
  triangles_.push_back({{v, a, b}, {old.next[2], t, u}});
  if (old.next[1] != kNone) relink(old.next[1], t, u);
  if (old.next[2] != kNone) relink(old.next[2], t, w);
  triangle_of_[v] = triangle_of_[b] = triangle_of_[c] = t;
  triangle_of_[a] = u;
  for (const Index part : {t, u, w}) {
    suspects_.push_back({part, 0});
    const Tri& corners = triangles_[part].v;
    // On an edge: the flat part goes at once, which leaves only proper triangles.
    if (orient(corners[0], corners[1], corners[2]) == 0) flip(part, 0);
  }
  last_ = t;
  legalize();
  return std::nullopt;
}

void GridTriangulation::relink(Index t, Index from, Index to) {
  for (Index& n : triangles_[t].next) {
    if (n == from) {
      n = to;
      return;
    }
  }
}

/// Turns the edge opposite `corner` of t: (a, b, c) and (d, c, b) become (a, b, d) in t and (a, d, c) in its
/// neighbour. All their outer edges become suspects.
void GridTriangulation::flip(Index t, int corner) {
  ++work_;
  Triangle& x = triangles_[t];
  const Index u = x.next[corner];
  Triangle& y = triangles_[u];
  const int i1 = (corner + 1) % 3, i2 = (corner + 2) % 3;
  int j = 0;
  while (y.next[j] != t) ++j;
  const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  const Index a = x.v[corner], b = x.v[i1], c = x.v[i2], d = y.v[j];
  // y is (d, c, b): opposite c lies edge b-d, opposite b lies d-c.
  const Triangle first{{a, b, d}, {y.next[j1], u, x.next[i2]}, {y.fixed[j1], false, x.fixed[i2]}, x.inside};
  const Triangle second{{a, d, c}, {y.next[j2], x.next[i1], t}, {y.fixed[j2], x.fixed[i1], false}, y.inside};
  x = first;
  y = second;
  if (first.next[0] != kNone) relink(first.next[0], u, t);
  if (second.next[1] != kNone) relink(second.next[1], t, u);
  triangle_of_[a] = triangle_of_[b] = triangle_of_[d] = t;
  triangle_of_[c] = u;
  suspects_.insert(suspects_.end(), {{t, 0}, {t, 2}, {u, 0}, {u, 1}});
}

bool GridTriangulation::should_flip(Index t, int corner) const {
  const Triangle& x = triangles_[t];
  const Index u = x.next[corner];
  if (u == kNone || x.fixed[corner]) return false;
  const Triangle& y = triangles_[u];
  const int j = y.next[0] == t ? 0 : y.next[1] == t ? 1 : 2;
  return in_circle(points_[x.v[0]], points_[x.v[1]], points_[x.v[2]], points_[y.v[j]]);
}

void GridTriangulation::legalize() {
  while (!suspects_.empty()) {
    const Side side = suspects_.back();
    suspects_.pop_back();
    if (should_flip(side.triangle, side.corner)) flip(side.triangle, side.corner);
  }
}

void GridTriangulation::restore_delaunay() {
  suspects_.clear();
  for (auto t = static_cast<Index>(triangles_.size()); t-- > 0;) {
    if (!triangles_[t].inside) continue;
    for (int i = 0; i < 3; ++i) {
      if (triangles_[t].next[i] > t) suspects_.push_back({t, i});
    }
  }
  legalize();
}

/// The triangle that has b after a.
std::optional<GridTriangulation::Side> GridTriangulation::find_edge(Index a, Index b) const {
  const Index start = triangle_of_[a];
  Index t = start;
  do {
    const int i = corner_of(t, a);
    if (triangles_[t].v[(i + 1) % 3] == b) return Side{t, (i + 2) % 3};
    t = triangles_[t].next[(i + 1) % 3];
  } while (t != start);
  return std::nullopt;
}

void GridTriangulation::fix(Side side) {
  Triangle& x = triangles_[side.triangle];
  x.fixed[side.corner] = true;
  Triangle& y = triangles_[x.next[side.corner]];
  for (int j = 0; j < 3; ++j) {
    if (y.next[j] == side.triangle) y.fixed[j] = true;
  }
}

bool GridTriangulation::is_convex(Side side) const {
  const Triangle& x = triangles_[side.triangle];
  const Triangle& y = triangles_[x.next[side.corner]];
  int j = 0;
  while (y.next[j] != side.triangle) ++j;
  const Index a = x.v[side.corner], b = x.v[(side.corner + 1) % 3], c = x.v[(side.corner + 2) % 3];
  return orient(a, b, y.v[j]) > 0 && orient(a, y.v[j], c) > 0;
}

/// Edges that the segment a → b passes through, from a on, each as (right end, left end).
std::optional<GridConflict> GridTriangulation::crossed_edges(
    Index a, Index b, std::vector<std::array<Index, 2>>& crossed) const {
  using Kind = GridConflict::Kind;
  const GridPoint ab{points_[b].x - points_[a].x, points_[b].y - points_[a].y};
  Index t = triangle_of_[a];
  int i = 0;
  while (true) {  // ends: the triangles around a fill the full turn
    i = corner_of(t, a);
    const Index p = triangles_[t].v[(i + 1) % 3], q = triangles_[t].v[(i + 2) % 3];
    const std::int64_t side_p = orient(a, b, p), side_q = orient(a, b, q);
    const GridPoint ap{points_[p].x - points_[a].x, points_[p].y - points_[a].y};
    if (side_p == 0 && ap.x * ab.x + ap.y * ab.y > 0) return GridConflict{Kind::kTouch, p, a};
    if (side_p < 0 && side_q > 0) break;
    t = triangles_[t].next[(i + 1) % 3];
  }
  while (true) {
    const Triangle& triangle = triangles_[t];
    const Index right = triangle.v[(i + 1) % 3], left = triangle.v[(i + 2) % 3];
    if (triangle.fixed[i]) return GridConflict{Kind::kCross, a, right};
    crossed.push_back({right, left});
    const Index u = triangle.next[i];
    int j = 0;
    while (triangles_[u].next[j] != t) ++j;
    const Index d = triangles_[u].v[j];
    if (d == b) return std::nullopt;
    const std::int64_t side = orient(a, b, d);
    if (side == 0) return GridConflict{Kind::kTouch, d, a};
    // d replaces the end on its side; i becomes the corner opposite the edge that is left through.
    i = corner_of(u, side > 0 ? left : right);
    t = u;
  }
}

std::optional<GridConflict> GridTriangulation::lay(Index a, Index b) {
  std::optional<Side> side = find_edge(a, b);
  if (!side) {
    std::vector<std::array<Index, 2>> crossed;
    if (auto conflict = crossed_edges(a, b, crossed)) return conflict;
    std::deque<std::array<Index, 2>> open(crossed.begin(), crossed.end());
    while (!open.empty()) {
      const auto [right, left] = open.front();
      open.pop_front();
      const Side s = *find_edge(right, left);
      if (!is_convex(s)) {
        open.push_back({right, left});
        continue;
      }
      const Index p = triangles_[s.triangle].v[s.corner];
      flip(s.triangle, s.corner);
      const Index q = triangles_[s.triangle].v[2];  // the edge is now p – q
      if (p == a || p == b || q == a || q == b) continue;
      const std::int64_t side_p = orient(a, b, p), side_q = orient(a, b, q);
      if ((side_p < 0) != (side_q < 0)) open.push_back(side_p < 0 ? std::array{p, q} : std::array{q, p});
    }
    suspects_.clear();
    side = find_edge(a, b);
    TOILE_CHECK(side);
  }
  fix(*side);
  return std::nullopt;
}

/// After mark_inside, which would stop at them.
std::optional<GridConflict> GridTriangulation::lay_links(std::span<const std::array<Index, 2>> links) {
  for (const auto& [a, b] : links) {
    if (auto conflict = lay(a, b)) return conflict;
    for (const std::optional<Side>& side : {find_edge(a, b), find_edge(b, a)}) {
      if (!triangles_[side->triangle].inside) return GridConflict{GridConflict::Kind::kOutside, a, b};
    }
  }
  return std::nullopt;
}

/// Floods from the left of the constraints. Must reach neither their right nor the frame.
std::optional<GridConflict> GridTriangulation::mark_inside(
    std::span<const std::array<Index, 2>> constraints) {
  std::vector<Index> queue;
  const auto reach = [&](Index t) {
    if (t == kNone || triangles_[t].inside) return;
    triangles_[t].inside = true;
    queue.push_back(t);
  };
  for (const auto& [a, b] : constraints) reach(find_edge(a, b)->triangle);
  while (!queue.empty()) {
    const Index t = queue.back();
    queue.pop_back();
    for (int i = 0; i < 3; ++i) {
      if (!triangles_[t].fixed[i]) reach(triangles_[t].next[i]);
    }
  }
  for (const Triangle& t : triangles_) {
    if (t.inside && std::max({t.v[0], t.v[1], t.v[2]}) >= count_) {
      return GridConflict{GridConflict::Kind::kNotClosed, constraints[0][0], constraints[0][1]};
    }
  }
  for (const auto& [a, b] : constraints) {
    const Side right = *find_edge(b, a);
    if (triangles_[right.triangle].inside) return GridConflict{GridConflict::Kind::kNotClosed, a, b};
  }
  return std::nullopt;
}

bool GridTriangulation::move(Index v, const GridPoint& to) {
  bool valid = to.x >= 0 && to.y >= 0 && to.x <= kGridExtent && to.y <= kGridExtent;
  for_star(v, [&](Index b, Index c) { valid = valid && orientation(to, points_[b], points_[c]) > 0; });
  if (valid) points_[v] = to;
  return valid;
}

std::vector<Tri> GridTriangulation::inside_triangles() const {
  std::vector<Tri> inside;
  inside.reserve(triangles_.size());
  for (const Triangle& t : triangles_) {
    if (t.inside) inside.push_back(t.v);
  }
  return inside;
}

}  // namespace toile::mesh
