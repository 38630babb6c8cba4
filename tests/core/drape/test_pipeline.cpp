#include "core/drape/pipeline.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/base/hash.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

struct Recorder final : drape::FrameSink {
  sewing::GarmentMesh garment;
  std::vector<drape::Frame> frames;
  void begin(const sewing::GarmentMesh& g) override { garment = g; }
  void frame(const drape::Frame& f) override { frames.push_back(f); }
};

TEST(Pipeline, ASheetFallsOnAColumnAndHangsAroundIt) {
  const drape::DrapeResult r = drape::drape(test::tablecloth(), {}, nullptr).value();
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_GT(r.frames_checked, 30);
  double highest = 0, lowest = 1;
  for (const Vec3& p : r.positions) {
    highest = std::max(highest, p.y);
    lowest = std::min(lowest, p.y);
  }
  EXPECT_NEAR(highest, 0.301, 0.004) << "it lies on the head";
  EXPECT_LT(lowest, 0.26) << "and its corners hang";
}

TEST(Pipeline, TwoPanelsAreSewnIntoATubeAroundAColumn) {
  const drape::DrapeResult r = drape::drape(test::tube(), {}, nullptr).value();
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_EQ(r.seam_gap_max, 0) << "welded";
  // The tube goes around: cloth on all four sides.
  bool sides[4] = {};
  for (const Vec3& p : r.positions) {
    sides[0] |= p.x > 0.07;
    sides[1] |= p.x < -0.07;
    sides[2] |= p.z > 0.07;
    sides[3] |= p.z < -0.07;
  }
  for (const bool side : sides) EXPECT_TRUE(side);
}

TEST(Pipeline, TheSameInputGivesTheSameHash) {
  const auto hash = [] { return hash_of(drape::drape(test::tube(), {}, nullptr).value().positions); };
  EXPECT_EQ(hash(), hash());
}

TEST(Pipeline, FramesComeInOrderAndEndWhereTheDrapeEnds) {
  Recorder recorder;
  const drape::DrapeInput input = test::tablecloth();
  const drape::DrapeResult r = drape::drape(input, {}, &recorder).value();
  ASSERT_GT(recorder.frames.size(), 10u);
  EXPECT_EQ(recorder.frames.front().step, 0);
  for (std::size_t i = 1; i < recorder.frames.size(); ++i) {
    EXPECT_GT(recorder.frames[i].step, recorder.frames[i - 1].step);
  }
  EXPECT_EQ(recorder.frames.back().step, r.steps);
  EXPECT_EQ(recorder.frames.back().positions, r.positions);
  EXPECT_EQ(recorder.garment.triangles, r.garment.triangles);
}

TEST(Pipeline, ACancelledDrapeSaysSoAndKeepsWhatThereIs) {
  std::atomic<bool> cancel{false};
  RunContext context;
  context.cancel = &cancel;
  context.on_progress = [&](const Progress& p) { cancel = p.phase == "drape" && p.fraction > 0.05; };
  const drape::DrapeResult r = drape::drape(test::tablecloth(), context, nullptr).value();
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kCancelled);
  EXPECT_FALSE(r.settled());
  EXPECT_FALSE(r.positions.empty());
}

TEST(Pipeline, APieceThatStartsInTheBodyIsRefusedWithItsNameAndPlace) {
  drape::DrapeInput input = test::tablecloth();
  std::get<sewing::RigidPlacement>(input.placements[0]).translation.y = 0.2;
  const auto r = drape::drape(input, {}, nullptr);
  ASSERT_FALSE(r.ok());
  EXPECT_EQ(r.error().code, "start.crosses_body");
  EXPECT_NE(r.error().where.find("piece sheet"), std::string::npos);
  EXPECT_NE(r.error().where.find(" m"), std::string::npos);
}

TEST(Pipeline, PiecesThatStartThroughEachOtherAreRefusedWithBothNames) {
  drape::DrapeInput input = test::tube();
  std::get<sewing::RigidPlacement>(input.placements[1]) = {{0.02, 0.16, 0.1}, {0, 1.2, 0}, false};
  const auto r = drape::drape(input, {}, nullptr);
  ASSERT_FALSE(r.ok());
  EXPECT_EQ(r.error().code, "start.crosses_cloth");
  EXPECT_NE(r.error().where.find("front"), std::string::npos);
  EXPECT_NE(r.error().where.find("back"), std::string::npos);
}

TEST(Pipeline, PiecesThatTouchAtTheStartAreMovedApart) {
  drape::DrapeInput input = test::tube();
  std::get<sewing::RigidPlacement>(input.placements[1]).translation = {0.05, 0.16,
                                                                       0.1};  // overlaps in the same plane
  input.pattern.seams.clear();
  const auto r = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(r.ok()) << to_string(r.error());
  ASSERT_FALSE(r->findings.empty());
  EXPECT_EQ(r->findings.front().kind, preflight::FindingKind::kTouches);
  EXPECT_TRUE(r->findings.front().repaired);
  EXPECT_EQ(r->worst.cloth_body + r->worst.cloth_cloth, 0);
}

/// A tube of two panels that together are too short to go around the column.
drape::DrapeInput too_short_around(double width_mm) {
  drape::DrapeInput input = test::tube();
  input.pattern.panels[0] = test::rectangle("front", width_mm, 120);
  input.pattern.panels[1] = test::rectangle("back", width_mm, 120);
  return input;
}

TEST(Pipeline, ASeamThatCannotCloseIsLeftOpenAndNamedAndTheRestIsDraped) {
  const auto r = drape::drape(too_short_around(140), {}, nullptr);
  ASSERT_TRUE(r.ok());
  EXPECT_FALSE(r->settled());
  EXPECT_GT(r->simulated_time, 4) << "what is sewn goes on falling";
  ASSERT_FALSE(r->open_seams.empty());
  EXPECT_GT(r->open_seams[0].gap, 10e-3);
  EXPECT_EQ(r->worst.cloth_body + r->worst.cloth_cloth, 0) << "a thread is never stronger than contact";
}

/// The seam with the two sewn vertices that ended furthest from each other.
std::string widest_seam(const drape::DrapeInput& input, const drape::DrapeResult& r) {
  const auto gap = [&](std::size_t k) {
    const auto [i, j] = r.garment.sewn[k];
    return length(r.positions[i] - r.positions[j]);
  };
  std::size_t widest = 0;
  for (std::size_t k = 1; k < r.garment.sewn.size(); ++k) {
    if (gap(k) > gap(widest)) widest = k;
  }
  return input.pattern.seams[r.garment.seam_of_sewn[widest]].id;
}

TEST(Pipeline, ASeamThatNearlyClosesIsNamedAsWell) {
  const drape::DrapeInput input = too_short_around(150);  // 10 mm open, where a seam counts as lost
  const auto r = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(r.ok());
  EXPECT_FALSE(r->settled());
  const std::string widest = widest_seam(input, *r);
  EXPECT_EQ(r->stop_reason.kind, drape::Stop::kOpenSeam) << drape::to_string(r->stop_reason);
  EXPECT_EQ(r->stop_reason.name, widest) << "is open the most";
  EXPECT_EQ(r->stop_reason.gap, r->seam_gap_max);
  EXPECT_EQ(r->worst.cloth_body + r->worst.cloth_cloth, 0);
}

TEST(Pipeline, AnUnsettledDrapeEndsAtItsTimeLimit) {
  drape::DrapeInput input = test::tablecloth();
  input.settings.max_time = 0.3;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_FALSE(r.settled());
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kTime);
  EXPECT_NEAR(r.simulated_time, 0.3, 0.01);
}

}  // namespace
}  // namespace toile
