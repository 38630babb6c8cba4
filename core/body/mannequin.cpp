#include "core/body/mannequin.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/body/polygonise.h"
#include "core/body/remesh.h"
#include "core/body/tape.h"
#include "core/body/trunk_solve.h"

namespace toile {
namespace {

constexpr double kSkinArea = 0.62;        // of the stature squared, near enough to choose a grid
constexpr double kFinestCell = 3.5e-3;    // of the stature; remeshing refines from there
constexpr double kCoarsestCell = 6.5e-3;  // fingertips and the gap between the legs need this
constexpr double kCellPerEdge = 0.42;
constexpr int kCorrections = 12;           // of the girths, measured on the mesh
constexpr double kGoodGirth = 0.0003;      // m, good enough to stop correcting
constexpr double kGirthTolerance = 0.005;  // m

struct Limit {
  const char* name;
  double value, low, high;
};

Status check(const MannequinSettings& s) {
  const Limit limits[] = {{"height", s.height, 1.2, 2.2},
                          {"bust", s.bust, 0.44 * s.height, 0.75 * s.height},
                          {"waist", s.waist, 0.33 * s.height, 0.70 * s.height},
                          {"hip", s.hip, 0.47 * s.height, 0.75 * s.height},
                          {"arm_angle", degrees_from_radians(s.arm_angle), 30, 60},
                          {"triangle_count", static_cast<double>(s.triangle_count), 1000, 60000}};
  for (const Limit& l : limits) {
    if (l.value >= l.low * (1 - 1e-12) && l.value <= l.high * (1 + 1e-12)) continue;  // false for NaN too
    return Error{"mannequin.setting",
                 std::string(l.name) + " is " + std::to_string(l.value) + "; it must lie between " +
                     std::to_string(l.low) + " and " + std::to_string(l.high) + ".",
                 l.name};
  }
  return {};
}

// Taylor series: rounds alike everywhere, which the library's sine does not promise. |x| < 1.1 is enough
// here.
double sine(double x) {
  double term = x, sum = x;
  for (int n = 1; n < 10; ++n) sum += term *= -x * x / ((2 * n) * (2 * n + 1));
  return sum;
}

double grid_cell(Index triangle_count) {
  const double edge = std::sqrt(kSkinArea / triangle_count * 4 / std::sqrt(3.0));
  return std::clamp(edge * kCellPerEdge, kFinestCell, kCoarsestCell);
}

RemeshSettings remesh_settings(const BodyField& field, Index triangle_count) {
  return {triangle_count, [&field](Vec3 p) { return field.fineness(p); }, 8};
}

TriangleMesh first_mesh(const BodyShape& shape, Index triangle_count) {
  const BodyField field(shape);
  const ImplicitSurface surface = [&field](Vec3 p) { return field.at(p); };
  const double breadth = field.half_breadth();
  const GridBox box{{-breadth, -0.02, -0.16}, {breadth, 1.02, 0.18}, grid_cell(triangle_count)};
  return remesh(polygonise(surface, box), surface, remesh_settings(field, triangle_count));
}

TrunkTargets measured(const TriangleMesh& unit_mesh) {
  const TrunkGirths g = trunk_girths(unit_mesh);
  return {g.bust.girth, g.waist.girth, g.hip.girth};
}

double worst_miss(const TrunkTargets& a, const TrunkTargets& b) {
  return std::max({std::abs(a.bust - b.bust), std::abs(a.waist - b.waist), std::abs(a.hip - b.hip)});
}

// The finished mesh stands on the floor and is as tall as asked; chords had cut a little off both.
TriangleMesh stand(TriangleMesh mesh, double height) {
  double low = mesh.vertices[0].y, high = low;
  for (const Vec3& p : mesh.vertices) low = std::min(low, p.y), high = std::max(high, p.y);
  for (Vec3& p : mesh.vertices) p = Vec3{p.x * height, (p.y - low) * (height / (high - low)), p.z * height};
  return mesh;
}

}  // namespace

Result<TriangleMesh> make_mannequin(const MannequinSettings& settings) {
  if (Status s = check(settings); !s) return s.error();
  const double h = settings.height;
  const TrunkTargets asked{settings.bust / h, settings.waist / h, settings.hip / h};
  BodyShape shape;
  shape.arm_sine = sine(settings.arm_angle);
  shape = solve_shape(asked, shape);

  // Chords lie inside the skin, so the mesh is a little slimmer than the field: correct by what it measures.
  TriangleMesh mesh = first_mesh(shape, settings.triangle_count);
  TrunkTargets got = measured(stand(mesh, 1));
  for (int i = 0; i < kCorrections && (i == 0 || worst_miss(got, asked) * h > kGoodGirth); ++i) {
    shape = corrected(shape, asked, got);
    const BodyField field(shape);
    const ImplicitSurface surface = [&field](Vec3 p) { return field.at(p); };
    mesh = refit(std::move(mesh), surface, remesh_settings(field, settings.triangle_count), i == 0 ? 2 : 0);
    got = measured(stand(mesh, 1));
  }
  if (const double miss = worst_miss(got, asked) * h; miss > kGirthTolerance) {
    return Error{"mannequin.girths",
                 "Bust, waist and hip do not go together: off by " + std::to_string(miss * 1000) + " mm.",
                 ""};
  }
  mesh = stand(std::move(mesh), h);
  return mesh;
}

}  // namespace toile
