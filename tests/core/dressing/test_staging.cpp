// Where pieces begin: a dress with half discs for a skirt, before and behind the sample's mannequin.

#include "core/dressing/staging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/dressing/cut_on_sleeves.h"
#include "core/dressing/put_on.h"
#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

constexpr int kArc = 12;  // edges of each arc

/// Edges: hem from left to right, right side, waist from right to left, left side; mm.
std::vector<Vec2> half_disc(double waist, double hem) {
  std::vector<Vec2> corners;
  const auto at = [&](double radius, int k) {
    const double angle = std::numbers::pi * (1 + static_cast<double>(k) / kArc);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  };
  for (int k = 0; k <= kArc; ++k) at(hem, k);
  for (int k = kArc; k >= 0; --k) at(waist, k);
  return corners;
}

pattern::Pattern plain_top() {
  pattern::Pattern p;
  const std::vector<Vec2> corners{{-220, 0}, {220, 0},   {240, 280}, {190, 420},  {190, 500},  {90, 500},
                                  {90, 380}, {-90, 380}, {-90, 500}, {-190, 500}, {-190, 420}, {-240, 280}};
  p.panels = {test::polygon("front", corners), test::turned_over("back", corners)};
  for (const Index e : {1, 4, 8, 11})
    p.seams.push_back(test::seam("s" + std::to_string(e), {{0, e}}, {{1, 11 - e}}));
  return p;
}

pattern::Pattern circle_dress() {
  pattern::Pattern p = plain_top();
  const std::vector<Vec2> disc = half_disc(140, 800);
  const auto last = static_cast<Index>(disc.size()) - 1;
  p.panels.push_back(test::polygon("skirt_front", disc));
  p.panels.push_back(test::turned_over("skirt_back", disc));
  p.seams.push_back(test::seam("right", {{2, kArc}}, {{3, last - kArc}}));
  p.seams.push_back(test::seam("left", {{2, last}}, {{3, 0}}));
  pattern::Seam front = test::seam("waist_front", {}, {{0, 0}}),
                back = test::seam("waist_back", {}, {{1, 11}});
  for (Index e = kArc + 1; e < last; ++e) front.a.push_back({2, e});
  for (Index e = 1; e < last - kArc; ++e) back.a.push_back({3, e});
  p.seams.push_back(front);
  p.seams.push_back(back);
  return p;
}

/// `below`: m from the shoulders to where the first two pieces are drawn from; `spacing`: m.
sewing::Assembly placed(const pattern::Pattern& p, double below = 0.5, double spacing = 0.03) {
  const auto meshes = mesh::make_panel_meshes(p, spacing, {}).value();
  const double height = test::person().figure.shoulder[0].y - below;
  std::vector<sewing::Placement> places;
  for (std::size_t k = 0; k < p.panels.size(); k += 2) {
    places.push_back(sewing::RigidPlacement{{0, height, 0.22}, {}, false});
    places.push_back(sewing::RigidPlacement{{0, height, -0.22}, {0, std::numbers::pi, 0}, false});
  }
  return sewing::assemble(meshes, places, {}).value();
}

TEST(Staging, APanelBesideTheTrunkIsNoSleeve) {
  const measure::BodyFigure& figure = test::person().figure;
  const measure::ArmLine& arm = figure.arm[0];
  const double armpit = figure.armpit[0].x;
  pattern::Pattern p;
  p.panels = {test::polygon("side", {{-70, -220}, {70, -220}, {70, 220}, {-70, 220}}),
              test::polygon("sleeve", {{-150, -90}, {150, -90}, {150, 90}, {-150, 90}})};
  const auto meshes = mesh::make_panel_meshes(p, 0.03, {}).value();
  const Vec3 on_arm = (arm.root + arm.wrist) * 0.5;
  const sewing::Assembly placed =
      sewing::assemble(meshes,
                       {sewing::RigidPlacement{{armpit + 0.05, figure.armpit[0].y - 0.25, 0.2}, {}, false},
                        sewing::RigidPlacement{{on_arm.x, on_arm.y, 0.1}, {}, false}},
                       {})
          .value();
  const std::vector<dressing::Covers> covers = dressing::covers_of(placed, figure);
  EXPECT_EQ(covers[0], dressing::Covers::kTrunk) << "it lies flat beyond the armpit, and near the arm";
  EXPECT_EQ(covers[1], dressing::Covers::kArm);
}

TEST(Staging, ACollarStaysUnderTheChinWhereTheTrunkIsLifted) {
  const measure::BodyFigure& f = test::person().figure;
  pattern::Pattern p = plain_top();
  p.panels.push_back(test::polygon("collar", {{0, 0}, {400, 0}, {400, 30}, {0, 30}}));
  const auto meshes = mesh::make_panel_meshes(p, 0.03, {}).value();
  const double height = f.shoulder[0].y - 0.5, low = f.chin - 0.05;
  const sewing::WrappedPlacement around{{f.middle, 0, 0}, 0.065, 0, low, {0.2, 0}};
  const sewing::Assembly assembly =
      sewing::assemble(meshes,
                       {sewing::RigidPlacement{{0, height, 0.22}, {}, false},
                        sewing::RigidPlacement{{0, height, -0.22}, {0, std::numbers::pi, 0}, false}, around},
                       {})
          .value();
  const auto covers = dressing::covers_of(assembly, f);
  ASSERT_EQ(covers[2], dressing::Covers::kNeck);
  dressing::Staging staging;
  staging.lift = 0.12;
  const std::vector<Vec3> x = dressing::staged(assembly, covers, f, staging);
  double high = -1;
  for (Index v = assembly.garment.first_vertex[2]; v < assembly.garment.first_vertex[3]; ++v)
    high = std::max(high, x[v].y);
  EXPECT_NEAR(high, f.chin, 1e-9);
  // One that lies flat before the neck, as with a jacket's lapels, goes up with the trunk that it is sewn to.
  const sewing::Assembly flat =
      sewing::assemble(meshes,
                       {sewing::RigidPlacement{{0, height, 0.22}, {}, false},
                        sewing::RigidPlacement{{0, height, -0.22}, {0, std::numbers::pi, 0}, false},
                        sewing::RigidPlacement{{-0.2, low, 0.1}, {}, false}},
                       {})
          .value();
  ASSERT_EQ(dressing::covers_of(flat, f)[2], dressing::Covers::kNeck);
  const Index corner = flat.garment.first_vertex[2];
  EXPECT_NEAR(dressing::staged(flat, dressing::covers_of(flat, f), f, staging)[corner].y,
              flat.positions[corner].y + 0.12, 1e-12);
  EXPECT_NEAR(x[0].y, assembly.positions[0].y + 0.12, 1e-12);
}

TEST(Staging, AWideSkirtIsFoldedDownInsideTheHandsAsLongAsItIs) {
  const measure::BodyFigure& figure = test::person().figure;
  const sewing::Assembly dress = placed(circle_dress());
  const std::vector<dressing::Covers> covers = dressing::covers_of(dress, figure);
  ASSERT_EQ(covers[2], dressing::Covers::kBelow);
  const dressing::Staging folded{0, 0, true, false, dressing::Wide::kFolded};
  const std::vector<Vec3> x = dressing::staged(dress, covers, figure, folded);
  const double hands = std::min(figure.arm[0].tip.y, figure.arm[1].tip.y);
  double out_before = 0, out = 0;
  const double waist = figure.shoulder[0].y - 0.5;
  for (Index v = dress.garment.first_vertex[2]; v < dress.garment.first_vertex[4]; ++v) {
    EXPECT_LE(x[v].y, waist + 1e-9) << "nothing is turned up";
    if (dress.positions[v].y > hands) out_before = std::max(out_before, std::abs(dress.positions[v].x));
    if (x[v].y > hands) out = std::max(out, std::abs(x[v].x));
    if (std::abs(dress.garment.rest[v].x) < 1e-9) {
      EXPECT_NEAR(x[v].x, 0, 1e-9) << "the middle stays there";
    }
  }
  EXPECT_GT(out_before, std::abs(figure.arm[0].wrist.x)) << "the hands are in its way";
  EXPECT_LT(out, std::abs(figure.arm[0].wrist.x));
  const auto longest = [&](std::span<const Vec3> at) {
    double low = HUGE_VAL;
    for (const Vec3 p : at) low = std::min(low, p.y);
    return low;
  };
  EXPECT_NEAR(longest(x), longest(dress.positions), 1e-6) << "as long as it is";
}

/// A top whose sleeves are cut on, straight out from the shoulder to `wrist`, `length` long; mm.
pattern::Pattern t_shape(double wrist, double length) {
  const double arm = length - 220;
  pattern::Pattern p;
  const std::vector<Vec2> corners{
      {-260, 0},          {260, 0},          {240, arm},         {wrist, arm + 30}, {wrist, length - 40},
      {90, length},       {60, length - 60}, {-60, length - 60}, {-90, length},     {-wrist, length - 40},
      {-wrist, arm + 30}, {-240, arm}};
  p.panels = {test::polygon("front", corners), test::turned_over("back", corners)};
  for (const Index e : {1, 2, 4, 8, 10, 11})
    p.seams.push_back(test::seam("s" + std::to_string(e), {{0, e}}, {{1, 11 - e}}));
  return p;
}

TEST(Staging, SleevesThatAreCutOnAreToldFromWideSkirts) {
  const measure::BodyFigure& f = test::person().figure;
  EXPECT_TRUE(dressing::has_cut_on_sleeves(placed(t_shape(600, 600)), 0, f));
  EXPECT_FALSE(dressing::has_cut_on_sleeves(placed(plain_top()), 0, f));
  const sewing::Assembly dress = placed(circle_dress());
  for (const std::size_t piece : {0, 2}) EXPECT_FALSE(dressing::has_cut_on_sleeves(dress, piece, f));
  const sewing::Assembly tunic = placed(t_shape(450, 900));
  EXPECT_EQ(dressing::covers_of(tunic, f, dressing::CutOn::kAlongFreeArms)[0], dressing::Covers::kTrunk)
      << "however long it is";
}

TEST(Staging, SleevesThatAreCutOnBeginAlongTheArms) {
  const measure::BodyFigure& f = test::person().figure;
  const sewing::Assembly top = placed(t_shape(600, 600));
  dressing::Staging staging;
  staging.sleeves = dressing::CutOn::kAlongArms;
  const std::vector<Vec3> x = dressing::staged(top, dressing::covers_of(top, f), f, staging);
  Vec3 hand;
  int count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double aside = top.positions[i].x - f.middle;
    if (std::abs(aside) < 0.1) {
      EXPECT_EQ(x[i], top.positions[i]) << "the trunk stays";
    }
    if (aside < 0.595) continue;
    hand += x[i];
    ++count;
  }
  ASSERT_GT(count, 2);
  const measure::ArmLine& arm = f.arm[0];
  const Vec3 out = hand * (1.0 / count) - arm.root;
  EXPECT_LT(std::abs(out.x * arm.along().y - out.y * arm.along().x), 0.05)
      << "on the arm's line, seen from before";
}

TEST(Staging, ATShapeIsPutOnWithItsSleevesAroundTheArms) {
  const dressing::Wearer wearer(test::person());
  constexpr double kOwnMesh = 0.02;  // m, by which garments are put on
  for (const double length : {600.0, 800.0}) {
    const dressing::Dressed on = dressing::dress(placed(t_shape(520, length), length * 1e-3 - 0.03, kOwnMesh),
                                                 wearer, dressing::dressing_ways()[0], {});
    EXPECT_TRUE(on.certificate.holds())
        << length << ": stretched by " << on.certificate.stretch_p99 << ", " << on.certificate.crossings.all()
        << " crossings, gap " << on.certificate.gap << ", out " << on.certificate.faces_out;
    EXPECT_EQ(on.certificate.rings.size(), 4U);
    EXPECT_EQ(on.certificate.wrong_rings(), 0) << length;
  }
}

/// A back, two fronts and a band that goes down the one, around the neck and up the other; 20 mm broad and
/// `band` long, mm.
pattern::Pattern open_front(double band) {
  pattern::Pattern p;
  p.panels = {test::polygon("back", {{-240, 0},
                                     {240, 0},
                                     {220, 400},
                                     {180, 600},
                                     {80, 620},
                                     {-80, 620},
                                     {-180, 600},
                                     {-220, 400},
                                     {-240, 100}}),
              test::polygon("left", {{5, 0}, {240, 0}, {220, 400}, {180, 600}, {80, 620}, {5, 450}}),
              test::polygon("right", {{-240, 0}, {-5, 0}, {-5, 450}, {-80, 620}, {-180, 600}, {-220, 400}}),
              test::polygon("band", {{0, 0}, {band, 0}, {band, 20}, {0, 20}})};
  p.seams = {test::seam("shoulder_l", {{0, 6}}, {{1, 3}}), test::seam("shoulder_r", {{0, 3}}, {{2, 3}}),
             test::seam("around", {{3, 0}}, {{2, 1}, {2, 2}, {0, 4}, {1, 4}, {1, 5}})};
  return p;
}

TEST(Staging, ALongBandBeginsOnTheStitchesThatHoldIt) {
  const measure::BodyFigure& f = test::person().figure;
  const double y = f.shoulder[0].y - 0.6;
  const pattern::Pattern p = open_front(1430);
  const auto meshes = mesh::make_panel_meshes(p, 0.03, {}).value();
  const sewing::RigidPlacement front{{0, y, 0.2}, {}, false};
  const sewing::RigidPlacement back{{0, y, -0.2}, {0, std::numbers::pi, 0}, false};
  sewing::WrappedPlacement around;
  around.radius = 0.24;
  around.height = f.neck;
  const auto a = sewing::assemble(meshes, {back, front, front, around}, {}).value();
  const std::vector<Vec3> x = dressing::staged(a, dressing::covers_of(a, f), f, {});
  int sewn = 0;
  for (const auto& [i, j] : a.garment.sewn) {
    if (a.garment.panel_of_vertex[i] != 3 && a.garment.panel_of_vertex[j] != 3) continue;
    EXPECT_LT(length(x[i] - x[j]), 0.25) << "in the corner between two pieces it lies between them";
    sewn += length(x[i] - x[j]) < 1e-9;
  }
  EXPECT_GT(sewn, 30);
  for (Index v = a.garment.first_vertex[3]; v < a.garment.first_vertex[4]; ++v)
    EXPECT_LT(std::abs(x[v].z), 0.216) << "the free side lies close to what it is sewn to";
}

TEST(Staging, FoldingIsNoOtherWayWhereNothingIsWide) {
  const dressing::Wearer wearer(test::person());
  dressing::DressingWay smaller, folded;
  folded.staging.below = dressing::Wide::kFolded;
  EXPECT_TRUE(dressing::same_way(placed(plain_top()), wearer, smaller, folded));
  EXPECT_FALSE(dressing::same_way(placed(circle_dress()), wearer, smaller, folded));
}

TEST(Staging, MoreGiveIsAnotherWay) {
  const dressing::Wearer wearer(test::person());
  dressing::DressingWay little, much;
  much.give = {1.2, 1.04};
  EXPECT_FALSE(dressing::same_way(placed(plain_top()), wearer, little, much));
}

TEST(Staging, ACircleDressIsPutOnByFoldingItsSkirt) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly dress = placed(circle_dress());
  const dressing::DressingWay& way = dressing::dressing_ways()[2];
  ASSERT_EQ(way.staging.below, dressing::Wide::kFolded);
  const dressing::Dressed on = dressing::dress(dress, wearer, way, {});
  EXPECT_TRUE(on.certificate.holds());
  EXPECT_LT(on.certificate.shrink_p99, 0.4) << "hardly squeezed";
}

}  // namespace
}  // namespace toile
