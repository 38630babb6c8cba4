#include "core/dressing/untangle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/crew.h"

namespace toile::dressing {

namespace {

constexpr double kStep = 0.08;     // of the mean edge, by which a crossing moves in a pass
constexpr double kMost = 0.25;     // of the mean edge, that a vertex moves in a pass
constexpr double kSteepest = 3;    // where an edge runs nearly along the face that it crosses
constexpr double kToMean = 0.3;    // of the way to the neighbours' mean
constexpr int kPatience = 40;      // passes in which a tangle must become smaller,
constexpr double kProgress = 0.9;  // to this share at most, or it is left
constexpr double kOut = 1.5e-3;    // m, that what crosses the body moves outwards in a pass

/// The neighbours of each vertex, once for each triangle that they share.
std::vector<std::vector<Index>> neighbours_of(const collision::Surface& cloth) {
  std::vector<std::vector<Index>> around(static_cast<std::size_t>(cloth.vertex_count()));
  for (const Tri& t : cloth.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      around[t[k]].push_back(t[(k + 1) % 3]);
      around[t[k]].push_back(t[(k + 2) % 3]);
    }
  }
  return around;
}

class Untangler {
 public:
  Untangler(const collision::Surface& cloth, double spacing, std::vector<Vec3>& x)
      : cloth_(cloth), around_(neighbours_of(cloth)), counter_(cloth), spacing_(spacing), x_(x) {}

  Tangle look(const collision::CrossingBody& body) {
    Crew alone;  // few triangles move from look to look
    counter_.place(x_);
    with_itself_ = counter_.with_itself(std::move(with_itself_), alone);
    with_body_ = counter_.with(body, std::move(with_body_), alone);
    return {static_cast<int>(with_body_.size()), static_cast<int>(with_itself_.size())};
  }

  void pass(const SlimFigure& figure) {
    way_.assign(x_.size(), {});
    std::set<Index> tangled;
    for (const auto& [a, b] : with_itself_) {
      part(cloth_.triangles[a], cloth_.triangles[b]);
      part(cloth_.triangles[b], cloth_.triangles[a]);
      for (const Index t : {a, b}) tangled.insert(cloth_.triangles[t].begin(), cloth_.triangles[t].end());
    }
    for (std::size_t v = 0; v < x_.size(); ++v) {
      const double far = length(way_[v]), most = kMost * spacing_;
      x_[v] += far > most ? way_[v] * (most / far) : way_[v];
    }
    std::set<Index> pierced;
    for (const auto& pair : with_body_)
      pierced.insert(cloth_.triangles[pair[0]].begin(), cloth_.triangles[pair[0]].end());
    tangled.insert(pierced.begin(), pierced.end());
    smooth(tangled);
    for (const Index v : tangled) x_[v] = figure.moved_out(x_[v], kMost * spacing_);
    for (const Index v : pierced) x_[v] += figure.field->outwards(x_[v], figure.slim) * kOut;
    lift_off(figure);
  }

 private:
  /// Moves the edges of `a` that go through `b`, and `b` against them, so that the line of crossing becomes
  /// shorter at that end.
  void part(const Tri& a, const Tri& b) {
    const Vec3 b0 = x_[b[0]], b1 = x_[b[1]], b2 = x_[b[2]];
    const Vec3 n = normalized(cross(b1 - b0, b2 - b0));
    const Vec3 na = cross(x_[a[1]] - x_[a[0]], x_[a[2]] - x_[a[0]]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v0 = a[k], v1 = a[(k + 1) % 3], opposite = a[(k + 2) % 3];
      const Vec3 p = x_[v0], q = x_[v1];
      if (!collision::segment_crosses_triangle(collision::to_grid(p), collision::to_grid(q),
                                               collision::to_grid(b0), collision::to_grid(b1),
                                               collision::to_grid(b2)))
        continue;
      const double hp = dot(p - b0, n), hq = dot(q - b0, n);
      if (!(std::abs(hp - hq) > 1e-12)) continue;
      const double t = hp / (hp - hq);
      const Vec3 at = p + (q - p) * t;
      const Vec3 e = normalized(q - p);
      Vec3 into = normalized(cross(na, n));  // along the line of crossing, into a
      Vec3 inwards = cross(na, e);
      if (dot(inwards, x_[opposite] - p) < 0) inwards = -inwards;
      if (dot(into, inwards) < 0) into = -into;
      Vec3 g = into - n * (dot(into, e) / dot(e, n));
      if (const double steep = length(g); steep > kSteepest) g = g * (kSteepest / steep);
      const Vec3 way = g * (kStep * spacing_);
      way_[v0] += way * (1 - t);
      way_[v1] += way * t;
      const double area = dot(cross(b1 - b0, b2 - b0), n);
      const double w0 = dot(cross(b1 - at, b2 - at), n) / area, w1 = dot(cross(b2 - at, b0 - at), n) / area;
      way_[b[0]] -= way * w0;
      way_[b[1]] -= way * w1;
      way_[b[2]] -= way * (1 - w0 - w1);
    }
  }

  /// What spans a shoulder has its corners off the skin before and behind it, and its middle within: it goes
  /// out as a whole, where its middle does.
  void lift_off(const SlimFigure& figure) {
    std::map<Index, Vec3> ways;  // the longest at each vertex
    for (const auto& pair : with_body_) {
      const Tri& t = cloth_.triangles[pair[0]];
      const Vec3 a = x_[t[0]], b = x_[t[1]], c = x_[t[2]];
      Vec3 deepest = (a + b + c) * (1.0 / 3);
      double distance = figure.field->distance(deepest, figure.slim);
      for (const Vec3 p : {(a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5}) {
        const double here = figure.field->distance(p, figure.slim);
        if (here < distance) deepest = p;
        distance = std::min(distance, here);
      }
      if (distance >= 0) continue;
      const Vec3 way =
          figure.field->outwards(deepest, figure.slim) * std::min(kOut - distance, kMost * spacing_);
      for (const Index v : t) {
        Vec3& longest = ways[v];
        if (length(way) > length(longest)) longest = way;
      }
    }
    for (const auto& [v, way] : ways) x_[v] += way;
  }

  void smooth(const std::set<Index>& vertices) {
    std::vector<Vec3> moved;
    moved.reserve(vertices.size());
    for (const Index v : vertices) {
      Vec3 mean;
      for (const Index w : around_[v]) mean += x_[w];
      mean = around_[v].empty() ? x_[v] : mean * (1.0 / static_cast<double>(around_[v].size()));
      moved.push_back(x_[v] + (mean - x_[v]) * kToMean);
    }
    std::size_t i = 0;
    for (const Index v : vertices) x_[v] = moved[i++];
  }

  const collision::Surface& cloth_;
  std::vector<std::vector<Index>> around_;
  collision::CrossingCounter counter_;
  double spacing_;
  std::vector<Vec3>& x_;
  std::vector<Vec3> way_;
  collision::CrossingPairs with_itself_, with_body_;
};

}  // namespace

Untangled untangle(const collision::Surface& cloth, const SlimFigure& figure,
                   const collision::CrossingBody& body, double spacing, int passes, std::vector<Vec3>& x,
                   AxisGuard* guard) {
  Untangler untangler(cloth, spacing, x);
  Tangle left = untangler.look(body);
  int before = left.cloth_body + left.cloth_cloth;
  int taken = 0;
  for (int i = 0; i < passes && !left.none(); ++i) {
    ++taken;
    const std::vector<Vec3> were = x;
    untangler.pass(figure);
    if (guard) guard->keep(were, x);
    left = untangler.look(body);
    if ((i + 1) % kPatience != 0) continue;
    const int now = left.cloth_body + left.cloth_cloth;
    if (now > kProgress * before) break;
    before = now;
  }
  return {left, taken};
}

}  // namespace toile::dressing
