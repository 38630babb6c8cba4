// Cloth that is led to places and lines, kept there and let go.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/drape/pipeline.h"
#include "core/sewing/attached_places.h"
#include "tests/core/drape/garments.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

/// A level ring of `corners` around the column's axis.
std::vector<Vec3> ring(double radius, double height, int corners = 32) {
  std::vector<Vec3> out;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * 3.14159265358979 * i / corners;
    out.push_back({radius * std::sin(a), height, radius * std::cos(a)});
  }
  return out;
}

sewing::Attachment to_goal(Index panel, std::vector<Index> edges, std::vector<Vec3> goal,
                           double release_after) {
  sewing::Attachment a;
  a.id = "to_goal";
  a.panel = panel;
  a.edges = std::move(edges);
  a.hold = sewing::Attachment::Hold::kGoal;
  a.goal = std::move(goal);
  a.release_after = release_after;
  return a;
}

/// The tube, its upper edges led to a line around the column at 0.28 m.
drape::DrapeInput tube_on_a_line(double release_after) {
  drape::DrapeInput input = test::tube();
  const std::vector<Vec3> line = ring(0.0715, 0.28);
  input.attachments = {to_goal(0, {2}, line, release_after), to_goal(1, {2}, line, release_after)};
  input.settings.max_time = 2.6;
  return input;
}

/// Farthest of the upper edges from the line, m, and their lowest point.
struct TopEdge {
  double off = 0, lowest = HUGE_VAL;
};
TopEdge top_of(const drape::DrapeInput& input, std::span<const Vec3> x) {
  const auto start = drape::prepare_start(input, {}).value();
  TopEdge top;
  for (const Index panel : {0, 1}) {
    const Index first = start.assembly.garment.first_vertex[panel];
    for (const Index v : start.meshes.panels[panel].edge_vertices[2]) {
      const Vec3 p = x[first + v];
      top.off = std::max(top.off, length(p - sewing::nearest_on_goal(input.attachments[0].goal, p)));
      top.lowest = std::min(top.lowest, p.y);
    }
  }
  return top;
}

TEST(Attachments, AnEdgeLedToALineStaysOnItUntilItIsReleasedAndFallsThen) {
  const drape::DrapeInput held = tube_on_a_line(-1), freed = tube_on_a_line(0.2);
  const drape::DrapeResult stays = drape::drape(held, {}, nullptr).value(),
                           falls = drape::drape(freed, {}, nullptr).value();
  EXPECT_LT(top_of(held, stays.positions).off, 3e-3);
  ASSERT_EQ(stays.holds.size(), 2u);
  EXPECT_FALSE(stays.holds[0].released);
  EXPECT_LT(stays.holds[0].off, 3e-3);

  EXPECT_LT(top_of(freed, falls.positions).lowest, 0.28 - 0.02) << "the tube is wider than the column";
  ASSERT_TRUE(falls.holds[0].released);
  EXPECT_LT(falls.holds[0].off, 3e-3) << "it lay on the line when it was let go";
  EXPECT_GT(falls.holds[0].released_at, 1.2);
  EXPECT_LT(falls.holds[0].released_at, 2.2);
  EXPECT_EQ(crossings_of(stays) + crossings_of(falls), 0);
}

TEST(Attachments, AlongALineClothIsFreeToSlide) {
  // The ends are drawn together at the back: from where the line took them first, they must slide there.
  const drape::DrapeInput input = tube_on_a_line(-1);
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_LE(r.seam_gap_max, 5e-4) << drape::to_string(r.stop_reason);
}

TEST(Attachments, APointComesToAPlaceAndHangsThere) {
  drape::DrapeInput input = test::tablecloth();
  sewing::Attachment pin = to_goal(0, {}, {{0.1, 0.4, 0.1}}, -1);
  pin.points = {{0.03, 0.12}};
  input.attachments = {pin};
  input.settings.max_time = 2;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_LT(r.holds[0].off, 1e-3) << drape::to_string(r.stop_reason);
  const double highest =
      std::max_element(r.positions.begin(), r.positions.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })->y;
  EXPECT_NEAR(highest, 0.4, 0.01);
  EXPECT_EQ(crossings_of(r), 0);
}

TEST(Attachments, OfAnEdgeTheMiddleComesToAPlace) {
  drape::DrapeInput input = test::tablecloth();
  input.attachments = {to_goal(0, {2}, {{0, 0.4, -0.1}}, -1)};
  const auto start = drape::prepare_start(input, {}).value();
  ASSERT_EQ(start.assembly.led[0].size(), 1u);
  const Vec3 middle = sewing::position_of(start.assembly.led[0][0], start.assembly.positions);
  EXPECT_NEAR(middle.x, 0, 1e-6);
  EXPECT_NEAR(middle.z, -0.12, 1e-6);
}

TEST(Attachments, ABodyInTheWayMakesTheClothWaitAndIsNotCrossed) {
  drape::DrapeInput input = test::tablecloth();
  input.attachments = {to_goal(0, {}, {{0, 0.2, 0}}, -1)};  // deep in the column under the sheet
  input.settings.max_time = 1.5;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(crossings_of(r), 0);
  EXPECT_NEAR(r.holds[0].off, 0.1, 0.01) << "it rests on the head of the column, at 0.3 m";
}

TEST(Attachments, ADrapeBrokenOffWhileATetherHoldsGoesOnToTheSameBytes) {
  const drape::DrapeInput input = tube_on_a_line(0.2);
  auto whole = drape::DrapeRun::start(input, {}, nullptr).value();
  whole->advance(1700, {});
  const std::string checkpoint = whole->checkpoint();
  whole->advance(3000, {});
  auto resumed = drape::DrapeRun::resume(input, checkpoint, {}, nullptr).value();
  resumed->advance(3000, {});
  EXPECT_EQ(whole->session().positions(), resumed->session().positions());
  EXPECT_TRUE(resumed->session().holds()[0].released);
  EXPECT_EQ(whole->session().holds()[0].off, resumed->session().holds()[0].off);
}

TEST(Attachments, APointBesideItsPieceIsRefusedByName) {
  drape::DrapeInput input = test::tablecloth();
  sewing::Attachment pin = to_goal(0, {}, {{0, 1, 0}}, -1);
  pin.points = {{0.5, 0.5}};
  input.attachments = {pin};
  const auto start = drape::prepare_start(input, {});
  ASSERT_FALSE(start.ok());
  EXPECT_EQ(start.error().code, "attachment.off_piece");
  EXPECT_EQ(start.error().where, "attachment to_goal");
}

}  // namespace
}  // namespace toile
