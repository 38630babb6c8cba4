#include "server/app/mesh_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/fabric/card.h"
#include "core/pattern/curve.h"

namespace toile::app {
namespace {

/// m², without holes.
double area_of(const pattern::Panel& panel) {
  double area = pattern::signed_area(panel.outline);
  for (const pattern::Loop& hole : panel.holes) area -= std::abs(pattern::signed_area(hole));
  return metres_from_mm(metres_from_mm(area));
}

/// Of a lattice of equilateral triangles.
double particles_on(double area, double edge) { return area / (std::sqrt(3.0) / 2 * edge * edge); }

}  // namespace

MeshFit mesh_fit(const drape::DrapeInput& input) {
  MeshFit out;
  out.now = input.settings.particle_distance;
  out.fitting = out.now;
  for (const Index f : input.fabric_of_panel) {
    const material::Fabric& fabric = input.fabrics[static_cast<std::size_t>(f)];
    const double wanted = fabric::fitting_distance(fabric);
    if (wanted >= out.fitting) continue;
    out.fitting = wanted;
    out.fabric = fabric.name.empty() ? fabric.id : fabric.name;
  }
  for (const pattern::Panel& panel : input.pattern.panels) {
    const double now = pattern::spacing_on(panel, out.now);
    out.particles_now += particles_on(area_of(panel), now);
    out.particles_fitting += particles_on(area_of(panel), std::min(now, out.fitting));
  }
  return out;
}

json::JsonValue mesh_fit_json(const MeshFit& fit) {
  const auto tenths = [](double value) { return std::round(value * 10) / 10; };
  return std::vector<json::JsonMember>{{"particle_distance_mm", tenths(mm_from_metres(fit.now))},
                                       {"fitting_mm", tenths(mm_from_metres(fit.fitting))},
                                       {"particles", std::round(fit.particles_now)},
                                       {"particles_fitting", std::round(fit.particles_fitting)},
                                       {"times", tenths(fit.times())}};
}

std::string mesh_fit_text(const MeshFit& fit) {
  if (fit.fabric.empty()) return "";
  const auto mm = [](double metres) { return fixed_text(mm_from_metres(metres), 1); };
  return "triangles of " + mm(fit.fitting) + " mm would let " + fit.fabric +
         " fold as it likes (particle_distance_mm is " + mm(fit.now) + "): about " +
         fixed_text(fit.particles_fitting, 0) + " particles instead of " + fixed_text(fit.particles_now, 0) +
         ", and " + fixed_text(fit.times(), 1) + " times the time or more";
}

}  // namespace toile::app
