#include "core/solver/constraints/membrane.h"

#include <algorithm>

#include "core/solver/one_pass.h"

namespace toile {

namespace {

/// A symmetric 3×3 system by Cramer's rule; m = (00, 11, 22, 01, 02, 12), positive definite.
Vec3 solve_symmetric(const double (&m)[6], Vec3 r) {
  const double c00 = m[1] * m[2] - m[5] * m[5], c01 = m[4] * m[5] - m[3] * m[2],
               c02 = m[3] * m[5] - m[4] * m[1];
  const double c11 = m[0] * m[2] - m[4] * m[4], c12 = m[3] * m[4] - m[0] * m[5],
               c22 = m[0] * m[1] - m[3] * m[3];
  const double inverse = 1 / (m[0] * c00 + m[3] * c01 + m[4] * c02);
  return Vec3{c00 * r.x + c01 * r.y + c02 * r.z, c01 * r.x + c11 * r.y + c12 * r.z,
              c02 * r.x + c12 * r.y + c22 * r.z} *
         inverse;
}

MembraneTriangle make_triangle(const Tri& v, const RestTriangle& rest, const Fabric& f) {
  const Vec2 e1 = rest[1] - rest[0], e2 = rest[2] - rest[0];
  const double det = cross(e1, e2), area = 0.5 * std::abs(det);
  const double k = f.stretch_weft * f.stretch_warp - f.stretch_coupling * f.stretch_coupling;
  return {v,
          {e2.y / det, -e1.y / det, -e2.x / det, e1.x / det},
          {f.stretch_warp / (k * area), f.stretch_weft / (k * area), -f.stretch_coupling / (k * area),
           1 / (f.stretch_shear * area)}};
}

void solve_triangle(const MembraneTriangle& t, std::span<const double> w, double per_h2, std::span<Vec3> x) {
  const Index i0 = t.v[0], i1 = t.v[1], i2 = t.v[2];
  const double w0 = w[i0], w1 = w[i1], w2 = w[i2], share = t.share;
  const Vec3 e1 = x[i1] - x[i0], e2 = x[i2] - x[i0];
  const Vec3 fu = e1 * t.b[0] + e2 * t.b[1], fv = e1 * t.b[2] + e2 * t.b[3];
  const double lu = length(fu), lv = length(fv);
  if (!(lu > 1e-6) || !(lv > 1e-6)) return;  // collapsed to a line: no direction to push in
  const Vec3 nu = fu * (1 / lu), nv = fv * (1 / lv);

  // Gradients: with respect to corner 1, corner 2, and minus their sum for corner 0.
  const double b0 = t.b[0], b1 = t.b[1], b2 = t.b[2], b3 = t.b[3], s0 = b0 + b1, s1 = b2 + b3;
  const Vec3 shear1 = fv * b0 + fu * b2, shear2 = fv * b1 + fu * b3, shear0 = shear1 + shear2;
  const double uv = dot(nu, nv);
  const double mass_uu = w0 * s0 * s0 + w1 * b0 * b0 + w2 * b1 * b1;
  const double mass_vv = w0 * s1 * s1 + w1 * b2 * b2 + w2 * b3 * b3;
  const double mass_uv = (w0 * s0 * s1 + w1 * b0 * b2 + w2 * b1 * b3) * uv;
  const Vec3 along_u = shear0 * (w0 * s0) + shear1 * (w1 * b0) + shear2 * (w2 * b1);
  const Vec3 along_v = shear0 * (w0 * s1) + shear1 * (w1 * b2) + shear2 * (w2 * b3);
  const double mass_ss = w0 * dot(shear0, shear0) + w1 * dot(shear1, shear1) + w2 * dot(shear2, shear2);
  const double system[6] = {share * mass_uu + t.compliance[0] * per_h2,
                            share * mass_vv + t.compliance[1] * per_h2,
                            share * mass_ss + t.compliance[3] * per_h2,
                            share * mass_uv + t.compliance[2] * per_h2,
                            share * dot(along_u, nu),
                            share * dot(along_v, nv)};
  const Vec3 lambda = solve_symmetric(system, {1 - lu, 1 - lv, -dot(fu, fv)});

  const Vec3 pu = nu * lambda.x, pv = nv * lambda.y;
  Vec3 d1 = pu * b0 + pv * b2 + shear1 * lambda.z, d2 = pu * b1 + pv * b3 + shear2 * lambda.z;
  // However far the cloth is out of shape, no corner moves by more than its triangle's least height: beyond
  // that the linear guess points nowhere, and narrow triangles flew apart.
  const double steep = std::max({b0 * b0 + b2 * b2, b1 * b1 + b3 * b3, s0 * s0 + s1 * s1});
  const double way =
      steep * std::max({dot(d1, d1) * w1 * w1, dot(d2, d2) * w2 * w2, dot(d1 + d2, d1 + d2) * w0 * w0});
  if (way > 1) d1 = d1 * (1 / std::sqrt(way)), d2 = d2 * (1 / std::sqrt(way));
  x[i0] -= (d1 + d2) * w0;
  x[i1] += d1 * w1;
  x[i2] += d2 * w2;
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
    const double stretch = w0 * (s0 * s0 + s1 * s1) + w1 * (b0 * b0 + b2 * b2) + w2 * (b1 * b1 + b3 * b3);
    // In an undeformed triangle shear is as mobile as warp and weft together.
    t.share = one_pass_share((t.compliance[0] + t.compliance[1] + t.compliance[3]) / (h * h), 2 * stretch);
  }
}

void solve_membrane(std::span<const MembraneTriangle> triangles, std::span<const double> w, double h,
                    std::span<Vec3> x) {
  const double per_h2 = 1 / (h * h);
  for (const MembraneTriangle& t : triangles) solve_triangle(t, w, per_h2, x);
}

Vec3 membrane_strain(const MembraneTriangle& t, std::span<const Vec3> x) {
  const Vec3 e1 = x[t.v[1]] - x[t.v[0]], e2 = x[t.v[2]] - x[t.v[0]];
  const Vec3 fu = e1 * t.b[0] + e2 * t.b[1], fv = e1 * t.b[2] + e2 * t.b[3];
  const double lu = length(fu), lv = length(fv);
  return {lu - 1, lv - 1, lu > 0 && lv > 0 ? dot(fu, fv) / (lu * lv) : 0};
}

}  // namespace toile
