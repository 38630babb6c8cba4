// Straps stay on the shoulders that they were drawn for.

#include "core/drape/shoulder_holds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/drape/pipeline.h"
#include "core/dressing/shoulders.h"
#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

const measure::BodyFigure& figure() { return test::person().figure; }

/// The open top before and behind the mannequin, whose skin is as slippery as wet soap.
drape::DrapeInput slippery() {
  drape::DrapeInput input;
  input.pattern = test::open_top();
  input.fabrics.resize(1);
  input.fabric_of_panel = {0, 0};
  const double height = figure().shoulder[0].y - 0.47;
  input.placements = {sewing::RigidPlacement{{0, height, 0.22}, {}, false},
                      sewing::RigidPlacement{{0, height, -0.22}, {0, std::numbers::pi, 0}, false}};
  input.bodies = {*test::person().body};
  input.bodies[0].friction = 0.02;
  input.settings.particle_distance = 0.03;
  return input;
}

std::ptrdiff_t times_told(const drape::DrapeResult& result, preflight::FindingKind kind) {
  return std::count_if(result.findings.begin(), result.findings.end(),
                       [&](const preflight::Finding& f) { return f.kind == kind; });
}

TEST(ShoulderHolds, StrapsThatWouldSlideOffAreKeptOnAndNamed) {
  const drape::DrapeResult result = drape::drape(slippery(), {}, nullptr).value();
  EXPECT_EQ(result.worn, drape::Worn::kYes);
  for (const std::size_t side : {measure::kWearersLeft, measure::kWearersRight})
    EXPECT_TRUE(dressing::lies_on_shoulder(figure(), side, result.positions)) << side;
  EXPECT_EQ(times_told(result, preflight::FindingKind::kHeldOn), 2);
  EXPECT_EQ(times_told(result, preflight::FindingKind::kOffShoulder), 0);
  EXPECT_EQ(result.worst.cloth_body + result.worst.cloth_cloth, 0);
}

TEST(ShoulderHolds, InTrueMotionNothingKeepsThem) {
  drape::DrapeInput input = slippery();
  input.settings.mode = drape::DrapeMode::kDynamic;
  input.settings.max_time = 3;
  const drape::DrapeResult result = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(result.worn, drape::Worn::kNo);
  EXPECT_EQ(times_told(result, preflight::FindingKind::kHeldOn), 0);
}

TEST(ShoulderHolds, NoClothIsDrawnFartherInThanNearTheShouldersEnd) {
  const drape::DrapeInput input = slippery();
  const auto meshes = mesh::make_panel_meshes(input.pattern, 0.03, {}).value();
  const sewing::Assembly top = sewing::assemble(meshes, input.placements, {}).value();
  std::vector<Index> itself(top.positions.size());
  for (std::size_t v = 0; v < itself.size(); ++v) itself[v] = static_cast<Index>(v);
  const auto holds = drape::make_shoulder_holds(top, figure(), itself, static_cast<Index>(itself.size()));
  ASSERT_EQ(holds.size(), 2u);
  const Vec3 neck = figure().neck_side[0], shoulder = figure().shoulder[0];
  for (const auto& held : holds[0].held) {
    const double placed = std::abs(top.positions[held.v].x - figure().middle);
    EXPECT_GE(held.aside, 0.1 * neck.x + 0.9 * shoulder.x - figure().middle - 1e-9);
    EXPECT_GE(held.aside, placed);
  }
  EXPECT_EQ(holds[0].held.size(), top.positions.size()) << "it has no sleeves";
}

}  // namespace
}  // namespace toile
