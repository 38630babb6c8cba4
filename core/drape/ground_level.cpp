#include "core/drape/ground_level.h"

#include <algorithm>
#include <vector>

#include "core/base/aabb.h"

namespace toile::drape {

std::optional<double> ground_under(const DrapeInput& input, const DrapeStart& start, bool on_body) {
  constexpr double kOffGround = 1.5e-3;  // m, that cloth starts above the ground at least
  if (!input.settings.ground || !start.person) return std::nullopt;
  const double floor = start.person->figure.floor;
  if (on_body) return floor;
  return std::min(floor, bounding_box(start.assembly.positions).low.y - kOffGround);
}

void tell_low_ground(const DrapeStart& start, std::optional<double> ground, preflight::Findings& findings) {
  constexpr double kLow = 0.01;  // m below the floor that nobody sees
  if (!ground || start.person->figure.floor - *ground < kLow) return;
  const std::vector<Vec3>& x = start.assembly.positions;
  const auto lowest = std::min_element(x.begin(), x.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; });
  findings.push_back(preflight::found(
      preflight::FindingKind::kBelowFloor,
      "cloth begins " + preflight::length_text(start.person->figure.floor - lowest->y) +
          " below the soles of the feet, and the ground lies there; place it higher to have it on the floor",
      {}, *lowest));
}

}  // namespace toile::drape
