// Drapes by the method of Kim and Park 2003, from the same input as our own.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/collision/crossings.h"
#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

drape::DrapeInput by_paper(drape::DrapeInput input) {
  input.settings.method = drape::DrapeMethod::kPaper;
  input.settings.max_time = 3;
  return input;
}

int crossings_of(const drape::DrapeInput& input, const drape::DrapeResult& r) {
  const auto surface = collision::make_surface(r.garment.triangles, r.garment.vertex_count(), r.garment.weld);
  std::size_t count = collision::self_crossings(surface, r.positions).size();
  for (const body::Body& body : input.bodies) {
    const auto solid = collision::make_crossing_body(body.mesh.vertices, body.mesh.triangles);
    count += collision::body_crossings(surface, r.positions, solid).size();
  }
  return static_cast<int>(count);
}

TEST(PaperSession, DrapesATableclothOverTheSameColumn) {
  const drape::DrapeInput input = by_paper(test::tablecloth());
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  const auto [low, high] =
      std::minmax_element(r.positions.begin(), r.positions.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; });
  EXPECT_NEAR(high->y, 0.3, 0.01) << "its middle lies on the column";
  EXPECT_LT(low->y, 0.27) << "its corners hang";
  EXPECT_EQ(r.at_end.cloth_body + r.at_end.cloth_cloth, crossings_of(input, r))
      << "the count is the exact one";
}

TEST(PaperSession, SewsATubeAndTellsThatItIsShut) {
  const drape::DrapeResult r = drape::drape(by_paper(test::tube()), {}, nullptr).value();
  EXPECT_LT(r.seam_gap_max, 0.5e-3);
  EXPECT_TRUE(r.open_seams.empty());
  ASSERT_EQ(r.holds.size(), 1u);
  EXPECT_FALSE(r.holds[0].released);
}

TEST(PaperSession, TellsOfASeamThatTheColumnKeepsOpen) {
  drape::DrapeInput input = by_paper(test::tube());
  input.bodies = {test::column(0.095, 0, 0.3)};  // 60 cm around, and the tube has 52
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_GT(r.seam_gap_max + 1e-3 * (r.at_end.cloth_body + r.at_end.cloth_cloth), 0.5e-3)
      << "what cannot be sewn without going through is open, or crosses: either is told";
}

TEST(PaperSession, GivesTheSameBytesAgainAndFromACheckpoint) {
  const drape::DrapeInput input = by_paper(test::tube());
  const drape::DrapeResult whole = drape::drape(input, {}, nullptr).value();
  auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  while (!run->done()) {
    run->advance(101, {});
    run = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  }
  const drape::DrapeResult cut = run->conclude();
  EXPECT_EQ(cut.positions, whole.positions);
  EXPECT_EQ(cut.steps, whole.steps);
  EXPECT_EQ(cut.stop_reason.kind, whole.stop_reason.kind);
  EXPECT_EQ(cut.worst.cloth_cloth, whole.worst.cloth_cloth);
  EXPECT_GT(cut.resumed, 1);
}

TEST(PaperSession, ACheckpointOfTheOtherMethodIsAnotherDrapes) {
  const auto ours = drape::DrapeRun::start(test::tube(), {}, nullptr).value();
  const drape::DrapeInput input = by_paper(test::tube());
  const auto resumed = drape::DrapeRun::resume(input, ours->checkpoint(), {}, nullptr);
  ASSERT_FALSE(resumed);
  EXPECT_EQ(resumed.error().code, "checkpoint.other_input");
}

TEST(PaperSession, TakesItsOwnTimeStep) {
  drape::DrapeInput input = by_paper(test::tablecloth());
  input.settings.paper.time_step = 0.01;
  input.settings.until_settled = false;
  input.settings.max_time = 0.5;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.steps, 50);
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kTime);
}

TEST(PaperSession, TellsWhatItLeavesOut) {
  drape::DrapeInput input = by_paper(test::tube());
  input.settings.air.density = 1.2;
  input.settings.max_time = 0.01;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  const auto told = std::find_if(r.findings.begin(), r.findings.end(), [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kMethodWithout;
  });
  ASSERT_NE(told, r.findings.end());
  EXPECT_NE(told->message.find("air"), std::string::npos);
}

}  // namespace
}  // namespace toile
