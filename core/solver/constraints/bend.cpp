#include "core/solver/constraints/bend.h"

#include <algorithm>

#include "core/mesh/topology.h"
#include "core/solver/one_pass.h"

namespace toile::solver::constraints {

namespace {

/// Heights under this fraction of the edge are slivers; the jump over them is not trusted further.
constexpr double kLeastHeight = 0.05;

/// A point relative to an edge: its foot as a fraction of the edge, and its height over it (m, positive).
struct EdgeFrame {
  double foot = 0, height = 0;
};

EdgeFrame frame_of(Vec2 from, Vec2 to, Vec2 p) {
  const Vec2 e = to - from;
  const double l2 = dot(e, e), l = std::sqrt(l2);
  return {dot(p - from, e) / l2, std::max(std::abs(cross(e, p - from)) / l, kLeastHeight * l)};
}

int corner_of(const Tri& t, Index v) { return t[0] == v ? 0 : t[1] == v ? 1 : 2; }

/// What a hinge adds to its triangle: the weights of its jump, and its jumps under unit curvatures.
struct Hinge {
  double own[3] = {};
  double far = 0;
  double jump[3] = {};  ///< of ½u², ½v², uv
};

/// `far_frame` is the neighbour's vertex in its own flat piece; unfolded here, across a seam as well.
Hinge make_hinge(const RestTriangle& rest, int k, EdgeFrame far_frame) {
  const Vec2 a = rest[k], b = rest[(k + 1) % 3], c = rest[(k + 2) % 3];
  const EdgeFrame near = frame_of(a, b, c);
  Hinge hinge;
  hinge.far = 1 / far_frame.height;
  hinge.own[(k + 2) % 3] = 1 / near.height;
  hinge.own[k] = -((1 - near.foot) / near.height + (1 - far_frame.foot) / far_frame.height);
  hinge.own[(k + 1) % 3] = -(near.foot / near.height + far_frame.foot / far_frame.height);

  // Curvature does not depend on the origin; taking it at a keeps numbers small.
  const Vec2 e = b - a, outward = normalized(Vec2{e.y, -e.x}) * (cross(e, c - a) > 0 ? 1.0 : -1.0);
  const Vec2 d = e * far_frame.foot + outward * far_frame.height;
  const auto monomials = [](Vec2 p) { return Vec3{0.5 * p.x * p.x, 0.5 * p.y * p.y, p.x * p.y}; };
  const Vec3 jump = monomials(d) * hinge.far + monomials(c - a) * hinge.own[(k + 2) % 3] +
                    monomials(e) * hinge.own[(k + 1) % 3];
  hinge.jump[0] = jump.x;
  hinge.jump[1] = jump.y;
  hinge.jump[2] = jump.z;
  return hinge;
}

void set_hinge(BendTriangle& t, int k, const Hinge& hinge, Index far_vertex) {
  std::copy(hinge.own, hinge.own + 3, t.own[k]);
  t.far[k] = hinge.far;
  t.v[3 + k] = far_vertex;
}

/// (00, 11, 22, 01, 02, 12) as row and column.
constexpr int kRow[6] = {0, 1, 2, 0, 0, 1};
constexpr int kColumn[6] = {0, 1, 2, 1, 2, 2};

void set_compliance(BendTriangle& t, const double (&jumps)[3][3], const BendMatrix& d, double area) {
  for (int e = 0; e < 6; ++e) {
    const double* p = jumps[kRow[e]];
    const double* q = jumps[kColumn[e]];
    t.compliance[e] = (p[0] * q[0] / d.weft + p[1] * q[1] / d.warp + p[2] * q[2] / d.twist) / area;
  }
}

/// Inverse of a symmetric 3×3 matrix in the same six entries; a row of zeros stays one (a free edge).
void invert_symmetric(const double (&m)[6], const bool (&present)[3], double (&out)[6]) {
  double a[6];
  for (int e = 0; e < 6; ++e) a[e] = m[e];
  for (int k = 0; k < 3; ++k) {
    if (!present[k]) a[k] = 1;  // decouples the missing hinge
  }
  const double c00 = a[1] * a[2] - a[5] * a[5], c01 = a[4] * a[5] - a[3] * a[2],
               c02 = a[3] * a[5] - a[4] * a[1];
  const double det = a[0] * c00 + a[3] * c01 + a[4] * c02;
  const double inverse[6] = {c00, a[0] * a[2] - a[4] * a[4], a[0] * a[1] - a[3] * a[3], c01,
                             c02, a[3] * a[4] - a[0] * a[5]};
  for (int e = 0; e < 6; ++e) {
    out[e] = present[kRow[e]] && present[kColumn[e]] ? inverse[e] / det : 0;
  }
}

/// The jumps' inverse masses G W Gᵀ. Far vertices differ as a rule; where two coincide (a cone's tip),
/// leaving out their product only damps.
void set_mobility(const BendTriangle& t, std::span<const double> w, double (&mobility)[6]) {
  for (int e = 0; e < 6; ++e) {
    const int k = kRow[e], m = kColumn[e];
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += w[t.v[i]] * t.own[k][i] * t.own[m][i];
    if (k == m && t.v[3 + k] != kNone) sum += w[t.v[3 + k]] * t.far[k] * t.far[k];
    mobility[e] = sum;
  }
}

/// Stands for a hardness that numbers cannot tell.
constexpr double kHard = 1e9;

/// Hinges of narrow triangles are soft one way and hard the other; the hard one decides (one_pass.h), else it
/// would overshoot twofold and shake for ever. That is the largest eigenvalue of A = soft⁻¹·mobility, taken
/// from above as the eighth root of trace(A⁸).
double hardness_of(const double (&soft)[6], const double (&mobility)[6], const bool (&present)[3]) {
  constexpr int kEntry[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  double inverse[6];
  invert_symmetric(soft, present, inverse);
  const auto times = [](const auto& p, const auto& q, double(&out)[3][3]) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) out[i][j] = p(i, 0) * q(0, j) + p(i, 1) * q(1, j) + p(i, 2) * q(2, j);
    }
  };
  const auto symmetric = [&](const double(&m)[6]) { return [&](int i, int j) { return m[kEntry[i][j]]; }; };
  const auto square = [](const double(&m)[3][3]) { return [&](int i, int j) { return m[i][j]; }; };
  double ratio[3][3], ratio2[3][3], ratio4[3][3], ratio8[3][3];
  times(symmetric(inverse), symmetric(mobility), ratio);
  times(square(ratio), square(ratio), ratio2);
  times(square(ratio2), square(ratio2), ratio4);
  times(square(ratio4), square(ratio4), ratio8);
  const double trace = ratio8[0][0] + ratio8[1][1] + ratio8[2][2];
  const bool sound =
      inverse[0] >= 0 && inverse[1] >= 0 && inverse[2] >= 0 && trace > 0 && std::isfinite(trace);
  return sound ? std::sqrt(std::sqrt(std::sqrt(trace))) : kHard;
}

void prepare(BendTriangle& t, std::span<const double> w, double per_h2) {
  double mobility[6], system[6];
  bool present[3];
  set_mobility(t, w, mobility);
  for (int k = 0; k < 3; ++k) present[k] = t.v[3 + k] != kNone;
  double soft[6];
  for (int e = 0; e < 6; ++e) soft[e] = t.compliance[e] * per_h2;
  t.hard = hardness_of(soft, mobility, present);
  const double share = one_pass_share(1, t.hard);
  t.hard *= share;
  for (int e = 0; e < 6; ++e) system[e] = t.compliance[e] * per_h2 + share * mobility[e];
  invert_symmetric(system, present, t.response);
}

int hinges_of(const BendTriangle& t) { return (t.v[3] != kNone) + (t.v[4] != kNone) + (t.v[5] != kNone); }

/// The area that each triangle's curvature speaks for. Two hinges cannot tell a border triangle's curvature;
/// where its neighbours have all three of theirs, they speak for it, and its hinges are in their jumps
/// already.
std::vector<double> shared_areas(const ClothModel& model, const std::vector<BendTriangle>& all,
                                 const std::vector<std::array<Index, 3>>& neighbours) {
  std::vector<double> area(all.size(), 0);
  for (std::size_t t = 0; t < all.size(); ++t) {
    const double own = rest_area(model.rest[t]);
    const int hinges = hinges_of(all[t]);
    bool handed_on = hinges == 1 || hinges == 2;
    for (const Index n : neighbours[t]) handed_on &= n == kNone || hinges_of(all[n]) == 3;
    if (!handed_on) {
      area[t] += own;
      continue;
    }
    for (const Index n : neighbours[t]) {
      if (n != kNone) area[n] += own / hinges;
    }
  }
  return area;
}

}  // namespace

BendMatrix bend_matrix(const material::Fabric& fabric) {
  const double twist = 4 * fabric.bend_bias - fabric.bend_warp - fabric.bend_weft;
  return {fabric.bend_weft, fabric.bend_warp,
          std::max(twist, 0.1 * std::min(fabric.bend_warp, fabric.bend_weft))};
}

std::vector<BendTriangle> make_bending(const ClothModel& model) {
  struct Jumps {
    double of[3][3] = {};
  };
  std::vector<BendTriangle> all(model.triangles.size());
  std::vector<Jumps> jumps(model.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t) std::copy_n(model.triangles[t].begin(), 3, all[t].v);

  std::vector<std::array<Index, 3>> neighbours(all.size(), {kNone, kNone, kNone});
  for (const mesh::MeshEdge& edge : mesh::edges_of(model.triangles, model.vertex_count())) {
    if (edge.t0 == kNone || edge.t1 == kNone) continue;
    for (const auto& [self, other] : {std::pair{edge.t0, edge.t1}, std::pair{edge.t1, edge.t0}}) {
      const Tri& mine = model.triangles[self];
      const Tri& theirs = model.triangles[other];
      int k = corner_of(mine, edge.v0);
      if (mine[(k + 1) % 3] != edge.v1) k = corner_of(mine, edge.v1);
      const int from = corner_of(theirs, mine[k]), to = corner_of(theirs, mine[(k + 1) % 3]);
      const int far = 3 - from - to;
      const RestTriangle& rest = model.rest[other];
      const Hinge hinge = make_hinge(model.rest[self], k, frame_of(rest[from], rest[to], rest[far]));
      set_hinge(all[self], k, hinge, theirs[far]);
      neighbours[self][k] = other;
      std::copy(hinge.jump, hinge.jump + 3, jumps[self].of[k]);
    }
  }

  const std::vector<double> area = shared_areas(model, all, neighbours);
  std::vector<BendTriangle> out;
  out.reserve(all.size());
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (hinges_of(all[t]) == 0 || area[t] == 0) continue;
    set_compliance(all[t], jumps[t].of, bend_matrix(model.fabrics[model.fabric_of_triangle[t]]), area[t]);
    out.push_back(all[t]);
  }
  return out;
}

void prepare_bending(std::span<BendTriangle> triangles, std::span<const double> w, double h) {
  for (BendTriangle& t : triangles) prepare(t, w, 1 / (h * h));
}

}  // namespace toile::solver::constraints
