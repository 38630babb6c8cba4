// Straps on the shoulders of the sample's mannequin while a garment is put on.

#include "core/dressing/shoulders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/dressing/dress.h"
#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

const measure::BodyFigure& figure() { return test::person().figure; }

/// A place above the left shoulder's straight line: a share of the way from the neck, metres above it.
Vec3 over_left(double share, double above) {
  const Vec3 neck = figure().neck_side[measure::kWearersLeft];
  return neck + (figure().shoulder[measure::kWearersLeft] - neck) * share + Vec3{0, above, 0};
}

TEST(Shoulders, CollarsSleevesAndTheChestAreNotOverThem) {
  EXPECT_TRUE(dressing::is_over_shoulder(figure(), over_left(0.5, 0.05)));
  EXPECT_TRUE(dressing::is_over_shoulder(figure(), over_left(1.2, 0.05))) << "a strap about to slide off";
  EXPECT_FALSE(dressing::is_over_shoulder(figure(), over_left(0.05, 0.05))) << "a collar";
  EXPECT_FALSE(dressing::is_over_shoulder(figure(), over_left(1.6, 0.05))) << "a sleeve";
  EXPECT_FALSE(dressing::is_over_shoulder(figure(), over_left(0.5, -0.1))) << "the chest";
  EXPECT_FALSE(dressing::is_over_shoulder(figure(), over_left(0.5, 0.05) + Vec3{0, 0, 0.2}));
}

TEST(Shoulders, TheRoomIsThatOfTheClothNearestToOne) {
  const dressing::Wearer wearer(test::person());
  const std::vector<Vec3> far{over_left(0.5, 0.12)}, both{over_left(0.5, 0.12), over_left(0.6, 0.06)};
  const auto room = [&](std::span<const Vec3> x) {
    return dressing::room_over_shoulders(figure(), wearer.slim(0), x);
  };
  ASSERT_TRUE(room(far) && room(both));
  EXPECT_GT(*room(far), 0.05);
  EXPECT_LT(*room(both), *room(far));
  const Vec3 hip{figure().middle + 0.2, figure().hip, 0};
  EXPECT_FALSE(room(std::vector<Vec3>{hip})) << "a skirt hangs from no shoulder";
  EXPECT_FALSE(dressing::goes_over_shoulders(figure(), std::vector<Vec3>{hip}));
  EXPECT_TRUE(dressing::goes_over_shoulders(figure(), both));
}

/// The same on the right.
Vec3 over_right(double share, double above) {
  const Vec3 neck = figure().neck_side[measure::kWearersRight];
  return neck + (figure().shoulder[measure::kWearersRight] - neck) * share + Vec3{0, above, 0};
}

TEST(Shoulders, CentreIsWhereBothStrapsAreAsFarFromTheNeck) {
  const double ridge = std::abs(over_left(1, 0).x - over_left(0, 0).x);
  const auto off = [](std::vector<Vec3> x) { return dressing::off_centre(figure(), x); };
  EXPECT_NEAR(off({over_left(0.9, 0.02), over_right(0.3, 0.02), over_right(0.7, 0.02)}), 0.3 * ridge, 1e-9);
  EXPECT_NEAR(off({over_left(0.2, 0.02), over_right(1.0, 0.02)}), -0.4 * ridge, 1e-9);
  EXPECT_EQ(off({over_left(0.5, 0.02), over_right(0.3, 0.02)}), 0) << "neither would slide off";
  EXPECT_EQ(off({over_left(0.9, 0.02)}), 0) << "meant for one shoulder";
}

sewing::Assembly placed_open_top(double aside = 0) {
  const auto meshes = mesh::make_panel_meshes(test::open_top(), 0.025, {}).value();
  const double height = figure().shoulder[0].y - 0.47;
  const std::vector<sewing::Placement> places{
      sewing::RigidPlacement{{aside, height, 0.22}, {}, false},
      sewing::RigidPlacement{{aside, height, -0.22}, {0, std::numbers::pi, 0}, false}};
  return sewing::assemble(meshes, places, {}).value();
}

TEST(Shoulders, StrapsThatNothingElseHoldsLieOnThemOncePutOn) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly top = placed_open_top();
  const dressing::Dressed dressed =
      dressing::dress(top, wearer, dressing::dressing_ways().front(), RunContext{});
  ASSERT_TRUE(dressed.certificate.holds());
  const dressing::SlimFigure whole = wearer.slim(0);
  int count = 0;
  for (Index v = 0; v < top.garment.vertex_count(); ++v) {
    if (top.garment.rest[v].y < 0.4999) continue;  // of the shoulder seams
    ++count;
    EXPECT_LT(std::abs(dressed.positions[v].x - figure().middle), std::abs(top.garment.rest[v].x) + 0.012);
    EXPECT_LT(whole.clearance(dressed.positions[v]), 0.05);
  }
  EXPECT_GT(count, 8);
}

TEST(Shoulders, ATopThatStandsAsideIsPutOnInTheMiddle) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly top = placed_open_top(0.06);
  const std::vector<Vec3> x = dressing::dress(top, wearer, dressing::dressing_ways().front(), {}).positions;
  EXPECT_LT(std::abs(dressing::off_centre(figure(), x)), 0.012);
}

int bared(const sewing::Assembly& top, std::vector<Vec3> x, Vec3 moved) {
  for (Vec3& p : x) p += moved;
  const dressing::Wearer wearer(test::person());
  return dressing::bared_shoulders(top, figure(), dressing::worn_rings(top.garment, x, wearer.skeleton()), x);
}

TEST(Shoulders, AreBareWhereStrapsHangOnTheArms) {
  const sewing::Assembly top = placed_open_top();
  const dressing::Wearer wearer(test::person());
  const std::vector<Vec3> on = dressing::dress(top, wearer, dressing::dressing_ways().front(), {}).positions;
  EXPECT_EQ(bared(top, on, {}), 0);
  EXPECT_EQ(bared(top, on, {0, -0.06, 0}), 2) << "around the arms still, but below";
  EXPECT_EQ(bared(top, on, {0, -0.6, 0}), 0) << "no arm goes through it: that is another matter";
}

}  // namespace
}  // namespace toile
