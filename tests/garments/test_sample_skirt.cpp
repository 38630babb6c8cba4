// The sample as a user drapes it: what a worn skirt must be, in numbers.

#include <gtest/gtest.h>

#include "core/analysis/report.h"
#include "core/body/measure/tape.h"
#include "core/drape/pipeline.h"
#include "core/project/resolve/resolve.h"
#include "tests/garments/golden.h"
#include "tests/garments/hem_folds.h"

namespace toile {
namespace {

struct Draped {
  drape::DrapeInput input;
  drape::DrapeResult result;
  analysis::Report report;
};

const Draped& skirt() {
  static const Draped draped = [] {
    Draped d;
    d.input = resolve::read_project(TOILE_SOURCE_DIR "/samples/skirt/project.json").value().input;
    d.result = drape::drape(d.input, {}, nullptr).value();
    d.report = analysis::make_report(d.input, d.result);
    return d;
  }();
  return draped;
}

/// Heights of the vertices of pieces whose id begins with `prefix`: least and greatest.
std::pair<double, double> heights(const Draped& d, const std::string& prefix) {
  double low = 10, high = -10;
  for (Index i = 0; i < d.result.garment.vertex_count(); ++i) {
    if (d.input.pattern.panels[d.result.garment.panel_of_vertex[i]].id.rfind(prefix, 0) != 0) continue;
    low = std::min(low, d.result.positions[i].y);
    high = std::max(high, d.result.positions[i].y);
  }
  return {low, high};
}

TEST(SampleSkirt, SettlesWithoutACrossingInAnyFrameAndWithShutSeams) {
  const analysis::Report& r = skirt().report;
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  EXPECT_EQ(r.intersections.cloth_body + r.intersections.cloth_cloth, 0);
  EXPECT_EQ(r.worst_frame.cloth_body + r.worst_frame.cloth_cloth, 0);
  EXPECT_GE(r.frames_checked, 100);
  EXPECT_LE(r.seam_gap_max_mm, 0.5);
}

TEST(SampleSkirt, EndsInTheBytesThatAreWrittenDown) { test::expect_golden("skirt", skirt().report.hash); }

TEST(SampleSkirt, HasTheParticlesAndTrianglesItSays) {
  const analysis::Report& r = skirt().report;
  EXPECT_GE(r.particles, 3000);
  EXPECT_LE(r.particles, 3300);
  EXPECT_NEAR(r.body_triangles, 3300, 100);
}

TEST(SampleSkirt, TheWaistbandSitsAtTheWaist) {
  const measure::Girth waist = measure::trunk_girths(skirt().input.bodies[0].mesh).waist;
  const auto [low, high] = heights(skirt(), "band");
  EXPECT_LT(low - 0.03, waist.height);
  EXPECT_GT(high + 0.03, waist.height);
  EXPECT_LT(high - low, 0.08) << "level, not slipped on one side";
}

TEST(SampleSkirt, IsHardlyStretchedAnywhereButOverTheHip) {
  const analysis::Report& r = skirt().report;
  EXPECT_LT(r.warp.p99, 0.015);
  EXPECT_LT(r.weft.p99, 0.03);
}

TEST(SampleSkirt, HangsInFoldsAroundTheLegs) {
  // Neither a tube, round or flat, nor a crumple.
  const Draped& d = skirt();
  const int folds = garments::hem_folds(d.result.positions);
  EXPECT_GE(folds, 4);
  EXPECT_LE(folds, 14);
  const auto [low, high] = heights(d, "front");
  EXPECT_GT(high - low, 0.5);
}

}  // namespace
}  // namespace toile
