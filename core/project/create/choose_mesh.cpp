#include "core/project/create/choose_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/seams/second_layers.h"

namespace toile::create {
namespace {

constexpr double kParticles = 6000;
constexpr double kCoarsest = 25;  // mm: folds of soft cloth are some 50 mm wide and more
constexpr double kRounded = 0.5;  // mm

double area_of(const pattern::Panel& panel) {
  double area = pattern::signed_area(panel.outline);
  for (const pattern::Loop& hole : panel.holes) area += pattern::signed_area(hole);  // clockwise: negative
  return area;
}

}  // namespace

double distance_for(double area) {
  const double finest = project::ProjectSettings{}.particle_distance_mm;
  const double fitting = std::sqrt(area / kParticles * 2 / std::sqrt(3.0));
  return std::clamp(std::ceil(fitting / kRounded) * kRounded, finest, kCoarsest);
}

void choose_mesh(const pattern::Pattern& pattern, project::ProjectSettings& settings) {
  const std::vector<char> layers = seams::lying_on_others(pattern);
  double area = 0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p)
    if (!layers[p]) area += area_of(pattern.panels[p]);
  const double distance = distance_for(area);
  if (distance <= settings.particle_distance_mm) return;
  settings.time_step_s *= distance / settings.particle_distance_mm;
  settings.particle_distance_mm = distance;
}

}  // namespace toile::create
