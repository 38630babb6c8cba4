// The look at the start of real garments on a real body. The data lie outside the project (TOILE_SHARED).

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/drape/pipeline.h"
#include "core/project/resolve/resolve.h"
#include "tests/garmentcode/to_project.h"

namespace toile {
namespace {

class GarmentStarts : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("TOILE_SHARED") == nullptr) {
      GTEST_SKIP() << "TOILE_SHARED is not set: NO REAL GARMENT WAS LOOKED AT";
    }
  }
  static drape::DrapeInput garment(const std::string& name, double particle_distance_mm) {
    const auto folder = std::filesystem::path(TOILE_BINARY_DIR) / "garment_starts" / name;
    const Status written =
        test::write_garmentcode_project(std::filesystem::path(std::getenv("TOILE_SHARED")) / "data", name,
                                        "garmentcode-mean_all.obj", {"wb_"}, particle_distance_mm, folder);
    EXPECT_TRUE(written.ok()) << to_string(written.error());
    return resolve::read_project(folder / "project.json").value().input;
  }
  static int count(const preflight::Findings& findings, preflight::FindingKind kind,
                   preflight::Severity severity) {
    int n = 0;
    for (const preflight::Finding& f : findings) n += f.kind == kind && f.severity == severity;
    return n;
  }
};
using LongGarmentStarts = GarmentStarts;

TEST_F(GarmentStarts, AllFiveBeginWithoutFault) {
  for (const char* name : {"tshirt", "hoody", "fitted_blouse_long", "pants", "skirt_2panel"}) {
    SCOPED_TRACE(name);
    const drape::DrapeInput input = garment(name, 20);
    const auto start = drape::prepare_start(input, {});
    ASSERT_TRUE(start.ok()) << to_string(start.error());
    const auto error = preflight::first_error(start->findings);
    EXPECT_FALSE(error) << to_string(*error);
  }
}

TEST_F(GarmentStarts, TheTrousersOverlappingTipsArePartedLeftAndRightAlike) {
  const drape::DrapeInput input = garment("pants", 25);
  const auto start = drape::prepare_start(input, {}).value();
  ASSERT_FALSE(start.findings.empty());
  EXPECT_EQ(start.findings.front().kind, preflight::FindingKind::kTouches);
  EXPECT_TRUE(start.findings.front().repaired);
  EXPECT_NE(preflight::where_text(start.findings.front()).find("pant_b_"), std::string::npos);
  const auto placed = sewing::assemble(start.meshes, input.placements, input.attachments)->positions;
  std::vector<Vec3> shifts;
  for (std::size_t p = 0; p < input.pattern.panels.size(); ++p) {
    const Index v = start.assembly.garment.first_vertex[p];
    const Vec3 shift = start.assembly.positions[v] - placed[v];
    if (length(shift) > 0) shifts.push_back(shift);
  }
  ASSERT_EQ(shifts.size(), 2u) << "nothing but the two that overlap";
  EXPECT_LT(length(shifts[0] - Vec3{-shifts[1].x, shifts[1].y, shifts[1].z}), 1e-6);
  EXPECT_LE(length(shifts[0]), 0.01);
}

TEST_F(GarmentStarts, TrousersPlacedAsideAreRefusedForThreadsThroughTheLegs) {
  drape::DrapeInput input = garment("pants", 25);
  for (sewing::Placement& p : input.placements) std::get<sewing::RigidPlacement>(p).translation.x += 0.1;
  const auto start = drape::prepare_start(input, {}).value();
  EXPECT_GE(count(start.findings, preflight::FindingKind::kThreadThroughBody, preflight::Severity::kError),
            1);
}

TEST_F(GarmentStarts, ASkirtForAChildIsTooTightForThisBody) {
  drape::DrapeInput input = garment("skirt_2panel", 20);
  for (pattern::Panel& panel : input.pattern.panels) {
    const double middle =
        0.5 * (panel.outline.edges[0].curves[0].p0.x + panel.outline.edges[2].curves[0].p0.x);
    for (pattern::PanelEdge& edge : panel.outline.edges) {
      for (pattern::CubicBezier& c : edge.curves) {
        for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) p->x = middle + 0.6 * (p->x - middle);
      }
    }
  }
  const auto start = drape::prepare_start(input, {}).value();
  EXPECT_GE(count(start.findings, preflight::FindingKind::kTightRing, preflight::Severity::kWarning), 1);
}

TEST_F(LongGarmentStarts, TheTrousersDrapeOnceTheirTipsAreParted) {
  const drape::DrapeInput input = garment("pants", 25);
  const auto result = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->worst.cloth_body + result->worst.cloth_cloth, 0);
  EXPECT_NE(result->stop_reason.kind, drape::Stop::kOpenSeam) << drape::to_string(result->stop_reason);
  EXPECT_NE(result->stop_reason.kind, drape::Stop::kNotFinite);
}

}  // namespace
}  // namespace toile
