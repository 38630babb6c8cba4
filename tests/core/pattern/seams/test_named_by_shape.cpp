// Garments whose pieces have numbers for names: shapes tell what they are.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/propose.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::mirrored;
using garments::piece;
using garments::plain_top;
using garments::strip;
using seams::PieceKind;
using test::WornSeams;
using Panels = std::vector<pattern::Panel>;

/// Its cap is eased by a twentieth onto the armholes of two tops.
pattern::Panel arm(const std::string& name) {
  const double armholes = 2 * garments::length_of(plain_top("", 600), 2);
  pattern::Panel sleeve;
  for (double rise = 100; rise < 400; rise += 2) {
    sleeve = piece(
        name, {{-110, 0}, {110, 0}, {185, 420, Vec2{90, 420 + rise}, Vec2{-90, 420 + rise}}, {-185, 420}});
    if (garments::length_of(sleeve, 2) > 1.05 * armholes) break;
  }
  return sleeve;
}

/// A front, a back, two sleeves with cuffs, a neckband, a band for the hem.
Panels shirt_of_numbers() {
  const pattern::Panel sleeve = arm("3"), cuff = strip("5", 180, 110);
  return {plain_top("1", 520), plain_top("2", 600),  sleeve, mirrored(sleeve, "3_mirrored"),
          strip("4", 330, 32), strip("6", 860, 120), cuff,   mirrored(cuff, "5_mirrored")};
}

PieceKind kind_of(const Panels& panels, std::size_t p) {
  return seams::make_seam_model({panels, {}}).words[p].kind;
}

TEST(NamedByShape, APairOfPiecesWithLikeShouldersIsABodiceItsLowerNeckTheFront) {
  const Panels panels = shirt_of_numbers();
  const seams::SeamModel m = seams::make_seam_model({panels, {}});
  EXPECT_TRUE(m.nameless);
  EXPECT_EQ(m.words[0].kind, PieceKind::kTorso);
  EXPECT_EQ(m.words[1].kind, PieceKind::kTorso);
  EXPECT_EQ(m.words[0].face, 1);
  EXPECT_EQ(m.words[1].face, -1);
  EXPECT_EQ(kind_of({panels[0], panels[4]}, 0), PieceKind::kOther) << "one alone has no fellow";
}

TEST(NamedByShape, WhatFitsTheArmholesTheNeckTheWristsAndTheHemIsNamedSo) {
  const Panels panels = shirt_of_numbers();
  EXPECT_EQ(kind_of(panels, 2), PieceKind::kSleeve);
  EXPECT_EQ(kind_of(panels, 4), PieceKind::kCollar);
  EXPECT_EQ(kind_of(panels, 5), PieceKind::kBand);
  EXPECT_EQ(kind_of(panels, 6), PieceKind::kCuff);
  Panels longer = panels;
  longer[4] = strip("4", 540, 32);
  EXPECT_EQ(kind_of(longer, 4), PieceKind::kOther) << "longer than the neck, shorter than the hem";
}

TEST(NamedByShape, AShirtOfNumbersIsSewnAsOneWithNames) {
  const WornSeams worn(shirt_of_numbers());
  EXPECT_TRUE(worn.has({"1.e3"}, {"2.e5"}) && worn.has({"1.e5"}, {"2.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"1.e1"}, {"2.e7"}) && worn.has({"1.e7"}, {"2.e1"})) << worn.text();
  EXPECT_TRUE(worn.has({"3.e1"}, {"3.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"4.e1"}, {"4.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"1.e4", "2.e4"}, {"4.e0"})) << worn.text();
  EXPECT_TRUE(worn.has({"6.e1"}, {"6.e3"})) << worn.text();
}

TEST(NamedByShape, TrousersAreToldByTheirCrotchesAndTheirWaistband) {
  Panels panels = garments::trousers().panels;
  double waist = 0;
  const seams::SeamModel named = seams::make_seam_model({panels, {}});
  for (const seams::SeamRun& run : named.runs)
    if (run.up > 0.8) waist += run.length;
  for (std::size_t p = 0; p < panels.size(); ++p) panels[p].id = std::to_string(p + 1);
  panels.push_back(strip("9", waist * 1.03, 40));
  const seams::SeamModel m = seams::make_seam_model({panels, {}});
  for (std::size_t p = 0; p + 1 < panels.size(); ++p) {
    EXPECT_EQ(m.words[p].kind, PieceKind::kLegs) << p;
    EXPECT_EQ(m.words[p].face, named.words[p].face) << p;
  }
  EXPECT_EQ(m.words.back().kind, PieceKind::kBand);
  panels.push_back(strip("10", waist * 0.87, 35));
  const seams::SeamModel elastic = seams::make_seam_model({panels, {}});
  EXPECT_TRUE(elastic.words.back().layer) << "lies in the band that fits better";
  EXPECT_FALSE(elastic.words[panels.size() - 2].layer);
}

/// Sleeves are cut on, the side is parted by a blunt corner; edges: hem, side, lower arm, wrist, upper arm,
/// neck, …
pattern::Panel dolman(const std::string& name, double neck) {
  return piece(name, {{-310, 0},
                      {310, 0},
                      {365, 120, Vec2{420, 330}, Vec2{500, 330}},
                      {690, 330},
                      {750, 450},
                      {100, 660, Vec2{60, neck}, Vec2{-60, neck}},
                      {-100, 660},
                      {-750, 450},
                      {-690, 330, Vec2{-500, 330}, Vec2{-420, 330}},
                      {-365, 120}});
}

TEST(NamedByShape, SleevesThatAreCutOnTellABodiceAndItsRibs) {
  const pattern::Panel cuff = strip("5", 220, 140);
  const Panels panels{dolman("1", 520),
                      dolman("2", 620),
                      strip("3", 400, 50),
                      strip("4", 1100, 160),
                      cuff,
                      mirrored(cuff, "5_mirrored")};
  const seams::SeamModel m = seams::make_seam_model({panels, {}});
  EXPECT_EQ(m.words[0].kind, PieceKind::kTorso);
  EXPECT_EQ(m.words[0].face, 1);
  EXPECT_EQ(m.words[1].face, -1);
  EXPECT_EQ(m.words[2].kind, PieceKind::kCollar);
  EXPECT_EQ(m.words[3].kind, PieceKind::kBand);
  EXPECT_EQ(m.words[4].kind, PieceKind::kCuff);
  const std::array<double, 2> below_arm = seams::pair_merit(m, 2, 18);  // e2 of the front, e8 of the back
  EXPECT_GT(std::max(below_arm[0], below_arm[1]), 4) << "no two armholes";
  const WornSeams worn(panels);
  EXPECT_TRUE(worn.has({"1.e4"}, {"2.e6"}) && worn.has({"1.e6"}, {"2.e4"})) << worn.text();
  EXPECT_TRUE(worn.has({"1.e2"}, {"2.e8"}) && worn.has({"1.e8"}, {"2.e2"}))
      << "below the arm, where the side goes on\n"
      << worn.text();
}

TEST(NamedByShape, NamesGoBeforeShapes) {
  Panels panels = shirt_of_numbers();
  panels[0].id = "Front";
  EXPECT_FALSE(seams::make_seam_model({panels, {}}).nameless);
  panels[0].id = "Pocket";
  EXPECT_EQ(kind_of(panels, 0), PieceKind::kOther);
}

TEST(NamedByShape, WhatShapesTellIsNeverSure) {
  for (const seams::SeamProposal& p : seams::propose_seams({shirt_of_numbers(), {}}))
    EXPECT_LT(p.confidence, 0.8) << p.seam.id;
}

/// Hem, inner edge, seat in two edges with a corner between them, waist, front's middle, inner edge.
pattern::Panel whole_leg(const std::string& name) {
  return piece(name, {{-100, 0},
                      {100, 0, Vec2{130, 350}},
                      {250, 660},
                      {180, 770},
                      {150, 990},
                      {-150, 990, Vec2{-165, 750}},
                      {-245, 660, Vec2{-130, 350}}});
}

TEST(NamedByShape, APairThatNarrowsFromLikeInnerEdgesToALevelWaistIsLegs) {
  const pattern::Panel leg = whole_leg("1");
  const Panels leggings{leg, mirrored(leg, "1_mirrored"), strip("2", 540, 80)};
  EXPECT_EQ(kind_of(leggings, 0), PieceKind::kLegs);
  EXPECT_EQ(kind_of(leggings, 2), PieceKind::kBand) << "stretched onto the waist";
  const WornSeams worn(leggings);
  EXPECT_TRUE(worn.has({"1.e1"}, {"1.e6"})) << worn.text();
  EXPECT_TRUE(worn.has({"1.e5"}, {"1_mirrored.e5"})) << worn.text();
  EXPECT_TRUE(worn.has({"1.e2"}, {"1_mirrored.e2"})) << worn.text();
  EXPECT_TRUE(worn.has({"1.e3"}, {"1_mirrored.e3"})) << "the seat goes on around its corner\n" << worn.text();
}

/// A casing cut along its grain, and tiers of two panels, each half as wide again as the one above it.
Panels tiers_of_numbers() {
  Panels panels{strip("4", 1000, 70)};
  panels[0].grain = {1, 0};
  double width = 500;
  for (const char* name : {"1", "2", "3"}) {
    panels.push_back(strip(name + std::string("A"), width, 200 + width / 50));
    panels.push_back(strip(name + std::string("B"), width, 200 + width / 50));
    width *= 1.5;
  }
  return panels;
}

TEST(NamedByShape, TiersHangFromACasingTheWiderFromTheNarrower) {
  const Panels panels = tiers_of_numbers();
  const seams::SeamModel m = seams::make_seam_model({panels, {}});
  EXPECT_EQ(m.words[0].kind, PieceKind::kBand);
  for (std::size_t p = 1; p < panels.size(); ++p) {
    EXPECT_EQ(m.words[p].kind, PieceKind::kSkirt) << p;
    EXPECT_EQ(m.level[p], static_cast<int>((p - 1) / 2)) << p;
  }
  const WornSeams worn(panels);
  EXPECT_TRUE(worn.has({"1A.e1"}, {"1B.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"1A.e3"}, {"1B.e1"})) << "at both sides\n" << worn.text();
  const auto gathered = [&](const std::string& upper, const std::string& lower) {
    return (worn.has({upper + "A.e0"}, {lower + "A.e2"}) && worn.has({upper + "B.e0"}, {lower + "B.e2"})) ||
           (worn.has({upper + "A.e0"}, {lower + "B.e2"}) && worn.has({upper + "B.e0"}, {lower + "A.e2"}));
  };
  EXPECT_TRUE(gathered("1", "2")) << worn.text();
  EXPECT_TRUE(gathered("2", "3")) << worn.text();
}

}  // namespace
}  // namespace toile
