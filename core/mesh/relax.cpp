#include "core/mesh/relax.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/mesh/topology.h"

namespace toile::mesh {
namespace {

constexpr double kGrading = 0.35;      ///< growth of edge length per unit of way from a fine border
constexpr double kLongest = 1.5;       ///< in wanted lengths: longer edges are split
constexpr double kLongestChord = 1.3;  ///< the same for edges that join two border vertices
constexpr double kShortest = 0.55;     ///< in wanted lengths: shorter edges lose an end
constexpr double kClearance = 0.48;    ///< in wanted lengths: new points stay that far from the border

double distance(const GridPoint& a, const GridPoint& b) {
  return length(Vec2{double(a.x - b.x), double(a.y - b.y)});
}

}  // namespace

std::vector<double> wanted_lengths(std::span<const GridPoint> points, std::span<const Tri> triangles,
                                   std::span<const std::array<Index, 2>> segments, Index border,
                                   double spacing) {
  std::vector<double> wanted(points.size(), spacing);
  std::vector<double> own(border, 0.0);
  std::vector<int> count(border, 0);
  for (const auto& [a, b] : segments) {
    const double whole = distance(points[a], points[b]);
    own[a] += whole;
    ++count[a];
    own[b] += whole;
    ++count[b];
  }
  bool graded = false;
  for (Index v = 0; v < border; ++v) {
    wanted[v] = std::min(spacing, own[v] / std::max(1, count[v]));
    graded = graded || wanted[v] < 0.8 * spacing;
  }
  while (graded) {  // shortest ways on the mesh; few rounds, as lengths soon reach `spacing`
    graded = false;
    for (const Tri& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        const double step = kGrading * distance(points[a], points[b]);
        if (wanted[a] + step < wanted[b]) {
          wanted[b] = wanted[a] + step;
          graded = true;
        }
        if (wanted[b] + step < wanted[a]) {
          wanted[a] = wanted[b] + step;
          graded = true;
        }
      }
    }
  }
  return wanted;
}

void smooth(GridTriangulation& mesh, Index border, Index count, std::span<const double> wanted) {
  for (Index v = border; v < count; ++v) {
    const GridPoint& p = mesh.point(v);
    Vec2 sum;
    double weights = 0;
    mesh.for_star(v, [&](Index b, Index c) {
      const GridPoint& q = mesh.point(b);
      const GridPoint& r = mesh.point(c);
      const Vec2 pq{double(q.x - p.x), double(q.y - p.y)}, pr{double(r.x - p.x), double(r.y - p.y)};
      const double size = wanted[v] + wanted[b] + wanted[c];
      const double weight = cross(pq, pr) / (size * size);
      sum = sum + (pq + pr) * (weight / 3);
      weights += weight;
    });
    if (!(weights > 0)) continue;
    mesh.move(v, {p.x + std::llround(sum.x / weights), p.y + std::llround(sum.y / weights)});
  }
  mesh.restore_delaunay();
}

namespace {

struct Change {
  double excess;  ///< how far from the wanted length; the worst edges go first
  Index edge;
};

/// Edges whose length asks for a change, worst first.
std::vector<Change> changes(std::span<const GridPoint> points, std::span<const MeshEdge> edges, Index border,
                            std::span<const double> wanted) {
  std::vector<Change> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b, t0, t1, o0, o1] = edges[i];
    if (t1 == kNone) continue;
    const double ratio = distance(points[a], points[b]) / (0.5 * (wanted[a] + wanted[b]));
    const bool chord = a < border && b < border;
    if (ratio > (chord ? kLongestChord : kLongest)) found.push_back({ratio, static_cast<Index>(i)});
    if (ratio < kShortest && !chord) found.push_back({1 / ratio, static_cast<Index>(i)});
  }
  std::sort(found.begin(), found.end(), [](const Change& x, const Change& y) {
    return std::tie(y.excess, x.edge) < std::tie(x.excess, y.edge);
  });
  return found;
}

/// True when p keeps its distance from the border edges of the triangles at the edge's two corners.
bool is_clear(const GridPoint& p, const MeshEdge& e, std::span<const GridPoint> points,
              std::span<const std::vector<Index>> border_next, double clearance) {
  for (const Index v : {e.v0, e.v1, e.opposite0, e.opposite1}) {
    if (v >= static_cast<Index>(border_next.size())) continue;
    for (const Index w : border_next[v]) {
      const Vec2 d{double(points[w].x - points[v].x), double(points[w].y - points[v].y)};
      const Vec2 r{double(p.x - points[v].x), double(p.y - points[v].y)};
      const double t = std::clamp(dot(r, d) / std::max(1.0, dot(d, d)), 0.0, 1.0);
      if (length(r - d * t) < clearance) return false;
    }
  }
  return true;
}

/// The border vertices before and after each; more where a line meets the border.
std::vector<std::vector<Index>> border_neighbours(std::span<const std::array<Index, 2>> segments,
                                                  Index border) {
  std::vector<std::vector<Index>> next(border);
  for (const auto& [a, b] : segments) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  return next;
}

}  // namespace

std::optional<std::vector<GridPoint>> adapted_points(std::span<const GridPoint> points,
                                                     std::span<const Tri> triangles,
                                                     std::span<const std::array<Index, 2>> segments,
                                                     Index border, std::span<const double> wanted) {
  const std::vector<MeshEdge> edges = edges_of(triangles, static_cast<Index>(points.size()));
  const std::vector<std::vector<Index>> border_next = border_neighbours(segments, border);
  std::vector<bool> touched(points.size(), false), removed(points.size(), false);
  std::vector<GridPoint> added;
  bool any_removed = false;
  for (const Change& change : changes(points, edges, border, wanted)) {
    const MeshEdge& e = edges[change.edge];
    const double size = 0.5 * (wanted[e.v0] + wanted[e.v1]);
    const bool split = distance(points[e.v0], points[e.v1]) > size;
    // Inner vertices change once a round; border vertices may see several splits.
    const auto busy = [&](Index v) { return touched[v] && v >= border; };
    if (busy(e.v0) || busy(e.v1) || touched[e.opposite0] || touched[e.opposite1]) continue;
    if (split) {
      const GridPoint p{(points[e.v0].x + points[e.v1].x) / 2, (points[e.v0].y + points[e.v1].y) / 2};
      if (!is_clear(p, e, points, border_next, kClearance * size)) continue;
      added.push_back(p);
    } else {
      const Index gone = std::max(e.v0, e.v1);
      removed[gone] = any_removed = true;
    }
    for (const Index v : {e.v0, e.v1, e.opposite0, e.opposite1}) touched[v] = true;
  }
  if (added.empty() && !any_removed) return std::nullopt;
  std::vector<GridPoint> inner;
  for (std::size_t v = border; v < points.size(); ++v) {
    if (!removed[v]) inner.push_back(points[v]);
  }
  inner.insert(inner.end(), added.begin(), added.end());
  return inner;
}

}  // namespace toile::mesh
