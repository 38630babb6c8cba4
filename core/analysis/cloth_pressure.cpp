#include "core/analysis/cloth_pressure.h"

#include <algorithm>
#include <cmath>

namespace toile::analysis {
namespace {

double within(double strain, double limit) { return limit > 0 ? std::clamp(strain, -limit, limit) : strain; }

}  // namespace

SymmetricTensor cloth_tension(const material::Fabric& fabric, ThreadStrain strain, Vec3 warp, Vec3 weft) {
  const double e1 = within(strain.warp, fabric.limit_warp), e2 = within(strain.weft, fabric.limit_weft);
  const double along = fabric.stretch_warp * e1 + fabric.stretch_coupling * e2;
  const double across = fabric.stretch_coupling * e1 + fabric.stretch_weft * e2;
  const double sheared = fabric.stretch_shear * within(strain.shear, fabric.limit_shear);
  // Principal tensions of [[along, sheared], [sheared, across]].
  const double mean = 0.5 * (along + across), half = 0.5 * (along - across);
  const double radius = std::hypot(half, sheared);
  const double angle = 0.5 * std::atan2(sheared, half);
  const Vec3 first = warp * std::cos(angle) + weft * std::sin(angle);
  const Vec3 second = weft * std::cos(angle) - warp * std::sin(angle);
  SymmetricTensor out;
  out.add(std::max(0.0, mean + radius), first, first);
  out.add(std::max(0.0, mean - radius), second, second);
  return out;
}

double laplace_pressure(const SymmetricTensor& tension, const SymmetricTensor& curvature) {
  return std::max(0.0, contracted(tension, curvature));
}

}  // namespace toile::analysis
