#include "core/body/mannequin/carry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/check.h"

namespace toile::mannequin {
namespace {

/// Of the arms' sine or cosine, and of a factor, from one shape on the way to the next.
constexpr double kTurn = 0.1, kGrowth = 0.1;

constexpr int kRemeshRounds = 6;

BodyShape between(const BodyShape& a, const BodyShape& b, double share) {
  BodyShape shape = b;
  for (std::size_t i = 0; i < shape.factor.size(); ++i)
    shape.factor[i] = a.factor[i] + (b.factor[i] - a.factor[i]) * share;
  shape.head = a.head + (b.head - a.head) * share;
  shape.face = a.face + (b.face - a.face) * share;
  const double sine = a.arm_sine + (b.arm_sine - a.arm_sine) * share;
  const double cosine = a.arm_cosine + (b.arm_cosine - a.arm_cosine) * share;
  const double one = std::sqrt(sine * sine + cosine * cosine);
  shape.arm_sine = sine / one;
  shape.arm_cosine = cosine / one;
  return shape;
}

int stages_between(const BodyShape& a, const BodyShape& b) {
  double most = std::max(std::abs(a.arm_sine - b.arm_sine), std::abs(a.arm_cosine - b.arm_cosine)) / kTurn;
  for (std::size_t i = 0; i < a.factor.size(); ++i)
    most = std::max(most, std::abs(a.factor[i] - b.factor[i]) / kGrowth);
  return std::max(1, static_cast<int>(std::ceil(most)));
}

}  // namespace

RemeshSettings remesh_settings(const BodyField& field, Index triangle_count) {
  const double detail = std::clamp((triangle_count - 3000) / 12000.0, 0.0, 1.0);
  return {triangle_count, [&field, detail](Vec3 p) { return field.fineness(p, detail); }, kRemeshRounds};
}

// Carried along first: what only went to the nearest skin left a web where the crotch had risen.
geometry::TriangleMesh fitted(geometry::TriangleMesh mesh, const BodyShape& before, const BodyShape& shape,
                              Index triangle_count, int relaxations) {
  const BodyField field(shape);
  const PlacedFigure from(before);
  for (Vec3& p : mesh.vertices) p = field.placed().carried_from(from, p);
  const ImplicitSurface surface = [&field](Vec3 p) { return field.at(p); };
  return refit(std::move(mesh), surface, remesh_settings(field, triangle_count), relaxations);
}

geometry::TriangleMesh stand(geometry::TriangleMesh mesh, double height) {
  const Aabb3 box = bounding_box(mesh.vertices);
  const double upright = height / box.size().y;
  for (Vec3& p : mesh.vertices) p = Vec3{p.x * height, (p.y - box.low.y) * upright, p.z * height};
  return mesh;
}

std::vector<geometry::TriangleMesh> on_the_way(geometry::TriangleMesh mesh, const Mannequin& from,
                                               const Mannequin& to) {
  TOILE_CHECK(from.shape.figure == to.shape.figure);
  const double tall = *from.wanted[measure::Measure::kHeight], then = *to.wanted[measure::Measure::kHeight];
  const auto count = static_cast<Index>(mesh.triangles.size());
  for (Vec3& p : mesh.vertices) p = p * (1 / tall);
  const int stages = stages_between(from.shape, to.shape);
  std::vector<geometry::TriangleMesh> way;
  BodyShape before = from.shape;
  for (int k = 1; k <= stages; ++k) {
    const double share = static_cast<double>(k) / stages;
    const BodyShape shape = between(from.shape, to.shape, share);
    mesh = fitted(std::move(mesh), before, shape, count, 0);
    way.push_back(stand(mesh, tall + (then - tall) * share));
    before = shape;
  }
  return way;
}

}  // namespace toile::mannequin
