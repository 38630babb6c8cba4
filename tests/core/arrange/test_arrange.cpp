#include "core/arrange/arrange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/arrange/flat_move.h"
#include "core/arrange/garment_graph.h"
#include "core/arrange/piece_image.h"
#include "core/body/measure/landmarks.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/sewing/assembly.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/arrange/started.h"

namespace toile {
namespace {

using namespace test;

TEST(Arrange, ASkirtStandsAroundTheHipsWithItsBandAtTheWaist) {
  const Start s = started(test::skirt());
  expect_clean(s);
  EXPECT_GT(centre_of(s, 0).z, 0.1) << "the front before the body";
  EXPECT_LT(centre_of(s, 1).z, -0.1) << "the back behind it";
  EXPECT_GT(centre_of(s, 2).y, centre_of(s, 0).y) << "the band over the skirt";
  EXPECT_NEAR(centre_of(s, 2).y, figure().waist, 0.06);
  EXPECT_LT(longest_thread(s), 0.5);
  const auto all = rings(s.assembly.garment);
  ASSERT_EQ(all.size(), 2u);
  for (const auto& ring : all) EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
}

TEST(Arrange, ASkirtsBandIsHeldAtItsHeight) {
  const Start s = started(test::skirt());
  ASSERT_EQ(s.made.attachments.size(), 2u);
  for (const sewing::Attachment& a : s.made.attachments) {
    EXPECT_EQ(a.hold, sewing::Attachment::Hold::kHeight);
    EXPECT_TRUE(a.panel == 2 || a.panel == 3);
  }
}

TEST(Arrange, SleevesGoAroundTheArmsThatTheirSeamsLeadTo) {
  const Start s = started(test::shirt());
  expect_clean(s);
  EXPECT_TRUE(s.made.attachments.empty()) << "shoulders carry a shirt";
  EXPECT_GT(centre_of(s, 2).x, 0.15) << "sewn to the front's right edges: the wearer's left";
  EXPECT_LT(centre_of(s, 3).x, -0.15);
  const auto all = rings(s.assembly.garment);
  ASSERT_EQ(all.size(), 4u) << "hem, neck and two cuffs";
  int cuffs = 0;
  for (const auto& ring : all) {
    const bool body = has_panel(s, ring, 0);
    if (body) {
      EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
      continue;
    }
    const measure::ArmLine& arm =
        figure().arm[has_panel(s, ring, 2) ? measure::kWearersLeft : measure::kWearersRight];
    EXPECT_EQ(std::abs(winding(s, ring, arm.root, arm.along())), 1);
    ++cuffs;
  }
  EXPECT_EQ(cuffs, 2);
}

/// A narrow end on a cylinder that is as wide as the upper arm would be a flat strip beside the wrist.
TEST(Arrange, ASleeveThatTapersCoversAsMuchOfTheArmAtTheHand) {
  pattern::Pattern pattern = test::shirt();
  const std::vector<Vec2> narrow{{-85, -250}, {85, -250}, {175, 90}, {0, 235}, {-175, 90}};
  pattern.panels[2] = polygon("sleeve_a", narrow);
  pattern.panels[3] = polygon("sleeve_b", narrow);
  const Start s = started(pattern);
  expect_clean(s);
  const sewing::GarmentMesh& g = s.assembly.garment;
  for (const int seam : {4, 5}) {
    std::vector<double> gaps;
    for (std::size_t k = 0; k < g.sewn.size(); ++k)
      if (g.seam_of_sewn[k] == seam)
        gaps.push_back(length(s.assembly.positions[g.sewn[k][0]] - s.assembly.positions[g.sewn[k][1]]));
    ASSERT_GT(gaps.size(), 4U);
    const double ratio = gaps.front() / gaps.back();
    EXPECT_NEAR(std::max(ratio, 1 / ratio), 350.0 / 170.0, 0.25) << "open by as much of its breadth";
  }
}

TEST(Arrange, SymmetricPartnersStandAsMirrorImages) {
  const Start s = started(test::shirt());
  const Vec3 left = centre_of(s, 2), right = centre_of(s, 3);
  EXPECT_NEAR(left.x - figure().middle, figure().middle - right.x, 2e-3);
  EXPECT_NEAR(left.y, right.y, 2e-3);
  EXPECT_NEAR(left.z, right.z, 2e-3);
  EXPECT_NEAR(centre_of(s, 0).x, figure().middle, 2e-3);
}

TEST(MirrorPartner, IsTheSleeveOnTheOtherSideAndNeverTheBackOfAFront) {
  const auto partners = [](const pattern::Pattern& pattern) {
    const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
    const arrange::GarmentGraph graph = arrange::make_garment_graph(pattern, meshes);
    std::map<std::string, std::string> out;
    for (Index p = 0; p < static_cast<Index>(graph.pieces.size()); ++p) {
      const Index q = arrange::mirror_partner(graph, p);
      out[graph.pieces[p].id] = q == kNone ? "" : graph.pieces[q].id;
    }
    return out;
  };
  for (const auto& [piece, partner] : partners(test::skirt())) EXPECT_EQ(partner, "") << piece;
  for (const auto& [piece, partner] : partners(test::gored_skirt())) EXPECT_EQ(partner, "") << piece;
  pattern::Pattern unnamed = test::skirt();
  for (std::size_t p = 0; p < unnamed.panels.size(); ++p) unnamed.panels[p].id = "p" + std::to_string(p);
  for (const auto& [piece, partner] : partners(unnamed)) EXPECT_EQ(partner, "") << piece;
  const auto shirt = partners(test::shirt());
  int pairs = 0;
  for (const auto& [piece, partner] : shirt) {
    if (partner.empty()) continue;
    ++pairs;
    EXPECT_NE(partner, piece);
    EXPECT_EQ(shirt.at(partner), piece);
  }
  EXPECT_EQ(pairs, 2) << "the two sleeves";
}

TEST(Arrange, WithoutNamesFrontAndBackAreToldBySeams) {
  const Start s = started(test::shirt("piece1", "piece2"));
  expect_clean(s);
  EXPECT_LT(centre_of(s, 0).z * centre_of(s, 1).z, 0) << "one before and one behind the body";
  for (const auto& ring : rings(s.assembly.garment)) {
    if (!has_panel(s, ring, 0)) continue;
    EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
  }
}

TEST(Arrange, AGarmentDrawnLyingStandsUpAlongItsGrain) {
  pattern::Pattern pattern = test::shirt();
  for (pattern::Panel& panel : pattern.panels) {
    for (pattern::PanelEdge& edge : panel.outline.edges) {
      for (pattern::CubicBezier& c : edge.curves) {
        for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) *p = perpendicular(*p);
      }
    }
    panel.grain = perpendicular(panel.grain);
  }
  const Start s = started(pattern);
  expect_clean(s);
  const Start upright = started(test::shirt());
  for (Index p = 0; p < 4; ++p) EXPECT_LT(length(centre_of(s, p) - centre_of(upright, p)), 0.01) << p;
}

TEST(Arrange, EachTrouserLegGoesAroundItsOwnLeg) {
  const Start s = started(test::trousers());
  expect_clean(s);
  EXPECT_GT(centre_of(s, 1).x, 0.05) << "the left front on the wearer's left";
  EXPECT_LT(centre_of(s, 0).x, -0.05);
  const auto all = rings(s.assembly.garment);
  ASSERT_EQ(all.size(), 3u);
  int hems = 0;
  for (const auto& ring : all) {
    if (has_panel(s, ring, 0) && has_panel(s, ring, 1)) continue;  // the waist
    const measure::LegLine& leg =
        figure().leg[has_panel(s, ring, 1) ? measure::kWearersLeft : measure::kWearersRight];
    const measure::LegLine& other =
        figure().leg[has_panel(s, ring, 1) ? measure::kWearersRight : measure::kWearersLeft];
    EXPECT_EQ(std::abs(winding(s, ring, leg.ankle, {0, 1, 0})), 1);
    EXPECT_EQ(winding(s, ring, other.ankle, {0, 1, 0}), 0);
    ++hems;
  }
  EXPECT_EQ(hems, 2);
  EXPECT_FALSE(s.made.attachments.empty()) << "the waist is held";
}

pattern::Pattern shorts_of(const std::vector<Vec2>& front, const std::vector<Vec2>& back) {
  pattern::Pattern shorts;
  shorts.panels = {test::polygon("pant_f_r", front), test::turned_over("pant_f_l", front),
                   test::polygon("pant_b_r", back), test::turned_over("pant_b_l", back)};
  shorts.seams = test::trousers().seams;
  return shorts;
}

/// m, how far the lowest of the piece's waist lies above the highest of its hem: what of it is drawn above
/// `waist` and below `hem`.
double waist_over_hem(const Start& s, Index piece, double waist, double hem) {
  const sewing::GarmentMesh& g = s.assembly.garment;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) {
    const double y = s.assembly.positions[v].y;
    if (g.rest[v].y > waist) low = std::min(low, y);
    if (g.rest[v].y < hem) high = std::max(high, y);
  }
  return low - high;
}

/// Their crotch lies farther to the side of a leg's middle than above it.
TEST(Arrange, ShortWideTrousersStandUprightWithoutAWaistband) {
  const Start s = started(shorts_of({{0, 0}, {480, 0}, {540, 303}, {440, 520}, {40, 520}},
                                    {{0, 0}, {540, 0}, {500, 520}, {60, 520}, {-95, 303}}));
  for (Index p = 0; p < 4; ++p) EXPECT_GT(waist_over_hem(s, p, 0.519, 0.001), 0.35) << p;
}

/// Their crotch leads down past a leg's middle, so that its upper end is no farther from there than its
/// lower.
TEST(Arrange, TrunksStandUprightByTheirInnerSeams) {
  const Start s = started(shorts_of({{60, 0}, {370, -37}, {390, 45}, {280, 280}, {0, 285}},
                                    {{-20, -37}, {330, 0}, {290, 285}, {80, 285}, {-40, 45}}));
  for (Index p = 0; p < 4; ++p) EXPECT_GT(waist_over_hem(s, p, 0.279, 0.001), 0.15) << p;
}

/// m, the lowest vertex of the shoulders over the highest of the hem: of a top without sleeves or skirt, laid
/// out along the cloth with its upper end to one side.
double shoulders_over_hem(double side) {
  pattern::Pattern top = test::dress();
  top.panels.resize(2);
  top.seams.resize(4);
  const auto turn = [&](Vec2 p) { return perpendicular(p) * side; };
  for (pattern::Panel& panel : top.panels) {
    for (pattern::PanelEdge& edge : panel.outline.edges)
      for (pattern::CubicBezier& c : edge.curves) c = {turn(c.p0), turn(c.p1), turn(c.p2), turn(c.p3)};
    panel.grain = turn(panel.grain);
  }
  const Start s = started(top);
  const sewing::GarmentMesh& g = s.assembly.garment;
  double shoulders = HUGE_VAL, hem = -HUGE_VAL;
  for (Index p = 0; p < 2; ++p)
    for (Index v = g.first_vertex[p]; v < g.first_vertex[p + 1]; ++v) {
      const double along = dot(g.rest[v], top.panels[p].grain), y = s.assembly.positions[v].y;
      if (along > 0.38) shoulders = std::min(shoulders, y);
      if (along < 0.001) hem = std::max(hem, y);
    }
  return shoulders - hem;
}

/// No seam leads up or down: the grain tells.
TEST(Arrange, ATopThatIsLaidOutAlongTheClothStandsUpright) {
  for (const double side : {1.0, -1.0}) {
    EXPECT_GT(shoulders_over_hem(side), 0.2) << side;
    EXPECT_LT(shoulders_over_hem(side), 1) << side;
  }
}

/// m, middle of the piece's lowest 6 cm: hems slant.
Vec3 hem_of(const Start& s, Index piece) {
  const sewing::GarmentMesh& g = s.assembly.garment;
  const auto from = s.assembly.positions.begin() + g.first_vertex[piece],
             to = s.assembly.positions.begin() + g.first_vertex[piece + 1];
  const double low = std::min_element(from, to, [](Vec3 a, Vec3 b) { return a.y < b.y; })->y;
  Vec3 sum;
  int count = 0;
  for (auto p = from; p != to; ++p) {
    if (p->y > low + 0.06) continue;
    sum += *p;
    ++count;
  }
  return sum * (1.0 / count);
}

TEST(Arrange, WideFrillsOfTrousersHangUnderTheirLegsOneBeforeTheOther) {
  pattern::Pattern pattern = test::trousers();
  const std::vector<Vec2> frill{{-300, -100}, {300, -100}, {150, 0}, {-150, 0}};
  pattern.panels.push_back(test::polygon("right_cuff_skirt_front", frill));
  pattern.panels.push_back(test::turned_over("left_cuff_skirt_front", frill));
  pattern.seams.push_back(test::seam("right_frill", {{4, 2}}, {{0, 0}}));
  pattern.seams.push_back(test::seam("left_frill", {{5, 1}}, {{1, 4}}));
  const Start s = started(pattern);
  EXPECT_NEAR(centre_of(s, 4).x, hem_of(s, 0).x, 0.08);
  EXPECT_NEAR(centre_of(s, 5).x, hem_of(s, 1).x, 0.08);
  EXPECT_GT(std::abs(centre_of(s, 4).z - centre_of(s, 5).z), 0.01) << "they are too wide to lie side by side";
  for (const Index frill_piece : {4, 5}) EXPECT_GT(centre_of(s, frill_piece).z, centre_of(s, 0).z + 0.01);
}

/// Trousers with a cuff on each leg piece and a frill on the cuff: pieces 4 + 2k and 5 + 2k for the legs 0,
/// 2, 1, 3. Cuffs are alike both ways up, and the left ones sewn by what is the right ones' lower edge.
pattern::Pattern cuffed_trousers() {
  pattern::Pattern pattern = test::trousers();
  const std::vector<Vec2> cuff{{0, 0}, {160, 0}, {160, 30}, {0, 30}};
  const std::vector<Vec2> frill{{-250, -120}, {250, -120}, {80, 0}, {-80, 0}};
  for (const bool left : {false, true}) {
    for (const bool back : {false, true}) {
      const auto piece = static_cast<Index>(pattern.panels.size());
      const std::string name = std::string(left ? "left" : "right") + (back ? "_back" : "_front");
      pattern.panels.push_back(test::polygon(name + "_cuff", cuff));
      pattern.panels.push_back(test::polygon(name + "_cuff_frill", frill));
      const Index leg = left + 2 * back, at_leg = left ? 0 : 2;
      pattern.seams.push_back(test::seam(name + "_hem", {{piece, at_leg}}, {{leg, left ? 4 : 0}}));
      pattern.seams.push_back(test::seam(name + "_frill", {{piece, 2 - at_leg}}, {{piece + 1, 2}}));
    }
  }
  return pattern;
}

TEST(Arrange, CuffsLieAtTheirLegsAndFrillsUnderThem) {
  const Start s = started(cuffed_trousers());
  const sewing::GarmentMesh& g = s.assembly.garment;
  for (Index k = 0; k < 4; ++k) {
    const Index leg = k / 2 + 2 * (k % 2), cuff = 4 + 2 * k, frill = cuff + 1;
    EXPECT_LT(centre_of(s, cuff).y, centre_of(s, leg).y - 0.2) << k;
    EXPECT_LT(centre_of(s, frill).y, centre_of(s, cuff).y - 0.02) << k;
    EXPECT_NEAR(centre_of(s, frill).x, centre_of(s, cuff).x, 0.03) << k;
    const auto from = s.assembly.positions.begin() + g.first_vertex[frill],
               to = s.assembly.positions.begin() + g.first_vertex[frill + 1];
    const auto [low, high] = std::minmax_element(from, to, [](Vec3 a, Vec3 b) { return a.y < b.y; });
    EXPECT_LT(high->y - low->y, 0.2) << k << ": it stands on its end";
  }
}

TEST(ImageOn, StripsThatLieOnEachOtherBothWaysUpDoSoByTheirSeams) {
  const pattern::Pattern pattern = cuffed_trousers();
  const auto meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  const arrange::GarmentGraph graph = arrange::make_garment_graph(pattern, meshes);
  constexpr Index kRightCuff = 4, kLeftCuff = 8;
  const auto onto = arrange::image_on(graph, kLeftCuff, kRightCuff);
  ASSERT_TRUE(onto);
  EXPECT_TRUE(onto->mirrored);
  EXPECT_NEAR((*onto)({0.05, 0}).y, 0.03, 1e-4) << "the edges at the legs";
  EXPECT_NEAR((*onto)({0.05, 0.03}).y, 0, 1e-4) << "the edges at the frills";
  EXPECT_FALSE(arrange::image_on(graph, kLeftCuff, 0));
}

TEST(Arrange, HalvesOfABodiceThatAreNoImagesStandBesideEachOtherOverTheirBand) {
  pattern::Pattern pattern;
  const std::vector<Vec2> low{{0, 0}, {250, 0}, {250, 250}, {170, 420}, {80, 450}};
  const std::vector<Vec2> high{{0, 0}, {250, 0}, {250, 250}, {170, 420}, {60, 450}, {0, 330}};
  const auto drawn_at = [](std::vector<Vec2> corners, double x) {
    for (Vec2& p : corners) p.x += x;
    return corners;
  };
  const std::vector<Vec2> band{{0, 0}, {500, 0}, {500, 220}, {0, 220}};
  // Seen from its right side a front's left half is drawn to the right of its centre; where in the file it
  // lies says nothing.
  pattern.panels = {test::polygon("left_ftorso", drawn_at(high, 3000)),
                    test::turned_over("right_ftorso", drawn_at(low, 1000)),
                    test::turned_over("left_btorso", drawn_at(high, -2000)),
                    test::polygon("right_btorso", drawn_at(low, 500)),
                    test::polygon("wb_front", band),
                    test::polygon("wb_back", band)};
  const auto over_low = [](Index edge) { return 4 - edge; };
  const auto over_high = [](Index edge) { return 5 - edge; };
  pattern.seams = {test::seam("side_left", {{0, 1}}, {{2, over_high(1)}}),
                   test::seam("side_right", {{1, over_low(1)}}, {{3, 1}}),
                   test::seam("shoulder_left", {{0, 3}}, {{2, over_high(3)}}),
                   test::seam("shoulder_right", {{1, over_low(3)}}, {{3, 3}}),
                   test::seam("front", {{0, 5}}, {{1, over_low(4)}}),
                   test::seam("back", {{2, over_high(5)}}, {{3, 4}}),
                   test::seam("band_left", {{4, 1}}, {{5, 3}}),
                   test::seam("band_right", {{4, 3}}, {{5, 1}}),
                   test::seam("waist_front", {{4, 2}}, {{1, over_low(0)}, {0, 0}}),
                   test::seam("waist_back", {{5, 2}}, {{2, over_high(0)}, {3, 0}})};
  const Start s = started(pattern);
  for (const Index left : {0, 2}) EXPECT_NEAR(centre_of(s, left).x - figure().middle, 0.125, 0.05);
  for (const Index right : {1, 3}) EXPECT_NEAR(centre_of(s, right).x - figure().middle, -0.125, 0.05);
  for (Index k = 0; k < 4; ++k) {
    EXPECT_EQ(centre_of(s, k).z > centre_of(s, 4).z - 0.01, k < 2);
    EXPECT_GT(centre_of(s, k).y, centre_of(s, 4).y + 0.1);
    EXPECT_NEAR(centre_of(s, k).y, centre_of(s, 0).y, 0.05);
  }
}

TEST(Arrange, EqualGoresWithoutNamesGoOnceAroundTheHips) {
  const Start s = started(test::gored_skirt());
  expect_clean(s);
  const auto all = rings(s.assembly.garment);
  ASSERT_EQ(all.size(), 2u);
  for (const auto& ring : all) EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
  EXPECT_LT(longest_thread(s), 0.5);
}

TEST(Arrange, WedgesStandAroundTheHipsEachBesideTheNext) {
  const Start s = started(test::wedge_skirt());
  const auto all = rings(s.assembly.garment);
  ASSERT_EQ(all.size(), 2u);
  for (const auto& ring : all) EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
  for (Index k = 0; k < 14; ++k) {
    EXPECT_LT(centre_of(s, k).y, figure().waist);
    EXPECT_EQ(centre_of(s, k).z > 0, k < 7) << "those of the front band before the body";
  }
}

TEST(Arrange, ATopWithoutStrapsStandsBelowTheArms) {
  const Start s = started(test::strapless());
  expect_clean(s);
  for (const Vec3 p : s.assembly.positions) EXPECT_LT(p.y, figure().armpit[0].y);
  EXPECT_GT(centre_of(s, 0).y + 0.2, figure().waist + 0.05) << "its upper edge";
}

TEST(Arrange, StrapsComeOverTheShouldersAndTheSidesBelowTheArms) {
  pattern::Pattern pattern = test::strapless();
  const double top = centre_of(started(pattern), 0).y;
  for (const bool left : {true, false}) {
    const Index strap = static_cast<Index>(pattern.panels.size());
    pattern.panels.push_back(
        test::polygon(left ? "strap_l" : "strap_r", {{0, 0}, {12, 0}, {12, 300}, {0, 300}}));
    const double from = left ? 0.7 : 0.27, to = from + 0.03;
    pattern.seams.push_back(
        test::seam(left ? "front_l" : "front_r", {{0, 2, false, from, to}}, {{strap, 2}}));
    pattern.seams.push_back(
        test::seam(left ? "back_l" : "back_r", {{1, 2, false, 1 - to, 1 - from}}, {{strap, 0}}));
  }
  const Start s = started(pattern);
  // The start with the fewest faults may lie a few centimetres lower; a strap's length is 30.
  EXPECT_NEAR(centre_of(s, 0).y, top, 0.1) << "as high as without straps";
  EXPECT_GT(centre_of(s, 2).y, figure().armpit[0].y) << "a strap stands above it";
}

TEST(Arrange, ABandAtTheHemOfATopHangsBelowIt) {
  pattern::Pattern pattern = test::shirt();
  const Index band = static_cast<Index>(pattern.panels.size());
  pattern.panels.push_back(test::polygon("hem band", {{0, 0}, {960, 0}, {960, 70}, {0, 70}}));
  pattern.seams.push_back(test::seam("closes", {{band, 1}}, {{band, 3}}));
  pattern.seams.push_back(test::seam("hem", {{0, 0}, {1, 0}}, {{band, 2}}));
  const Start s = started(pattern);
  const sewing::GarmentMesh& g = s.assembly.garment;
  double hem = HUGE_VAL, top = -HUGE_VAL;
  for (Index v = 0; v < g.vertex_count(); ++v) {
    const double y = s.assembly.positions[v].y;
    if (g.panel_of_vertex[v] < 2) hem = std::min(hem, y);
    if (g.panel_of_vertex[v] == band) top = std::max(top, y);
  }
  EXPECT_LE(top, hem) << "around the trunk, and around no arm";
  EXPECT_NEAR(centre_of(s, band).x, figure().middle, 0.06) << "open at a side until it is sewn";
}

TEST(Arrange, LapelsLieBeforeFrontsThatStayTogether) {
  pattern::Pattern pattern = test::shirt();
  pattern.panels.push_back(test::polygon("collar_front", {{-60, 0}, {60, 0}, {60, 300}, {-60, 300}}));
  pattern.seams.push_back(test::seam("lapel", {{4, 2}}, {{0, 4}}));
  const Start without = started(test::shirt()), with = started(pattern);
  EXPECT_NEAR(centre_of(with, 0).x, centre_of(without, 0).x, 1e-3);
  EXPECT_GT(centre_of(with, 4).z, centre_of(with, 0).z + 0.02);
}

TEST(Arrange, WhatHangsOnASleevesCuffGoesToThatArm) {
  pattern::Pattern pattern = test::shirt();
  pattern.panels.push_back(test::polygon("cuff_skirt", {{-250, -120}, {250, -120}, {165, 0}, {-165, 0}}));
  pattern.seams.push_back(test::seam("frill", {{4, 2}}, {{2, 0}}));
  const Start s = started(pattern);
  ASSERT_TRUE(s.made.placements.size() == 5);
  EXPECT_LT(length(centre_of(s, 4) - centre_of(s, 2)), 0.35);
  EXPECT_GT(std::abs(centre_of(s, 4).x), figure().armpit[0].x);
}

TEST(Arrange, ADressHangsFromItsShouldersItsCollarAroundTheNeck) {
  const Start s = started(test::dress());
  expect_clean(s);
  EXPECT_TRUE(s.made.attachments.empty());
  EXPECT_GT(centre_of(s, 0).y, centre_of(s, 2).y + 0.3) << "the bodice over the skirt";
  EXPECT_GT(centre_of(s, 4).y, centre_of(s, 0).y + 0.1) << "the collar at the neck";
  EXPECT_LT(length(centre_of(s, 4) - figure().neck_back), 0.2);
  for (const auto& ring : rings(s.assembly.garment)) {
    if (has_panel(s, ring, 4) || has_panel(s, ring, 2)) {
      EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
    }
  }
}

TEST(Arrange, ACollarThatIsOpenInFrontLiesAroundTheNeckFromBehindTheOneOnItsStand) {
  const Start s = started(test::collared_vest());
  ASSERT_EQ(s.made.placements.size(), 5U);
  EXPECT_EQ(s.made.pieces[3].where, "collar, around the neck");
  EXPECT_EQ(s.made.pieces[4].where, "collar, around the neck");
  const Vec3 neck = figure().neck_back;
  for (const Index p : {3, 4}) {
    EXPECT_NEAR(centre_of(s, p).x, 0, 0.01);
    EXPECT_LT(centre_of(s, p).z, 0) << "its middle is behind";
    EXPECT_LT(length(centre_of(s, p) - neck), 0.2);
  }
  EXPECT_GT(centre_of(s, 4).y, centre_of(s, 3).y + 0.02) << "the collar above the stand";
  // Each end of the neck's threads is on its own side, none runs across.
  const sewing::GarmentMesh& g = s.assembly.garment;
  for (const auto& [a, b] : g.sewn) {
    if (g.panel_of_vertex[a] != 3 && g.panel_of_vertex[b] != 3) continue;
    EXPECT_GT(s.assembly.positions[a].x * s.assembly.positions[b].x, -1e-3);
    EXPECT_LT(length(s.assembly.positions[a] - s.assembly.positions[b]), 0.3);
  }
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  const collision::CrossingBody body =
      collision::make_crossing_body(mannequin().mesh.vertices, mannequin().mesh.triangles);
  EXPECT_TRUE(collision::body_crossings(surface, s.assembly.positions, body).empty());
  EXPECT_TRUE(collision::self_crossings(surface, s.assembly.positions).empty());
}

TEST(Arrange, ACollarOnAClosedStandLiesAroundTheNeckThoughAYokeIsBehind) {
  pattern::Pattern pattern = test::collared_vest();
  pattern.panels[2].id = "yoke";
  pattern.seams.push_back(test::seam("stand", {{3, 1}}, {{3, 3}}));
  const Start s = started(pattern);
  ASSERT_EQ(s.made.placements.size(), 5U);
  EXPECT_EQ(s.made.pieces[3].where, "collar, around the neck");
  EXPECT_EQ(s.made.pieces[4].where, "collar, around the neck");
}

TEST(Arrange, ACollarThatIsOpenInFrontLiesAroundTheNeckFromBehindAYokeThatNoNamePutsThere) {
  pattern::Pattern pattern = test::collared_vest();
  pattern.panels[2].id = "yoke";
  const Start s = started(pattern);
  ASSERT_EQ(s.made.placements.size(), 5U);
  for (const Index p : {3, 4}) {
    EXPECT_EQ(s.made.pieces[static_cast<std::size_t>(p)].where, "collar, around the neck");
    EXPECT_LT(centre_of(s, p).z, 0) << "its middle is behind, as the yoke is: " << s.made.pieces[2].where;
  }
}

TEST(Arrange, YokesOfASkirtAreOfTheSkirt) {
  pattern::Pattern pattern = test::skirt();
  pattern.panels[2].id = "front yoke";
  pattern.panels[3].id = "back yoke";
  const Start s = started(pattern);
  for (const std::size_t p : {std::size_t{2}, std::size_t{3}})
    EXPECT_EQ(s.made.pieces[p].where.substr(0, 5), "skirt") << s.made.pieces[p].where;
  EXPECT_LT(centre_of(s, 2).y, figure().waist + 0.1);
}

TEST(Arrange, EqualTiersThatAreSewnAtBothSidesStandBeforeAndBehind) {
  pattern::Pattern pattern;
  const auto tier = [](const std::string& id, double width) {
    return test::polygon(id, {{0, 0}, {width, 0}, {width, 200}, {0, 200}});
  };
  pattern.panels = {tier("1A", 500), tier("1B", 500), tier("2A", 620), tier("2B", 620)};
  pattern.seams = {
      test::seam("left", {{0, 1}}, {{1, 3}}),       test::seam("right", {{0, 3}}, {{1, 1}}),
      test::seam("lower left", {{2, 1}}, {{3, 3}}), test::seam("lower right", {{2, 3}}, {{3, 1}}),
      test::seam("front", {{2, 2}}, {{0, 0}}),      test::seam("back", {{3, 2}}, {{1, 0}})};
  const Start s = started(pattern);
  EXPECT_LT(centre_of(s, 0).z * centre_of(s, 1).z, 0);
  EXPECT_LT(centre_of(s, 2).z * centre_of(s, 3).z, 0);
  EXPECT_GT(centre_of(s, 0).z * centre_of(s, 2).z, 0) << "each below the one that it hangs from";
}

TEST(FlatMove, TheAxisOfPointsIsTheirLineHoweverDenseTheyLieOnIt) {
  const Vec2 along = normalized(Vec2{3, 1}), at{2, -1};
  std::vector<Vec2> points;
  for (int k = 0; k < 20; ++k) points.push_back(at + along * (0.01 * k));  // dense on one half
  for (int k = 1; k < 5; ++k) points.push_back(at - along * (0.05 * k));
  const arrange::PointAxes axes = arrange::axes_of(points);
  EXPECT_TRUE(axes.spread);
  EXPECT_NEAR(std::abs(dot(axes.along, along)), 1, 1e-12);
  EXPECT_FALSE(arrange::axes_of(std::vector<Vec2>{at, at}).spread);
}

/// Sews a cuff of one piece, 200 mm around, to the lower end of the shirt's sleeve 2 or 3.
void add_cuff(pattern::Pattern& pattern, Index sleeve) {
  const Index cuff = static_cast<Index>(pattern.panels.size());
  const std::string side = sleeve == 2 ? "a" : "b";
  pattern.panels.push_back(test::polygon("cuff_" + side, {{0, 0}, {200, 0}, {200, 60}, {0, 60}}));
  pattern.seams.push_back(test::seam("ends_" + side, {{cuff, 1}}, {{cuff, 3}}));
  pattern.seams.push_back(test::seam("cuff_" + side, {{sleeve, 0}}, {{cuff, 2}}));
}

TEST(Arrange, ACuffBeginsWhereItsSleeveEndsAndGoesAroundTheArm) {
  pattern::Pattern pattern = test::shirt();
  for (const Index sleeve : {2, 3}) add_cuff(pattern, sleeve);
  const Start s = started(pattern);
  for (const Index sleeve : {2, 3}) {
    const Index cuff = sleeve + 2;
    const measure::ArmLine& arm = figure().arm[centre_of(s, sleeve).x > figure().middle ? 0 : 1];
    const auto along = [&](Vec3 p) { return dot(p - arm.root, arm.along()); };
    double sleeve_ends = -1, cuff_begins = 1, around = 0;
    const sewing::GarmentMesh& g = s.assembly.garment;
    for (Index v = 0; v < g.vertex_count(); ++v) {
      const Vec3 p = s.assembly.positions[v];
      if (g.panel_of_vertex[v] == sleeve) sleeve_ends = std::max(sleeve_ends, along(p));
      if (g.panel_of_vertex[v] != cuff) continue;
      cuff_begins = std::min(cuff_begins, along(p));
      around = std::max(around, length(p - arm.root - arm.along() * along(p)));
    }
    EXPECT_GT(cuff_begins, sleeve_ends);
    EXPECT_LT(cuff_begins, sleeve_ends + 0.03);
    EXPECT_LT(around, 0.06) << "200 mm of cloth close around a wrist, not beside it";
  }
}

TEST(Arrange, ACuffEndsNearTheWristHoweverLongItsSleeve) {
  pattern::Pattern pattern = test::shirt();
  for (const Index sleeve : {2, 3}) {
    for (pattern::PanelEdge& edge : pattern.panels[static_cast<std::size_t>(sleeve)].outline.edges)
      for (pattern::CubicBezier& c : edge.curves)
        for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3})
          if (p->y < 10) p->y -= 520;
    add_cuff(pattern, sleeve);
  }
  const Start s = started(pattern);
  const sewing::GarmentMesh& g = s.assembly.garment;
  for (const Index cuff : {4, 5}) {
    const measure::ArmLine& arm = figure().arm[centre_of(s, cuff).x > figure().middle ? 0 : 1];
    double end = -HUGE_VAL;
    for (Index v = g.first_vertex[cuff]; v < g.first_vertex[cuff + 1]; ++v)
      end = std::max(end, dot(s.assembly.positions[v] - arm.root, arm.along()));
    EXPECT_NEAR(end, length(arm.wrist - arm.root) + 0.06, 0.005) << "and not beyond the hand";
  }
}

TEST(Arrange, APieceThatNoSeamLeadsToStaysWhereItIsAndIsNamed) {
  pattern::Pattern pattern = test::skirt();
  pattern.panels.insert(pattern.panels.begin(),
                        test::polygon("pocket", {{0, 0}, {100, 0}, {100, 120}, {0, 120}}));
  for (pattern::Seam& seam : pattern.seams)
    for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) ++e.panel;
  const Start s = started(pattern), without = started(test::skirt());
  EXPECT_EQ(s.made.unplaced, std::vector<Index>{0});
  const auto told = std::find_if(s.made.findings.begin(), s.made.findings.end(),
                                 [](const auto& f) { return f.kind == preflight::FindingKind::kLeftOut; });
  ASSERT_NE(told, s.made.findings.end());
  EXPECT_EQ(preflight::where_text(*told), "piece pocket");
  for (Index p = 0; p < 4; ++p) {
    EXPECT_EQ(s.made.pieces[p + 1].where, without.made.pieces[p].where);
    EXPECT_LT(length(centre_of(s, p + 1) - centre_of(without, p)), 1e-6);
  }
  ASSERT_EQ(s.made.attachments.size(), without.made.attachments.size());
  for (std::size_t k = 0; k < s.made.attachments.size(); ++k)
    EXPECT_EQ(s.made.attachments[k].panel, without.made.attachments[k].panel + 1);
}

TEST(Arrange, ATopAndASkirtThatNoSeamJoinsStandEachAroundTheirPartOfTheBody) {
  pattern::Pattern pattern = test::shirt();
  for (const pattern::Panel& panel : test::skirt().panels) pattern.panels.push_back(panel);
  for (pattern::Seam seam : test::skirt().seams) {
    for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) e.panel += 4;
    seam.id = "skirt_" + seam.id;
    pattern.seams.push_back(std::move(seam));
  }
  const Start both = started(pattern), shirt = started(test::shirt()), skirt = started(test::skirt());
  EXPECT_TRUE(both.made.unplaced.empty());
  for (Index p = 0; p < 4; ++p) EXPECT_NEAR(centre_of(both, p).y, centre_of(shirt, p).y, 0.02);
  for (Index p = 0; p < 4; ++p) EXPECT_NEAR(centre_of(both, 4 + p).y, centre_of(skirt, p).y, 0.02);
  const sewing::GarmentMesh& g = both.assembly.garment;
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  EXPECT_TRUE(collision::self_crossings(surface, both.assembly.positions).empty());
  for (const preflight::Finding& f : both.made.findings)
    EXPECT_NE(f.severity, preflight::Severity::kError) << text_of(both.made.findings);
}

TEST(Arrange, WithoutAnySeamNothingTellsWherePiecesGo) {
  pattern::Pattern pattern = test::skirt();
  pattern.seams.clear();
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  const auto made = arrange::arrange({pattern, meshes, std::span<const body::Body>(&mannequin(), 1)});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, "arrange.no_seams");
  EXPECT_NE(made.error().where, "");
}

TEST(Arrange, WithoutAStandingPersonThereIsNothingToArrangeAround) {
  const pattern::Pattern pattern = test::skirt();
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  EXPECT_EQ(arrange::arrange({pattern, meshes, {}}).error().code, "arrange.no_body");
  body::Body table{
      "table",
      {{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}}};
  const auto made = arrange::arrange({pattern, meshes, std::span<const body::Body>(&table, 1)});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, "body.not_standing");
}

TEST(Arrange, EqualInputGivesEqualPlaces) {
  const Start a = started(test::shirt()), b = started(test::shirt());
  EXPECT_EQ(a.assembly.positions, b.assembly.positions);
}

}  // namespace
}  // namespace toile
