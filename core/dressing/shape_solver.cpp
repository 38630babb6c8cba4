#include "core/dressing/shape_solver.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "core/mesh/topology.h"

namespace toile::dressing {

namespace {

constexpr double kFarthest = 0.02;   // m that a vertex goes in one pass
constexpr int kSteps = 4;            // in which it goes there, close to the figure
constexpr double kLeastArea = 1e-9;  // m²

Vec3 any_across(Vec3 d) {
  return normalized(std::abs(d.x) < 0.9 * length(d) ? cross(d, {1, 0, 0}) : cross(d, {0, 1, 0}));
}

/// The matrix nearest to F (two columns) whose stretches lie between `least` and `most`.
std::array<Vec3, 2> within(const std::array<Vec3, 2>& f, double least, double most) {
  const double a = dot(f[0], f[0]), b = dot(f[0], f[1]), c = dot(f[1], f[1]);
  const double mean = 0.5 * (a + c), spread = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  const double s0 = std::sqrt(std::max(0.0, mean + spread)), s1 = std::sqrt(std::max(0.0, mean - spread));
  if (s0 <= most && s1 >= least) return f;
  // Principal directions in the flat: the eigenvectors of FᵀF.
  double u = b, v = mean + spread - a;
  if (std::sqrt(u * u + v * v) < 1e-12 * (a + c) || (u == 0 && v == 0)) {
    u = a >= c ? 1 : 0;
    v = a >= c ? 0 : 1;
  }
  const double norm = std::sqrt(u * u + v * v);
  u /= norm;
  v /= norm;
  const Vec3 long_way = f[0] * u + f[1] * v, short_way = f[1] * u - f[0] * v;
  const Vec3 e0 = s0 > 1e-9 ? long_way * (1 / s0) : Vec3{1, 0, 0};
  const Vec3 e1 = s1 > 1e-6 ? short_way * (1 / s1) : any_across(e0);
  const Vec3 p = e0 * std::clamp(s0, least, most), q = e1 * std::clamp(s1, least, most);
  return {p * u - q * v, p * v + q * u};
}

/// Where a way leads that goes around the figure, not through its limbs: those drawn in are hardly thicker
/// than a pass is long.
Vec3 gone(Vec3 from, Vec3 way, const SlimFigure* figure) {
  if (figure == nullptr || figure->clearance(from) > length(way)) return from + way;
  for (int i = 0; i < kSteps; ++i) from = figure->moved_out(from + way * (1.0 / kSteps), kFarthest);
  return from;
}

}  // namespace

/// A triangle's wish: F = Σ corner · slope.
struct ShapeSolver::Element {
  Tri v;
  std::array<Vec2, 3> slope;  ///< 1/m
  double area = 0;            ///< m²
};

struct ShapeSolver::System {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  Eigen::MatrixX3d wanted, solved;

  void add(Index i, Index j, double value) { entries.emplace_back(i, j, value); }
  void want(Index i, Vec3 value) {
    wanted(i, 0) += value.x;
    wanted(i, 1) += value.y;
    wanted(i, 2) += value.z;
  }
};

ShapeSolver::ShapeSolver(const ShapeMesh& mesh, std::vector<Thread> threads, const ShapeWishes& wishes)
    : mesh_(mesh), threads_(std::move(threads)), wishes_(wishes), system_(std::make_unique<System>()) {
  add_membrane();
  add_bending();
  for (const Thread& t : threads_) {
    for (const Index v : {t.a, t.b}) system_->add(v, v, wishes_.threads);
    system_->add(t.a, t.b, -wishes_.threads);
    system_->add(t.b, t.a, -wishes_.threads);
  }
  for (Index v = 0; v < mesh_.vertex_count; ++v) system_->add(v, v, wishes_.stay);
  Eigen::SparseMatrix<double> matrix(mesh_.vertex_count, mesh_.vertex_count);
  matrix.setFromTriplets(system_->entries.begin(), system_->entries.end());
  system_->entries = {};
  system_->factor.compute(matrix);
  TOILE_CHECK(system_->factor.info() == Eigen::Success);  // a sum of squares with `stay` > 0 is definite
  system_->wanted.resize(mesh_.vertex_count, 3);
}

ShapeSolver::~ShapeSolver() = default;

void ShapeSolver::add_membrane() {
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    const auto& r = mesh_.rest[i];
    const Vec2 d1 = r[1] - r[0], d2 = r[2] - r[0];
    const double twice = cross(d1, d2);
    if (!(twice > 2 * kLeastArea)) continue;
    Element e{mesh_.triangles[i], {}, 0.5 * twice};
    e.slope[1] = Vec2{d2.y, -d2.x} * (1 / twice);
    e.slope[2] = Vec2{-d1.y, d1.x} * (1 / twice);
    e.slope[0] = -(e.slope[1] + e.slope[2]);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) system_->add(e.v[a], e.v[b], e.area * dot(e.slope[a], e.slope[b]));
    elements_.push_back(e);
  }
}

/// Quadratic in the positions since the flat cloth has no curvature (Bergou et al., "A quadratic bending
/// model for inextensible surfaces", 2006).
void ShapeSolver::add_bending() {
  const auto corner = [&](Index t, Index v) {
    const Tri& tri = mesh_.triangles[t];
    return static_cast<std::size_t>(tri[0] == v ? 0 : tri[1] == v ? 1 : 2);
  };
  const auto cotangent = [&](Index t, Index v) {
    const std::size_t k = corner(t, v);
    const auto& r = mesh_.rest[t];
    const Vec2 a = r[(k + 1) % 3] - r[k], b = r[(k + 2) % 3] - r[k];
    return dot(a, b) / std::max(kLeastArea, std::abs(cross(a, b)));
  };
  const auto area = [&](Index t) {
    const auto& r = mesh_.rest[t];
    return std::max(kLeastArea, 0.5 * std::abs(cross(r[1] - r[0], r[2] - r[0])));
  };
  std::set<std::pair<Index, Index>> turned;
  for (const auto& [a, b] : mesh_.turned) turned.insert(std::minmax(a, b));
  for (const mesh::MeshEdge& e : mesh::edges_of(mesh_.triangles, mesh_.vertex_count)) {
    if (e.t1 == kNone || turned.contains(std::minmax(e.v0, e.v1))) continue;
    const double a0 = cotangent(e.t0, e.v0), a1 = cotangent(e.t0, e.v1);
    const double b0 = cotangent(e.t1, e.v0), b1 = cotangent(e.t1, e.v1);
    const std::array<Index, 4> v{e.v0, e.v1, e.opposite0, e.opposite1};
    const std::array<double, 4> k{a1 + b1, a0 + b0, -(a0 + a1), -(b0 + b1)};
    const double weight = wishes_.bending * mesh_.spacing * mesh_.spacing / (area(e.t0) + area(e.t1));
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) system_->add(v[i], v[j], weight * k[i] * k[j]);
  }
}

void ShapeSolver::wish(const std::vector<Vec3>& x, const Shrunk& shrunk) {
  system_->wanted.setZero();
  for (const Element& e : elements_) {
    std::array<Vec3, 2> f{};
    for (std::size_t k = 0; k < 3; ++k) {
      f[0] += x[e.v[k]] * e.slope[k].x;
      f[1] += x[e.v[k]] * e.slope[k].y;
    }
    const std::array<Vec3, 2> p = within(f, wishes_.least_stretch, wishes_.most_stretch);
    for (std::size_t k = 0; k < 3; ++k)
      system_->want(e.v[k], (p[0] * e.slope[k].x + p[1] * e.slope[k].y) * e.area);
  }
  for (const Thread& t : threads_) {
    const Vec3 apart = x[t.a] - x[t.b];
    const std::optional<double> length = t.late ? shrunk.late : shrunk.early;
    const Vec3 way = (length ? normalized(apart) * (t.start_length * *length) : apart) * wishes_.threads;
    system_->want(t.a, way);
    system_->want(t.b, -way);
  }
  for (Index v = 0; v < mesh_.vertex_count; ++v)
    system_->want(v, x[v] * wishes_.stay - Vec3{0, wishes_.hang, 0});
}

void ShapeSolver::pass(std::vector<Vec3>& x, const Shrunk& shrunk, const SlimFigure* figure) {
  wish(x, shrunk);
  system_->solved = system_->factor.solve(system_->wanted);
  for (Index v = 0; v < mesh_.vertex_count; ++v) {
    const Vec3 way = Vec3{system_->solved(v, 0), system_->solved(v, 1), system_->solved(v, 2)} - x[v];
    const double far = length(way);
    x[v] = gone(x[v], far > kFarthest ? way * (kFarthest / far) : way, figure);
  }
  if (figure != nullptr) keep_out(x, *figure);
}

/// Vertices, and the middles of triangles: thin limbs fit between three vertices.
void ShapeSolver::keep_out(std::vector<Vec3>& x, const SlimFigure& figure) const {
  for (Vec3& p : x) p = figure.moved_out(p, kFarthest);
  for (const Tri& t : mesh_.triangles) {
    const Vec3 middle = (x[t[0]] + x[t[1]] + x[t[2]]) * (1.0 / 3);
    const Vec3 way = figure.moved_out(middle, 0.5 * kFarthest) - middle;
    if (way == Vec3{}) continue;
    for (const Index v : t) x[v] += way;
  }
}

}  // namespace toile::dressing
