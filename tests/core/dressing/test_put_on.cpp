// Garments on the sample's mannequin, from flat pieces before and behind it.

#include "core/dressing/put_on.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// A boxy top: front and back with straps, sewn at sides and shoulders; mm. `share` of its widths.
pattern::Pattern top(double share = 1) {
  pattern::Pattern p;
  std::vector<Vec2> corners{{-260, 0},  {260, 0},    {260, 280},  {190, 420},  {190, 500},  {110, 500},
                            {110, 380}, {-110, 380}, {-110, 500}, {-190, 500}, {-190, 420}, {-260, 280}};
  for (Vec2& c : corners) c.x *= share;
  p.panels = {test::polygon("front", corners), test::polygon("back", corners)};
  p.panels[1] = test::turned_over("back", corners);
  const auto other = [&](Index e) { return static_cast<Index>(corners.size()) - 1 - e; };
  for (const auto& [id, e] :
       {std::pair{"left", 1}, {"right", 11}, {"left_shoulder", 4}, {"right_shoulder", 8}})
    p.seams.push_back(test::seam(id, {{0, static_cast<Index>(e)}}, {{1, other(static_cast<Index>(e))}}));
  return p;
}

sewing::Assembly placed(const pattern::Pattern& p, double spacing, double height) {
  const auto meshes = mesh::make_panel_meshes(p, spacing, {}).value();
  const std::vector<sewing::Placement> places{
      sewing::RigidPlacement{{0, height, 0.22}, {}, false},
      sewing::RigidPlacement{{0, height, -0.22}, {0, 3.14159265358979, 0}, false}};
  return sewing::assemble(meshes, places, {}).value();
}

double top_height() { return test::person().figure.shoulder[0].y - 0.5; }

TEST(PutOn, ATopEndsAroundNeckArmsAndTrunkWithoutACrossing) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = placed(top(), 0.022, top_height());
  const auto on = dressing::put_on(assembly, assembly, wearer, {}).on;
  ASSERT_TRUE(on.has_value());
  EXPECT_TRUE(on->certificate.crossings.none());
  std::vector<dressing::Enclosure> around;
  for (const dressing::WornRing& ring : on->certificate.rings) around.push_back(ring.around);
  for (const auto& times : std::vector<std::array<int, dressing::kLimbCount>>{
           {1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 1}})
    EXPECT_EQ(std::count(around.begin(), around.end(), dressing::Enclosure{times}), 1);
  EXPECT_EQ(around.size(), 4U);
  for (const auto& [i, j] : assembly.garment.sewn) EXPECT_EQ(on->positions[i], on->positions[j]);
}

// Drawn in as a whole, so that they pass the hands, trousers begin at half their length and would hang in
// folds that no drape opens.
TEST(PutOn, TrousersLaidOutWideBeginAsLongAsTheyAre) {
  const dressing::Wearer wearer(test::person());
  const double y = test::person().figure.crotch - 0.7;
  const double lean = 0.1, half_turn = 3.14159265358979;  // radians
  const std::vector<sewing::Placement> places{
      sewing::RigidPlacement{{-0.3, y, 0.22}, {0, 0, lean}, false},
      sewing::RigidPlacement{{0.3, y, 0.22}, {0, 0, -lean}, false},
      sewing::RigidPlacement{{-0.07, y, -0.22}, {0, half_turn, lean}, false},
      sewing::RigidPlacement{{0.07, y, -0.22}, {0, half_turn, -lean}, false}};
  const auto meshes = mesh::make_panel_meshes(test::trousers(), 0.022, {}).value();
  const sewing::Assembly assembly = sewing::assemble(meshes, places, {}).value();
  const auto on = dressing::put_on(assembly, assembly, wearer, {}).on;
  ASSERT_TRUE(on.has_value());
  EXPECT_LT(on->certificate.shrink_p99, 0.25) << "way " << on->number;
}

TEST(PutOn, TheSameInputGivesTheSameBytes) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = placed(top(), 0.022, top_height());
  EXPECT_EQ(dressing::put_on(assembly, assembly, wearer, {}).on->positions,
            dressing::put_on(assembly, assembly, wearer, {}).on->positions);
}

TEST(PutOn, AFinerMeshTakesOverTheShapeAndIsCertifiedItself) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly coarse = placed(top(), 0.022, top_height()),
                         fine = placed(top(), 0.013, top_height());
  const auto on = dressing::put_on(fine, coarse, wearer, {}).on;
  ASSERT_TRUE(on.has_value());
  EXPECT_EQ(on->positions.size(), fine.positions.size());
  EXPECT_TRUE(on->certificate.holds());
}

/// A tube of 240 mm, which is no garment for a trunk.
pattern::Pattern narrow() {
  pattern::Pattern p;
  const std::vector<Vec2> corners{{-60, 0}, {60, 0}, {60, 300}, {-60, 300}};
  p.panels = {test::polygon("front", corners), test::polygon("back", corners)};
  p.seams = {test::seam("left", {{0, 1}}, {{1, 3}}), test::seam("right", {{0, 3}}, {{1, 1}})};
  return p;
}

TEST(PutOn, ATopThatIsFarTooSmallIsOnAndStrained) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = placed(top(0.55), 0.022, top_height());
  const auto on = dressing::put_on(assembly, assembly, wearer, {}).on;
  ASSERT_TRUE(on.has_value());
  EXPECT_TRUE(on->certificate.holds_strained());
  EXPECT_FALSE(on->certificate.holds());
  EXPECT_TRUE(on->certificate.crossings.none());
}

TEST(Certificate, StretchAlonePartsWhatIsOnFromWhatIsStrained) {
  dressing::Certificate c;
  EXPECT_TRUE(c.holds());
  c.stretch_p99 = 0.6;
  EXPECT_FALSE(c.holds());
  EXPECT_TRUE(c.holds_strained());
  c.stretch_p99 = 1.5;
  EXPECT_FALSE(c.holds_strained());
}

TEST(PutOn, WhatCannotGoAroundTheBodyIsNotCertified) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = placed(narrow(), 0.022, test::person().figure.waist - 0.15);
  EXPECT_FALSE(dressing::put_on(assembly, assembly, wearer, {}).on.has_value());
}

TEST(PutOn, WhereTheEffortIsSpentOneWayIsTriedAndThatItWasGivenUpIsTold) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = placed(narrow(), 0.022, test::person().figure.waist - 0.15);
  const dressing::TriedOn short_of_work =
      dressing::put_on(assembly, assembly, wearer, {}, 0, dressing::Effort(1));
  EXPECT_FALSE(short_of_work.on.has_value());
  EXPECT_TRUE(short_of_work.gave_up);
  EXPECT_TRUE(short_of_work.effort.spent());
  EXPECT_FALSE(dressing::put_on(assembly, assembly, wearer, {}).gave_up) << "all ways were tried";
}

TEST(PutOn, ACancelledTryGivesNothing) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = placed(top(), 0.022, top_height());
  std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  EXPECT_FALSE(dressing::put_on(assembly, assembly, wearer, context).on.has_value());
}

}  // namespace
}  // namespace toile
