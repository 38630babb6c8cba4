#include "core/pattern/fit_cubic.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"

namespace toile::pattern {
namespace {

constexpr std::size_t kReparametrisations = 250;  // chord length starts far off where a curve bends unevenly
constexpr std::size_t kMostWork = 500'000;        // points times reparametrisations for one cubic
constexpr double kHopeless = 0.1;                 // of the run, an error that Newton does not mend
constexpr double kLeastGain = 0.9998;  // factor on the error per Newton step; above, splitting is quicker

using Points = std::span<const Vec2>;

/// The first index from i in direction `step` whose point is `far` away, or the last one in range.
std::size_t reach(Points p, std::size_t i, int step, double far) {
  std::size_t j = i;
  do {
    j += static_cast<std::size_t>(step);
  } while (j > 0 && j + 1 < p.size() && length(p[j] - p[i]) < far);
  return j;
}

/// Unit tangent at a of the parabola through a, b, c; the chord where it bends too sharply to trust.
Vec2 end_tangent(Vec2 a, Vec2 b, Vec2 c) {
  const double h0 = length(b - a), h1 = length(c - b);
  if (!(h0 > 0) || !(h1 > 0) || turn_between(b - a, c - b) > kSharpBend) return normalized(b - a);
  const Vec2 f0 = (b - a) * (1 / h0), f1 = (c - b) * (1 / h1);
  return normalized(f0 - (f1 - f0) * (h0 / (h0 + h1)));
}

}  // namespace

double turn_between(Vec2 from, Vec2 to) { return std::abs(std::atan2(cross(from, to), dot(from, to))); }

Vec2 middle_tangent(Vec2 a, Vec2 b, Vec2 c) {
  const double h0 = length(b - a), h1 = length(c - b);
  if (!(h0 > 0) || !(h1 > 0)) return normalized(c - a);
  return normalized((b - a) * (h1 / h0) + (c - b) * (h0 / h1));
}

Vec2 start_tangent(Points p) {
  const std::size_t b = reach(p, 0, 1, kTangentReach);
  return b + 1 < p.size() ? end_tangent(p[0], p[b], p[reach(p, b, 1, kTangentReach)])
                          : normalized(p[b] - p[0]);
}

Vec2 last_tangent(Points p) {
  const std::size_t n = p.size() - 1, b = reach(p, n, -1, kTangentReach);
  return b > 0 ? -end_tangent(p[n], p[b], p[reach(p, b, -1, kTangentReach)]) : normalized(p[n] - p[b]);
}

Vec2 inner_tangent(Points p, std::size_t i, double far) {
  return middle_tangent(p[reach(p, i, -1, far)], p[i], p[reach(p, i, 1, far)]);
}

namespace {

std::vector<double> chord_parameters(Points p) {
  std::vector<double> u(p.size(), 0);
  for (std::size_t i = 1; i < p.size(); ++i) u[i] = u[i - 1] + length(p[i] - p[i - 1]);
  for (double& v : u) v /= u.back();
  return u;
}

/// Two unknowns that are to agree with many points, by least squares.
struct NormalEquations {
  Eigen::Matrix2d matrix;  ///< symmetric
  Eigen::Vector2d right;

  double determinant() const { return matrix.determinant(); }
  /// Whether the two are told apart at all.
  bool is_sound() const { return std::abs(determinant()) > 1e-12 * matrix(0, 0) * matrix(1, 1); }
  /// By Cramer's rule. Eigen's inverse would multiply by 1 / det; dividing last keeps the last bit, and so
  /// the outlines of projects that were made before.
  Eigen::Vector2d solution() const {
    Eigen::Matrix2d adjugate;
    adjugate << matrix(1, 1), -matrix(0, 1), -matrix(1, 0), matrix(0, 0);
    return (adjugate * right) / determinant();
  }
};

/// For the lengths of the two handles, along the given forward tangents. Summed in plain numbers: with a
/// matrix for each point reading a drawing takes twice as long.
NormalEquations handle_equations(Points p, const std::vector<double>& u, Vec2 t0, Vec2 t1) {
  const Vec2 a = p.front(), b = p.back();
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double t = u[i], s = 1 - t;
    const double b0 = s * s * s, b1 = 3 * s * s * t, b2 = 3 * s * t * t, b3 = t * t * t;
    const Vec2 a0 = t0 * b1, a1 = -t1 * b2, rest = p[i] - (a * (b0 + b1) + b * (b2 + b3));
    c00 += dot(a0, a0);
    c01 += dot(a0, a1);
    c11 += dot(a1, a1);
    x0 += dot(a0, rest);
    x1 += dot(a1, rest);
  }
  return {Eigen::Matrix2d{{c00, c01}, {c01, c11}}, Eigen::Vector2d{x0, x1}};
}

/// Schneider's least squares: the cubic with the handle lengths that come closest to the points.
CubicBezier fit_handles(Points p, const std::vector<double>& u, Vec2 t0, Vec2 t1, double run_length) {
  const NormalEquations equations = handle_equations(p, u, t0, t1);
  Eigen::Vector2d h = equations.solution();
  // Negative, tiny or huge handles make hooks and loops; the heuristic of a third makes none.
  const auto sound = [&](double length) { return length > 1e-3 * run_length && length < run_length; };
  if (!equations.is_sound() || !sound(h[0]) || !sound(h[1])) h.setConstant(run_length / 3);
  return {p.front(), p.front() + t0 * h[0], p.back() - t1 * h[1], p.back()};
}

struct Worst {
  double distance = 0;
  std::size_t index = 0;
};

Worst worst_point(Points p, const std::vector<double>& u, const CubicBezier& c) {
  Worst worst{0, p.size() / 2};
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double d = length(evaluate(c, u[i]) - p[i]);
    if (d > worst.distance) worst = {d, i};
  }
  return worst;
}

/// One Newton step of every parameter towards the foot of its point.
void reparametrise(Points p, std::vector<double>& u, const CubicBezier& c) {
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec2 d = evaluate(c, u[i]) - p[i], d1 = derivative(c, u[i]), d2 = second_derivative(c, u[i]);
    const double slope = dot(d1, d1) + dot(d, d2);
    if (slope > 0) u[i] = std::clamp(u[i] - dot(d, d1) / slope, 0.0, 1.0);
  }
}

}  // namespace

std::optional<CubicBezier> fit_cubic(Points p, Vec2 t0, Vec2 t1, double tolerance, std::size_t& farthest) {
  const double run_length = geometry::polyline_length(p);
  std::vector<double> u = chord_parameters(p);
  Worst worst{std::numeric_limits<double>::max(), 0};
  const std::size_t rounds = std::min(kReparametrisations, 8 + kMostWork / p.size());
  for (std::size_t i = 0; i <= rounds; ++i) {
    const CubicBezier curve = fit_handles(p, u, t0, t1, run_length);
    const double before = worst.distance;
    worst = worst_point(p, u, curve);
    if (p.size() == 2 || worst.distance <= tolerance) return curve;
    if (worst.distance > std::max(tolerance, kHopeless * run_length) || worst.distance > kLeastGain * before)
      break;
    reparametrise(p, u, curve);
  }
  farthest = worst.index;
  return std::nullopt;
}

}  // namespace toile::pattern
