#include "core/trials/cantilever.h"

#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/card.h"
#include "core/material/elastic_line.h"
#include "core/solver/cloth_solver.h"
#include "core/trials/specimen.h"

namespace toile::trials {
namespace {

constexpr double kStandardWidth = 0.025;  // m, of the standard's strip
constexpr double kRowsOfOverhang = 10;    // triangles along it
constexpr double kRows = 3;               // and before the clamp

/// Where the strip begins: as one a fifth stiffer would hang, so that it has to find its own way.
std::vector<Vec3> start_of(const Specimen& strip, double clamp, double overhang) {
  constexpr double kOwnLoad = 8, kStiffer = 1.2;  // w L³ / B is 8 for an overhang of two bending lengths
  constexpr int kSteps = 500;
  const std::vector<Vec2> line = material::elastic_line(kOwnLoad / kStiffer, kSteps);
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) {
    const double s = std::max(0.0, (p.x - clamp) / overhang);
    const Vec2 at = line[static_cast<std::size_t>(std::lround(s * static_cast<double>(line.size() - 1)))];
    x.push_back(s > 0 ? Vec3{clamp + overhang * at.x, overhang * at.y, p.y} : Vec3{p.x, 0, p.y});
  }
  return x;
}

/// Mean of the vertices at the strip's free end.
Vec3 tip_of(const Specimen& strip, const std::vector<Vec3>& x) {
  double end = 0;
  for (const Vec2& p : strip.rest) end = std::max(end, p.x);
  Vec3 sum;
  int count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (strip.rest[i].x < end - 1e-6) continue;
    sum += x[i];
    ++count;
  }
  return sum * (1.0 / count);
}

}  // namespace

double peirce_length(double overhang, double angle) {
  const double a = radians_from_degrees(angle);
  return overhang * std::cbrt(std::cos(a / 2) / (8 * std::tan(a)));
}

CantileverResult cantilever(const material::Fabric& fabric, Vec2 along, double rigidity) {
  constexpr double kPace = 45, kSeconds = 1.2, kMetres = 1e-3;  // m/s: edge over step that bending bears
  CantileverResult out;
  out.known = fabric::bending_length(rigidity, fabric.areal_mass);
  const double overhang = 2 * out.known, h = overhang / kRowsOfOverhang;
  // Cloth is clamped on vertices, so that its slope is held at the middle of the row of triangles before
  // them: the overhang counts from half a row inside the clamp.
  const double half_row = std::sqrt(3.0) / 4 * h, clamp = kRows * h;
  const double length = clamp - half_row + overhang;
  const Vec2 warp{along.y, along.x};  // the strip lies along x; its reflection changes nothing
  const Specimen strip =
      make_specimen(rectangle(length / kMetres, kStandardWidth / kMetres, warp, clamp / kMetres), h, fabric);
  std::vector<Vec3> x = start_of(strip, clamp, overhang - half_row);
  std::vector<solver::constraints::HeldVertex> held;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (strip.rest[i].x <= clamp + 1e-6) held.push_back({static_cast<Index>(i), false, x[i]});
  solver::ClothSolver solver(strip.model, std::move(x), {}, h / kPace);
  solver.set_holds(std::move(held));
  solver::StepForces forces;
  forces.damping = 12;
  run(solver, forces, kSeconds);
  const Vec3 tip = tip_of(strip, solver.positions());
  out.angle = degrees_from_radians(std::atan2(-tip.y, tip.x - (clamp - half_row)));
  out.measured = peirce_length(overhang, out.angle);
  return out;
}

}  // namespace toile::trials
