#include "core/pattern/dxf_chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf_groups.h"

namespace toile {
namespace {

constexpr double kLongestChord = 5;                         // mm
constexpr double kWidestChord = radians_from_degrees(7.5);  // of an arc: 35° corners stay far off
constexpr double kFlatArc = 1e-4;                           // mm of height: drawn as its chord
constexpr double kSplineChord = 2;                          // mm of a spline's control polygon per chord
constexpr double kFewestSplineChords = 8, kMostSplineChords = 500;  // per knot span
constexpr int kMostAtOnePlace = 64;                                 // ends looked through around a joint

/// Chords that draw an arc; at most a million, which any limit on vertices refuses.
std::size_t arc_steps(double radius, double sweep, double tolerance) {
  double step = kWidestChord;
  if (radius > tolerance) step = std::min(step, 2 * std::acos(1 - tolerance / radius));
  if (radius > 0) step = std::min(step, kLongestChord / radius);
  return static_cast<std::size_t>(std::clamp(std::ceil(std::abs(sweep) / step), 1.0, 1e6));
}

/// Draws curves into points, mm, within the limit on their number.
class Pen {
 public:
  Pen(const DxfSettings& settings, double mm_per_unit, std::size_t& drawn)
      : settings_(settings), unit_(mm_per_unit), drawn_(drawn) {}

  /// The points of the curve before any transform, or an error.
  Result<std::vector<Vec2>> draw(const DxfCurve& c) {
    std::vector<Vec2> points;
    bool room = true;
    switch (c.kind) {
      case DxfCurve::Kind::polyline:
        room = polyline(c, points);
        break;
      case DxfCurve::Kind::arc:
        room = arc(c, points);
        break;
      case DxfCurve::Kind::spline:
        room = spline(c, points);
        break;
    }
    if (room) return points;
    return Error{"dxf.too_large",
                 "With its arcs and splines drawn out the drawing has more than " +
                     std::to_string(settings_.max_vertices) + " vertices, the limit.",
                 line_text(c.line)};
  }

 private:
  bool take(std::size_t n) { return (drawn_ += n) <= settings_.max_vertices; }

  bool polyline(const DxfCurve& c, std::vector<Vec2>& points) {
    const std::size_t n = c.vertices.size();
    if (!take(n + 1)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      points.push_back(c.vertices[i].at * unit_);
      const bool last = i + 1 == n;
      if (c.vertices[i].bulge == 0 || (last && !c.closed)) continue;
      if (!bulge(points.back(), c.vertices[(i + 1) % n].at * unit_, c.vertices[i].bulge, points))
        return false;
    }
    return true;
  }

  /// The inner points of the arc from a to b. Its bulge is the tangent of a quarter of its angle.
  bool bulge(Vec2 a, Vec2 b, double bulge, std::vector<Vec2>& points) {
    const double chord = length(b - a), sweep = 4 * std::atan(bulge);
    if (chord * std::abs(bulge) / 2 < kFlatArc) return true;
    const double radius = chord / (2 * std::abs(std::sin(sweep / 2)));
    const std::size_t steps = arc_steps(radius, sweep, settings_.arc_tolerance_mm);
    if (!take(steps)) return false;
    // The centre stands on the chord's bisector, to its left for an arc under a half turn that bulges right.
    const Vec2 centre = (a + b) * 0.5 + perpendicular(b - a) * ((1 - bulge * bulge) / (4 * bulge));
    const Vec2 from = a - centre;
    for (std::size_t i = 1; i < steps; ++i) {
      const double angle = sweep * double(i) / double(steps);
      points.push_back(centre + from * std::cos(angle) + perpendicular(from) * std::sin(angle));
    }
    return true;
  }

  bool arc(const DxfCurve& c, std::vector<Vec2>& points) {
    double degrees = c.closed ? 360 : std::fmod(c.end - c.start, 360.0);
    if (degrees <= 0) degrees += 360;
    const double sweep = radians_from_degrees(degrees),
                 first = radians_from_degrees(std::fmod(c.start, 360.0));
    const double radius = c.radius * unit_;
    const std::size_t steps = arc_steps(radius, sweep, settings_.arc_tolerance_mm);
    if (!take(steps + 1)) return false;
    const Vec2 centre = c.vertices[0].at * unit_;
    for (std::size_t i = 0; i < steps + (c.closed ? 0 : 1); ++i) {
      const double angle = first + sweep * double(i) / double(steps);
      points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return true;
  }

  bool spline(const DxfCurve& c, std::vector<Vec2>& points) {
    const auto p = std::size_t(c.degree);
    for (std::size_t span = p; span < c.vertices.size(); ++span) {
      const double u0 = c.knots[span], u1 = c.knots[span + 1];
      if (!(u1 > u0)) continue;
      double control = 0;
      for (std::size_t i = span - p; i < span; ++i)
        control += length(c.vertices[i + 1].at - c.vertices[i].at) * unit_;
      const double steps =
          std::clamp(std::ceil(control / kSplineChord), kFewestSplineChords, kMostSplineChords);
      if (!take(std::size_t(steps) + 1)) return false;
      for (double i = points.empty() ? 0 : 1; i <= steps; ++i)
        points.push_back(spline_point(c, span, u0 + (u1 - u0) * (i / steps)) * unit_);
    }
    return true;
  }

  /// De Boor's algorithm in homogeneous coordinates, u in the given knot span.
  static Vec2 spline_point(const DxfCurve& c, std::size_t span, double u) {
    const auto p = std::size_t(c.degree);
    std::vector<Vec3> d(p + 1);
    for (std::size_t j = 0; j <= p; ++j) {
      const std::size_t i = span - p + j;
      const double w = c.weights.empty() ? 1 : c.weights[i];
      d[j] = {c.vertices[i].at.x * w, c.vertices[i].at.y * w, w};
    }
    for (std::size_t r = 1; r <= p; ++r) {
      for (std::size_t j = p; j >= r; --j) {
        const double low = c.knots[span - p + j], high = c.knots[span + 1 + j - r];
        const double t = high > low ? (u - low) / (high - low) : 0;
        d[j] = (1 - t) * d[j - 1] + t * d[j];
      }
    }
    return {d[p].x / d[p].z, d[p].y / d[p].z};
  }

  const DxfSettings& settings_;
  double unit_;
  std::size_t& drawn_;
};

/// One drawn curve that is still open.
struct Piece {
  std::vector<Vec2> points;
  int line = 0;
  Vec2 end(bool last) const { return last ? points.back() : points.front(); }
};

/// The open curves of one layer, joined at their ends.
class Chainer {
 public:
  Chainer(std::vector<Piece> pieces, double tolerance)
      : pieces_(std::move(pieces)), tolerance_(std::max(tolerance, 1e-6)) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      ends_.insert(entry(i, false));
      ends_.insert(entry(i, true));
    }
  }

  std::vector<DxfChain> run(const std::string& layer) {
    std::vector<DxfChain> chains;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (ends_.contains(entry(i, false))) chains.push_back(chain_from(i, layer));
    return chains;
  }

 private:
  struct Link {
    std::size_t piece = 0;
    bool reversed = false;
  };
  using Entry = std::tuple<std::int64_t, std::int64_t, std::size_t, bool>;  // cell, piece, which end

  std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / tolerance_)); }
  Entry entry(std::size_t i, bool last) const {
    const Vec2 p = pieces_[i].end(last);
    return {cell(p.x), cell(p.y), i, last};
  }

  void use(std::size_t i) {
    ends_.erase(entry(i, false));
    ends_.erase(entry(i, true));
  }

  /// The nearest unused end within tolerance, as the piece to append there.
  std::optional<Link> next_at(Vec2 p) const {
    std::optional<Link> best;
    double nearest = tolerance_;
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const std::int64_t cx = cell(p.x) + dx, cy = cell(p.y) + dy;
        int seen = 0;
        for (auto it = ends_.lower_bound(Entry{cx, cy, 0, false});
             it != ends_.end() && seen < kMostAtOnePlace; ++it, ++seen) {
          const auto& [x, y, i, last] = *it;
          if (x != cx || y != cy) break;
          const double d = length(pieces_[i].end(last) - p);
          if (d < nearest || (d == nearest && (!best || i < best->piece))) nearest = d, best = Link{i, last};
        }
      }
    }
    return best;
  }

  Vec2 end_of(const Link& link) const { return pieces_[link.piece].end(!link.reversed); }
  Vec2 start_of(const Link& link) const { return pieces_[link.piece].end(link.reversed); }

  DxfChain chain_from(std::size_t first, const std::string& layer) {
    std::vector<Link> links{{first, false}};
    use(first);
    double total = polyline_length(pieces_[first].points);
    const auto closed = [&] {
      return total > 2 * tolerance_ && length(end_of(links.back()) - start_of(links.front())) <= tolerance_;
    };
    const auto extend = [&](Vec2 at, std::vector<Link>& to) {
      const std::optional<Link> next = next_at(at);
      if (!next) return false;
      to.push_back(*next);
      use(next->piece);
      total += polyline_length(pieces_[next->piece].points);
      return true;
    };
    while (!closed() && extend(end_of(links.back()), links)) {
    }
    if (!closed()) {  // the other way from the start; those links run backwards
      std::vector<Link> before;
      while (extend(before.empty() ? start_of(links.front()) : end_of(before.back()), before)) {
      }
      for (Link& link : before) link.reversed = !link.reversed;
      links.insert(links.begin(), before.rbegin(), before.rend());
    }
    return joined(links, closed(), layer);
  }

  DxfChain joined(const std::vector<Link>& links, bool closed, const std::string& layer) const {
    DxfChain chain;
    chain.closed = closed, chain.layer = layer, chain.line = pieces_[links[0].piece].line;
    for (const Link& link : links) {
      std::vector<Vec2> points = pieces_[link.piece].points;
      if (link.reversed) std::reverse(points.begin(), points.end());
      chain.line = std::min(chain.line, pieces_[link.piece].line);
      const bool first = chain.points.empty();
      if (links.size() > 1 && (closed || !first))
        chain.breaks.push_back(first ? points[0] : chain.points.back());
      chain.points.insert(chain.points.end(), points.begin() + (first ? 0 : 1), points.end());
    }
    if (closed) chain.points.pop_back();
    return chain;
  }

  std::vector<Piece> pieces_;
  double tolerance_;
  std::set<Entry> ends_;  // of unused pieces
};

bool within(Vec2 p, double limit) { return std::abs(p.x) <= limit && std::abs(p.y) <= limit; }

}  // namespace

DxfTransform transform_of(const DxfInsert& insert, const DxfBlock& block) {
  const double angle = radians_from_degrees(std::fmod(insert.rotation, 360.0));
  // A quarter turn is exact, as pieces are often laid out so.
  const double c = std::fmod(insert.rotation, 180.0) == 90 || std::fmod(insert.rotation, 180.0) == -90
                       ? 0
                       : std::cos(angle);
  const double s = std::fmod(insert.rotation, 180.0) == 0 ? 0 : std::sin(angle);
  DxfTransform t{Vec2{c, s} * insert.scale.x, Vec2{-s, c} * insert.scale.y, insert.at};
  t.origin = insert.at - (block.base.x * t.x + block.base.y * t.y);
  if (insert.mirrored) t.x.x = -t.x.x, t.y.x = -t.y.x, t.origin.x = -t.origin.x;
  return t;
}

Result<std::vector<DxfChain>> chains_of(const DxfBlock& block, const DxfTransform& transform,
                                        double mm_per_unit, const DxfSettings& settings, std::size_t& drawn) {
  Pen pen(settings, mm_per_unit, drawn);
  DxfTransform to_mm = transform;
  to_mm.origin = transform.origin * mm_per_unit;
  std::vector<DxfChain> chains;
  std::map<std::string, std::vector<Piece>> open;
  for (const DxfCurve& curve : block.curves) {
    Result<std::vector<Vec2>> points = pen.draw(curve);
    if (!points) return points.error();
    for (Vec2& p : *points) {
      if (curve.mirrored) p.x = -p.x;
      p = to_mm(p);
      if (!is_finite(p) || !within(p, settings.max_coordinate_mm))
        return Error{"dxf.coordinate_range", "The line leads beyond any pattern.", line_text(curve.line)};
    }
    if (curve.closed && points->size() > 1)
      chains.push_back({std::move(*points), true, curve.layer, curve.line, {}});
    else if (points->size() > 1 && polyline_length(*points) > 0)
      open[curve.layer].push_back({std::move(*points), curve.line});
  }
  for (auto& [layer, pieces] : open)
    for (DxfChain& chain : Chainer(std::move(pieces), settings.chain_tolerance_mm).run(layer))
      chains.push_back(std::move(chain));
  std::stable_sort(chains.begin(), chains.end(),
                   [](const DxfChain& a, const DxfChain& b) { return a.line < b.line; });
  return chains;
}

}  // namespace toile
