// Contact must not cheat by distance: what lies on something lies on it.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Well inside the column's head, where cloth hangs over no rim (m, from the axis).
constexpr double kHead = 0.035, kTop = 0.3;

/// Gaps of a sheet that lies on the column's head (m), where no rim is near.
std::vector<double> gaps_on_the_head(const drape::DrapeInput& input) {
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  std::vector<double> gaps;
  for (const Vec3& p : r.positions) {
    if (std::hypot(p.x, p.z) < kHead) gaps.push_back(p.y - kTop);
  }
  return gaps;
}

/// At 20 mm the rim of the narrow head is two edges away from what is looked at, and the cloth's bow over it
/// reaches there; so the mesh is finer, or the head wider.
std::vector<drape::DrapeInput> sheets_on_a_head() {
  drape::DrapeInput fine = test::tablecloth();
  fine.settings.particle_distance = 0.012;
  drape::DrapeInput wide = test::tablecloth();
  wide.pattern.panels = {test::rectangle("sheet", 400, 400)};
  std::get<sewing::RigidPlacement>(wide.placements[0]).translation.z = 0.2;
  wide.bodies = {test::column(0.12, 0, kTop)};
  return {fine, wide};
}

TEST(ContactDistance, ASheetOnAHeadLiesWithinAMillimetreOfTheOffset) {
  for (const drape::DrapeInput& input : sheets_on_a_head()) {
    const std::vector<double> gaps = gaps_on_the_head(input);
    ASSERT_GE(gaps.size(), 8u);
    for (const double gap : gaps) EXPECT_GT(gap, 0);
    EXPECT_LE(median(gaps), input.bodies[0].skin_offset + 1e-3);
  }
}

TEST(ContactDistance, ASheetOnASheetLiesWithinTwoMillimetresOfIt) {
  drape::DrapeInput input = test::tablecloth();
  input.pattern.panels.push_back(test::rectangle("upper", 240, 240));
  sewing::RigidPlacement above = std::get<sewing::RigidPlacement>(input.placements[0]);
  above.translation.y += 0.01;
  input.placements.push_back(above);
  input.fabric_of_panel.push_back(0);
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  // Two alike sheets: the second half of the vertices is the upper one.
  const std::size_t half = r.positions.size() / 2;
  std::vector<double> gaps;
  for (std::size_t i = half; i < r.positions.size(); ++i) {
    const Vec3 p = r.positions[i];
    if (std::hypot(p.x, p.z) >= kHead) continue;
    double nearest = 1, below = 0;
    for (std::size_t j = 0; j < half; ++j) {
      const double side = std::hypot(p.x - r.positions[j].x, p.z - r.positions[j].z);
      if (side < nearest) {
        nearest = side;
        below = r.positions[j].y;
      }
    }
    gaps.push_back(p.y - below);
  }
  ASSERT_GE(gaps.size(), 8u);
  EXPECT_GT(median(gaps), 0);
  EXPECT_LE(median(gaps), 2e-3);
}

}  // namespace
}  // namespace toile
