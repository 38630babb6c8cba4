#include "core/body/tape.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/disjoint_sets.h"

namespace toile {
namespace {

constexpr double kScanStep = 0.004;      // m
constexpr double kWiderThanRibs = 1.12;  // a chest's breadth over that of the ribs below it, at most

// A slice as points with the number of the connected part each belongs to.
struct Slice {
  std::vector<Vec2> points;  ///< (x, z)
  std::vector<Index> part;
};

Vec2 on_edge(const Vec3& a, const Vec3& b, double height) {
  const double s = (height - a.y) / (b.y - a.y);
  return {a.x + (b.x - a.x) * s, a.z + (b.z - a.z) * s};
}

Slice slice(const TriangleMesh& mesh, double height) {
  Slice out;
  DisjointSets parts;
  std::map<std::pair<Index, Index>, Index> point_of_edge;
  for (const Tri& t : mesh.triangles) {
    Index ends[2] = {kNone, kNone};
    int found = 0;
    for (int c = 0; c < 3 && found < 2; ++c) {
      const Index a = std::min(t[c], t[(c + 1) % 3]), b = std::max(t[c], t[(c + 1) % 3]);
      const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
      if ((p.y < height) == (q.y < height)) continue;
      const auto [it, is_new] = point_of_edge.try_emplace({a, b}, static_cast<Index>(out.points.size()));
      if (is_new) {
        out.points.push_back(on_edge(p, q, height));
        parts.add();
      }
      ends[found++] = it->second;
    }
    if (found == 2) parts.join(ends[0], ends[1]);
  }
  for (Index i = 0; i < static_cast<Index>(out.points.size()); ++i) out.part.push_back(parts.root(i));
  return out;
}

struct Span {
  double low = HUGE_VAL, high = -HUGE_VAL;
};

// The parts that cross the mid-plane, or else the nearest on each side.
std::vector<bool> middle_parts(const Slice& s) {
  std::vector<Span> spans(s.points.size());
  for (size_t i = 0; i < s.points.size(); ++i) {
    Span& span = spans[s.part[i]];
    span.low = std::min(span.low, s.points[i].x), span.high = std::max(span.high, s.points[i].x);
  }
  std::vector<bool> chosen(spans.size(), false);
  bool any = false;
  Index left = kNone, right = kNone;
  for (Index i = 0; i < static_cast<Index>(spans.size()); ++i) {
    if (spans[i].low > spans[i].high) continue;
    if (spans[i].low <= 0 && spans[i].high >= 0) chosen[i] = any = true;
    if (spans[i].low > 0 && (left == kNone || spans[i].low < spans[left].low)) left = i;
    if (spans[i].high < 0 && (right == kNone || spans[i].high > spans[right].high)) right = i;
  }
  for (Index i : {left, right})
    if (!any && i != kNone) chosen[i] = true;
  return chosen;
}

std::vector<Vec2> middle_points(const TriangleMesh& mesh, double height) {
  const Slice s = slice(mesh, height);
  const std::vector<bool> chosen = middle_parts(s);
  std::vector<Vec2> points;
  for (size_t i = 0; i < s.points.size(); ++i)
    if (chosen[s.part[i]]) points.push_back(s.points[i]);
  return points;
}

// The part of a convex polygon on which side·x <= limit. Cut, not dropped: a girth must not jump as a point
// passes the limit.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, double limit, double side) {
  std::vector<Vec2> out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double da = side * a.x - limit, db = side * b.x - limit;
    if (da <= 0) out.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) out.push_back(a + (b - a) * (da / (da - db)));
  }
  return out;
}

double perimeter(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) sum += length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return sum;
}

template <typename Better>
Girth best_girth(const TriangleMesh& mesh, double low, double high, double half_breadth, Better better) {
  Girth best{low, girth_at(mesh, low, half_breadth)};
  const int steps = static_cast<int>(std::ceil((high - low) / kScanStep));
  for (int i = 1; i <= steps; ++i) {
    const double y = low + (high - low) * i / steps;
    const double g = girth_at(mesh, y, half_breadth);
    if (better(g, best.girth)) best = {y, g};
  }
  return best;
}

}  // namespace

std::vector<Vec2> tape_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  std::vector<Vec2> out;
  for (int pass = 0; pass < 2; ++pass) {  // lower chain, then upper
    const size_t base = out.size() + 1;
    for (const Vec2& p : points) {
      while (out.size() > base && cross(out.back() - out[out.size() - 2], p - out.back()) <= 0)
        out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

double hull_perimeter(std::vector<Vec2> points) { return perimeter(tape_hull(std::move(points))); }

double girth_at(const TriangleMesh& mesh, double height, double half_breadth) {
  std::vector<Vec2> around = tape_hull(middle_points(mesh, height));
  if (half_breadth < kNoBreadth) around = clipped(clipped(around, half_breadth, 1), half_breadth, -1);
  return perimeter(around);
}

double half_breadth_at(const TriangleMesh& mesh, double height) {
  double most = 0;
  for (const Vec2& p : middle_points(mesh, height)) most = std::max(most, std::abs(p.x));
  return most;
}

Girth narrowest_girth(const TriangleMesh& mesh, double low, double high, double half_breadth) {
  return best_girth(mesh, low, high, half_breadth, [](double a, double b) { return a < b; });
}

Girth widest_girth(const TriangleMesh& mesh, double low, double high, double half_breadth) {
  return best_girth(mesh, low, high, half_breadth, [](double a, double b) { return a > b; });
}

TrunkGirths trunk_girths(const TriangleMesh& standing) {
  double h = 0;
  for (const Vec3& p : standing.vertices) h = std::max(h, p.y);
  const double ribs = kWiderThanRibs * half_breadth_at(standing, 0.68 * h);
  return {widest_girth(standing, 0.70 * h, 0.72 * h, ribs), narrowest_girth(standing, 0.58 * h, 0.68 * h),
          widest_girth(standing, 0.48 * h, 0.56 * h)};
}

}  // namespace toile
