#include "core/solver/constraints/membrane.h"

#include <algorithm>

#include "core/solver/one_pass.h"

namespace toile::solver::constraints {

namespace {

/// What is left of a direction's compliance beyond the fabric's limit, where one pass a step can do that
/// much.
constexpr double kBeyondLimit = 0.01;
/// A limit that is as hard as one pass can make it puts this share of its mobility into the system: with less
/// it would ring (one_pass.h).
constexpr double kLimitShare = 1;

/// π²B/l² times the area √3/4 l² of an equilateral triangle, over B: the same for all sizes.
constexpr double kBuckling = 4.2736;

MembraneTriangle make_triangle(const Tri& v, const RestTriangle& rest, const material::Fabric& f) {
  const Vec2 e1 = rest[1] - rest[0], e2 = rest[2] - rest[0];
  const double det = cross(e1, e2), area = 0.5 * std::abs(det);
  const double k = f.stretch_weft * f.stretch_warp - f.stretch_coupling * f.stretch_coupling;
  return {v,
          {e2.y / det, -e1.y / det, -e2.x / det, e1.x / det},
          {f.stretch_warp / (k * area), f.stretch_weft / (k * area), -f.stretch_coupling / (k * area),
           1 / (f.stretch_shear * area)},
          kBuckling * 0.5 * (f.bend_warp + f.bend_weft),
          {f.limit_weft, f.limit_warp, f.limit_shear}};
}

}  // namespace

std::vector<MembraneTriangle> make_membrane(const ClothModel& model) {
  std::vector<MembraneTriangle> out;
  out.reserve(model.triangles.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    out.push_back(
        make_triangle(model.triangles[t], model.rest[t], model.fabrics[model.fabric_of_triangle[t]]));
  }
  return out;
}

void prepare_membrane(std::span<MembraneTriangle> triangles, std::span<const double> w, double h) {
  for (MembraneTriangle& t : triangles) {
    const double w0 = w[t.v[0]], w1 = w[t.v[1]], w2 = w[t.v[2]];
    const double b0 = t.b[0], b1 = t.b[1], b2 = t.b[2], b3 = t.b[3], s0 = b0 + b1, s1 = b2 + b3;
    const double uu = w0 * s0 * s0 + w1 * b0 * b0 + w2 * b1 * b1;
    const double vv = w0 * s1 * s1 + w1 * b2 * b2 + w2 * b3 * b3;
    const double free[3] = {uu, vv, uu + vv};  // in an undeformed triangle shear moves both ways
    // The hardest direction decides: were the sum of all to do so, soft shear would let a hard warp
    // overshoot.
    const double* c = t.compliance;
    const double det = c[0] * c[1] - c[2] * c[2];
    t.share = one_pass_share(1, h * h * std::max({uu * c[1] / det, vv * c[0] / det, free[2] / c[3]}));
    for (int k = 0; k < 3; ++k) {
      const double soft = c[k < 2 ? k : 3] / (h * h);
      const double left = std::max(kBeyondLimit * soft, (kLimitShare - t.share) * free[k]);
      t.stop[k] = t.limit[k] > 0 && left < soft ? (1 - left / soft) / soft : 0;
    }
  }
}

Vec3 membrane_strain(const MembraneTriangle& t, std::span<const Vec3> x) {
  const Vec3 e1 = x[t.v[1]] - x[t.v[0]], e2 = x[t.v[2]] - x[t.v[0]];
  const Vec3 fu = e1 * t.b[0] + e2 * t.b[1], fv = e1 * t.b[2] + e2 * t.b[3];
  const double lu = length(fu), lv = length(fv);
  return {lu - 1, lv - 1, lu > 0 && lv > 0 ? dot(fu, fv) / (lu * lv) : 0};
}

}  // namespace toile::solver::constraints
