#include "core/solver/constraints/fold.h"

#include <algorithm>

#include "core/solver/one_pass.h"

namespace toile::solver::constraints {

namespace {

/// More than this counts as this: the way is long, and a linear step must not be.
constexpr double kMostDifference = 4;  // 180°

/// A hinge as it stands: normals of both triangles (twice their areas long) and the edge.
struct Shape {
  Vec3 edge, left, right;
  double length_edge, length_left, length_right;
  bool proper() const { return length_edge > 0 && length_left > 0 && length_right > 0; }
};

Shape shape_of(const FoldHinge& f, std::span<const Vec3> x) {
  Shape s;
  s.edge = x[f.e1] - x[f.e0];
  s.left = cross(s.edge, x[f.left] - x[f.e0]);
  s.right = cross(x[f.right] - x[f.e0], s.edge);
  s.length_edge = length(s.edge);
  s.length_left = length(s.left);
  s.length_right = length(s.right);
  return s;
}

/// tan(δ/4) = sin(δ/2) / (1 + cos(δ/2)); δ/2 is the half angle less the half rest angle.
double quarter_tangent(const FoldHinge& f, const Shape& s, double pressed) {
  const double areas = s.length_left * s.length_right;
  const double cosine = std::clamp(dot(s.left, s.right) / areas, -1.0, 1.0);
  const double sign = dot(cross(s.left, s.right), s.edge) < 0 ? -1 : 1;
  const double half_sine = sign * std::sqrt(0.5 * (1 - cosine)), half_cosine = std::sqrt(0.5 * (1 + cosine));
  if (f.turned) pressed = 1;
  // The rest angle on its way: between flat (1, 0) and its own direction, which are at most 90° apart.
  const Vec2 rest = normalized(Vec2{1 + (f.half_cosine - 1) * pressed, f.half_sine * pressed});
  const double sine = half_sine * rest.x - half_cosine * rest.y;
  const double one_more = 1 + half_cosine * rest.x + half_sine * rest.y;
  return one_more > 1e-6 ? sine / one_more : (sine < 0 ? -1e6 : 1e6);
}

}  // namespace

double fold_difference(const FoldHinge& hinge, double pressed, std::span<const Vec3> x) {
  const Shape s = shape_of(hinge, x);
  return s.proper() ? 4 * quarter_tangent(hinge, s, pressed) : 0;
}

void solve_folds(std::span<const FoldHinge> hinges, double pressed, std::span<const double> w, double h,
                 std::span<Vec3> x) {
  for (const FoldHinge& f : hinges) {
    const Shape s = shape_of(f, x);
    if (!s.proper()) continue;
    const double raw = 4 * quarter_tangent(f, s, pressed);
    const double difference = std::clamp(raw, -kMostDifference, kMostDifference);
    // How the angle answers to its vertices: raising a wing lessens it, by one over the wing's height.
    const Vec3 on_left = s.left * (-s.length_edge / (s.length_left * s.length_left));
    const Vec3 on_right = s.right * (-s.length_edge / (s.length_right * s.length_right));
    const double along_left = dot(x[f.left] - x[f.e0], s.edge) / dot(s.edge, s.edge);
    const double along_right = dot(x[f.right] - x[f.e0], s.edge) / dot(s.edge, s.edge);
    const Vec3 on_e1 = -(on_left * along_left + on_right * along_right);
    const Vec3 on_e0 = -(on_left + on_right + on_e1);
    const double free = w[f.e0] * dot(on_e0, on_e0) + w[f.e1] * dot(on_e1, on_e1) +
                        w[f.left] * dot(on_left, on_left) + w[f.right] * dot(on_right, on_right);
    if (!(free > 0)) continue;
    const double slope = 1 + difference * difference / 16;  // of 4 tan(δ/4)
    const double soft = 1 / (f.stiffness * h * h), mobility = free * slope * slope;
    const double lambda = -difference * slope / (soft + one_pass_share(soft, mobility) * mobility);
    x[f.e0] += on_e0 * (lambda * w[f.e0]);
    x[f.e1] += on_e1 * (lambda * w[f.e1]);
    x[f.left] += on_left * (lambda * w[f.left]);
    x[f.right] += on_right * (lambda * w[f.right]);
  }
}

}  // namespace toile::solver::constraints
