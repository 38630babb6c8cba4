#include "core/pattern/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/polygon2.h"

namespace toile::pattern {

CubicBezier line_segment(Vec2 a, Vec2 b) { return {a, a + (b - a) * (1.0 / 3), a + (b - a) * (2.0 / 3), b}; }

Vec2 evaluate(const CubicBezier& c, double t) {
  const double s = 1 - t;
  return c.p0 * (s * s * s) + c.p1 * (3 * s * s * t) + c.p2 * (3 * s * t * t) + c.p3 * (t * t * t);
}

Vec2 derivative(const CubicBezier& c, double t) {
  const double s = 1 - t;
  return 3 * ((c.p1 - c.p0) * (s * s) + (c.p2 - c.p1) * (2 * s * t) + (c.p3 - c.p2) * (t * t));
}

Vec2 second_derivative(const CubicBezier& c, double t) {
  return 6 * ((c.p2 - 2 * c.p1 + c.p0) * (1 - t) + (c.p3 - 2 * c.p2 + c.p1) * t);
}

namespace {

/// Speed of the curve integrated over [t0, t1] with the 8-point Gauss-Legendre rule.
double gauss_length(const CubicBezier& c, double t0, double t1) {
  struct Node {
    double x, weight;
  };
  static constexpr std::array<Node, 4> kNodes{{{0.1834346424956498, 0.3626837833783620},
                                               {0.5255324099163290, 0.3137066458778873},
                                               {0.7966664774136267, 0.2223810344533745},
                                               {0.9602898564975363, 0.1012285362903763}}};
  const double half = (t1 - t0) / 2, middle = (t0 + t1) / 2;
  double sum = 0;
  for (const Node& n : kNodes)
    sum +=
        n.weight * (length(derivative(c, middle - half * n.x)) + length(derivative(c, middle + half * n.x)));
  return sum * half;
}

/// Halves [t0, t1] until the two halves agree with the whole. The depth bounds the work at cusps.
double refined_length(const CubicBezier& c, double t0, double t1, double whole, double tolerance, int depth) {
  const double middle = (t0 + t1) / 2;
  const double a = gauss_length(c, t0, middle), b = gauss_length(c, middle, t1);
  if (depth == 0 || !(std::abs(a + b - whole) > tolerance)) return a + b;
  return refined_length(c, t0, middle, a, tolerance / 2, depth - 1) +
         refined_length(c, middle, t1, b, tolerance / 2, depth - 1);
}

double polygon_length(const CubicBezier& c) {
  return length(c.p1 - c.p0) + length(c.p2 - c.p1) + length(c.p3 - c.p2);
}

}  // namespace

double arc_length(const CubicBezier& c, double t0, double t1) {
  return refined_length(c, t0, t1, gauss_length(c, t0, t1), 1e-10 * polygon_length(c), 16);
}

double arc_length(const PanelEdge& edge) {
  double sum = 0;
  for (const CubicBezier& c : edge.curves) sum += arc_length(c);
  return sum;
}

double parameter_at_length(const CubicBezier& c, double s) {
  return parameter_at_length(c, s, arc_length(c));
}

double parameter_at_length(const CubicBezier& c, double s, double whole) {
  if (!(s > 0)) return 0;
  if (s >= whole) return 1;
  // Newton on the length, kept between bounds that bisect where the speed vanishes.
  double low = 0, high = 1, t = s / whole;
  for (int i = 0; i < 60; ++i) {
    const double error = arc_length(c, 0, t) - s;
    if (std::abs(error) <= 1e-10 * whole) break;
    (error > 0 ? high : low) = t;
    const double speed = length(derivative(c, t));
    const double newton = speed > 0 ? t - error / speed : low;
    t = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return t;
}

Vec2 point_at_length(const PanelEdge& edge, double s) {
  for (const CubicBezier& c : edge.curves) {
    const double l = arc_length(c);
    if (s <= l) return evaluate(c, parameter_at_length(c, s, l));
    s -= l;
  }
  return edge.curves.back().p3;
}

std::pair<CubicBezier, CubicBezier> split(const CubicBezier& c, double t) {
  const auto mix = [t](Vec2 a, Vec2 b) { return a + (b - a) * t; };
  const Vec2 a = mix(c.p0, c.p1), b = mix(c.p1, c.p2), d = mix(c.p2, c.p3);
  const Vec2 ab = mix(a, b), bd = mix(b, d), middle = mix(ab, bd);
  return {{c.p0, a, ab, middle}, {middle, bd, d, c.p3}};
}

CubicBezier reversed(const CubicBezier& c) { return {c.p3, c.p2, c.p1, c.p0}; }

PanelEdge reversed(const PanelEdge& edge) {
  PanelEdge result{edge.id, {}};
  for (auto c = edge.curves.rbegin(); c != edge.curves.rend(); ++c) result.curves.push_back(reversed(*c));
  return result;
}

Loop reversed(const Loop& loop) {
  Loop result;
  const std::size_t n = loop.edges.size();
  for (std::size_t i = 0; i < n; ++i) result.edges.push_back(reversed(loop.edges[(n - i) % n]));
  return result;
}

bool is_straight(const CubicBezier& c, double tolerance_mm) {
  const Vec2 chord = c.p3 - c.p0;
  const double along1 = dot(c.p1 - c.p0, chord), along2 = dot(c.p2 - c.p0, chord), end = dot(chord, chord);
  if (!(end > 0) || along1 < 0 || along2 < along1 || end < along2) return false;
  return geometry::distance_to_segment(c.p1, c.p0, c.p3) <= tolerance_mm &&
         geometry::distance_to_segment(c.p2, c.p0, c.p3) <= tolerance_mm;
}

std::size_t flat_steps(const CubicBezier& c, double tolerance_mm) {
  constexpr double kMostSteps = 4096;
  if (is_straight(c)) return 1;
  // A chord over a step h leaves the curve by at most h²/8 · |c''|, and |c''| <= 6 · bend.
  const double bend = std::max(length(c.p0 - 2 * c.p1 + c.p2), length(c.p1 - 2 * c.p2 + c.p3));
  const double steps = std::ceil(std::sqrt(0.75 * bend / tolerance_mm));
  return std::isfinite(steps) ? static_cast<std::size_t>(std::clamp(steps, 1.0, kMostSteps)) : 1;
}

namespace {

/// Appends the points after the curve's start.
void append_flat(const CubicBezier& c, double tolerance_mm, std::vector<Vec2>& points) {
  const std::size_t steps = flat_steps(c, tolerance_mm);
  for (std::size_t i = 1; i < steps; ++i) points.push_back(evaluate(c, double(i) / double(steps)));
  points.push_back(c.p3);
}

}  // namespace

std::vector<Vec2> flatten(const CubicBezier& curve, double tolerance_mm) {
  std::vector<Vec2> points{curve.p0};
  append_flat(curve, tolerance_mm, points);
  return points;
}

std::vector<Vec2> flatten(const PanelEdge& edge, double tolerance_mm) {
  std::vector<Vec2> points;
  if (!edge.curves.empty()) points.push_back(edge.curves.front().p0);
  for (const CubicBezier& c : edge.curves) append_flat(c, tolerance_mm, points);
  return points;
}

std::vector<Vec2> flatten(const Loop& loop, double tolerance_mm) {
  // Every point but the closing one, which is the first point again.
  std::vector<Vec2> points;
  for (const PanelEdge& edge : loop.edges) {
    for (const CubicBezier& c : edge.curves) {
      if (points.empty()) points.push_back(c.p0);
      append_flat(c, tolerance_mm, points);
    }
  }
  if (!points.empty()) points.pop_back();
  return points;
}

double signed_area(const Loop& loop) {
  // ½∮ cross(p, dp) over a cubic, relative to the loop's first point.
  if (loop.edges.empty() || loop.edges.front().curves.empty()) return 0;
  const Vec2 o = loop.edges.front().curves.front().p0;
  double sum = 0;
  for (const PanelEdge& edge : loop.edges) {
    for (const CubicBezier& c : edge.curves) {
      const Vec2 a = c.p0 - o, b = c.p1 - o, d = c.p2 - o, e = c.p3 - o;
      sum += (6 * cross(a, b) + 3 * cross(a, d) + cross(a, e) + 3 * cross(b, d) + 3 * cross(b, e) +
              6 * cross(d, e)) /
             20;
    }
  }
  return sum;
}

}  // namespace toile::pattern
