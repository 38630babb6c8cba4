// What proposals make of garments of a collection: bibs, cuffs, hoods, yokes, pleats and style codes.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/pattern/seams/cuts.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/kinds.h"
#include "core/pattern/seams/model.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::mirrored;
using garments::piece;
using garments::plain_sleeve;
using garments::plain_top;
using garments::strip;
using seams::PieceKind;
using test::WornSeams;
using Panels = std::vector<pattern::Panel>;

std::vector<seams::PieceWords> words_of(const Panels& panels) { return seams::garment_words({panels, {}}); }

TEST(ReadyToWear, ALetterBeforeAStyleNumberTellsNoFace) {
  const auto words =
      words_of({plain_top("B4410 FRT", 520), plain_top("B4410 BK", 600), strip("B4410 CUFF", 235, 110)});
  EXPECT_EQ(words[0].face, 1);
  EXPECT_EQ(words[1].face, -1);
  EXPECT_EQ(words[2].face, 0);
  EXPECT_EQ(words_of({plain_top("B2", 600)})[0].face, -1) << "a back in two parts";
}

TEST(ReadyToWear, CuffsCloseAroundAHandAndAreNeverSewnToEachOther) {
  pattern::Panel cuff = strip("Cuff", 215, 110);
  const seams::SeamModel m = seams::make_seam_model({{cuff, mirrored(cuff, "Cuff_mirrored")}, {}});
  EXPECT_TRUE(seams::never_sewn(m, 0, 6)) << "along their long edges";
  EXPECT_TRUE(seams::never_sewn(m, 0, 2)) << "a ring of 110 mm";
  EXPECT_FALSE(seams::never_sewn(m, 1, 3)) << "a ring of 215 mm";
}

TEST(ReadyToWear, ARoundedCuffHangsByItsStraightEdge) {
  const pattern::Panel sleeve = plain_sleeve("Sleeve");
  pattern::Panel cuff = piece("Cuff", {{200, 0}, {0, 0, Vec2{0, -150}, Vec2{200, -150}}});
  cuff.grain = {0, -1};
  const seams::SeamModel m = seams::make_seam_model({{sleeve, cuff}, {}});
  ASSERT_EQ(m.runs[5].panel, 1);
  EXPECT_GT(m.runs[5].up, 0.9) << "whatever its grain says";
  EXPECT_EQ(seams::told_to_hang(m, m.runs[0], m.runs[5]), 1) << "from the sleeve's hem";
}

TEST(ReadyToWear, AHoodOfThreePiecesLiesOnTheNeckWithItsStripBehind) {
  const auto half = [](const std::string& name, double neck) {
    return piece(name, {{0, 0},
                        {250, 0},
                        {245, 380, Vec2{190, 390}, Vec2{185, 430}},
                        {200, 600},
                        {70, 640, Vec2{62, neck}, Vec2{30, neck}},
                        {0, neck}});
  };
  const pattern::Panel front = half("front_l", 540), back = half("back_l", 620);
  const double fronts = 2 * garments::length_of(front, 4), backs = 2 * garments::length_of(back, 4);
  // Each side alone would fit the back's neck as well, and the strip and the other side the fronts'.
  const double side = backs + 2, middle = fronts + backs - 2 * side;
  const pattern::Panel hood =
      piece("hood_l", {{0, 0}, {side, 0, Vec2{side + 90, 220}, Vec2{side, 340}}, {0, 330}});
  const WornSeams worn({front, mirrored(front, "front_r"), back, mirrored(back, "back_r"), hood,
                        mirrored(hood, "hood_r"),
                        strip("hood middle", middle, garments::length_of(hood, 1))});
  const std::vector<std::string> around{"front_l.e4", "back_l.e4", "back_r.e4", "front_r.e4"};
  const bool below = worn.has(around, {"hood_l.e0", "hood middle.e0", "hood_r.e0"});
  EXPECT_TRUE(below || worn.has(around, {"hood_l.e0", "hood middle.e2", "hood_r.e0"})) << worn.text();
}

TEST(ReadyToWear, AHoodsFaceIsInFront) {
  // As far around as both necks together, each half so far as half of that.
  const double neck = garments::length_of(plain_top("", 520), 4) + garments::length_of(plain_top("", 600), 4);
  const pattern::Panel half = piece(
      "Hood", {{0, 0}, {neck / 2, 0}, {neck / 2 + 20, 340, Vec2{neck / 2, 420}, Vec2{80, 420}}, {0, 330}});
  const pattern::Panel sleeve = plain_sleeve("Sleeve");
  const Panels panels{
      plain_top("Front", 520), plain_top("Back", 600), sleeve, mirrored(sleeve, "Sleeve_2"), half,
      mirrored(half, "Hood_2")};
  const WornSeams worn(panels);
  EXPECT_TRUE(worn.has({"Front.e4", "Front.e4", "Back.e4"}, {"Hood.e0", "Hood_2.e0"})) << worn.text();
}

TEST(ReadyToWear, AHoodWithANotchAtItsCrownIsClosedOverTheHead) {
  const double neck = garments::length_of(plain_top("", 520), 4) + garments::length_of(plain_top("", 600), 4);
  pattern::Panel half =
      piece("Hood", {{0, 0}, {neck / 2, 0, Vec2{neck / 2 + 40, 380}, Vec2{150, 420}}, {0, 330}});
  half.notches = {{pattern::evaluate(half.outline.edges[1].curves[0], 0.5), 0, {}}};
  const pattern::Panel sleeve = plain_sleeve("Sleeve");
  const WornSeams worn({plain_top("Front", 520), plain_top("Back", 600), sleeve, mirrored(sleeve, "Sleeve_2"),
                        half, mirrored(half, "Hood_2")});
  EXPECT_TRUE(worn.has({"Hood.e1"}, {"Hood_2.e1"})) << worn.text();
}

TEST(ReadyToWear, TiesOfAWrapSkirtMakeNoTopOfIt) {
  const Panels skirt{piece("TRASERO", {{-300, 0}, {300, 0}, {240, 620}, {-240, 620}}),
                     piece("DELANTERO", {{0, 0}, {300, 0}, {240, 620}, {0, 620}}),
                     strip("CINTURILLA", 730, 40), strip("LAZO", 850, 80)};
  EXPECT_EQ(words_of(skirt)[0].kind, PieceKind::kSkirt);
  EXPECT_EQ(words_of(skirt)[1].kind, PieceKind::kSkirt);
}

TEST(ReadyToWear, AWaistbandOfATopEndsItBelow) {
  pattern::Panel rib = strip("RIB CINTURA", 954, 65);
  rib.outline.edges[0].id = pattern::kFoldEdge;
  const Panels top{plain_top("Front", 520), plain_top("Back", 600), plain_sleeve("Sleeve"), rib};
  EXPECT_TRUE(words_of(top)[3].hem_band);
  EXPECT_GT(seams::make_seam_model({top, {}}).up[3].y, 0.9) << "its fold is below";
  Panels dress = top;
  dress.push_back(strip("Skirt", 900, 600));
  EXPECT_FALSE(words_of(dress)[3].hem_band);
}

TEST(ReadyToWear, SidesOfABodiceAreNoLegs) {
  // A waistcoat in eight: a front's and a back's middle and side, each side below an armhole as hollow as a
  // crotch.
  const auto middle = [](const std::string& name) {
    return piece(name, {{0, 0}, {100, 0, Vec2{80, 200}, Vec2{110, 380}}, {130, 540}, {80, 560}, {0, 350}});
  };
  const auto side = [](const std::string& name) {
    return piece(name, {{0, 0},
                        {130, 10},
                        {140, 330, Vec2{80, 340}, Vec2{75, 450}},
                        {95, 530},
                        {30, 545, Vec2{10, 380}, Vec2{-20, 200}}});
  };
  Panels panels;
  for (const char* face : {"front", "back"})
    for (const auto& panel : {middle(std::string("center ") + face), side(std::string("side ") + face)}) {
      panels.push_back(panel);
      panels.push_back(mirrored(panel, panel.id + "_mirrored"));
    }
  for (const seams::PieceWords& words : words_of(panels)) EXPECT_EQ(words.kind, PieceKind::kTorso);
}

TEST(ReadyToWear, ABackIsGatheredBelowAYokeWhoseGrainLiesAcross) {
  const Panels all = [] {
    pattern::Panel yoke =
        piece("Yoke", {{-200, 0}, {200, 0}, {200, 90}, {75, 130, Vec2{0, 60}}, {-75, 130}, {-200, 90}});
    yoke.grain = {1, 0};
    const pattern::Panel back = piece("Back", {{-240, 0},
                                               {240, 0},
                                               {240, 380, Vec2{210, 400}, Vec2{220, 460}},
                                               {220, 520},
                                               {-220, 520, Vec2{-220, 460}, Vec2{-210, 400}},
                                               {-240, 380}});
    return Panels{plain_top("Front", 520), back, yoke};
  }();
  const seams::SeamModel m = seams::make_seam_model({all, {}});
  const auto lower =
      std::find_if(m.runs.begin(), m.runs.end(), [](const auto& run) { return run.panel == 2; });
  EXPECT_LT(lower->up, -0.9) << "the back hangs there";
  EXPECT_EQ(seams::hangs_from(m, 1, 2), 1);
  const WornSeams worn(all);
  EXPECT_TRUE(worn.has({"Back.e3"}, {"Yoke.e0"})) << worn.text();
}

TEST(ReadyToWear, ABibStandsOnTheMiddleOfItsWaistbandAndHangsOnItsStraps) {
  const auto bib = [](const std::string& name, double top) {
    return piece(name, {{-148, 0}, {148, 0}, {top, 250}, {-top, 250}});
  };
  const auto leg = [](const std::string& name, double crotch) {
    return piece(name, {{0, 0}, {240, 0}, {230, 1000}, {0, 1000}, {-30 - crotch, 780, Vec2{-20, 800}}});
  };
  pattern::Panel strap = piece("Strap", {{0, 0}, {600, 0}, {622, 22}, {622, 66}, {600, 88}, {0, 88}});
  strap.grain = {1, 0};
  pattern::Panel back_bib = bib("Back Bib", 100);
  const pattern::Panel front = leg("Front Leg", 20), back = leg("Back Leg", 60);
  const WornSeams worn({front, mirrored(front, "Front Leg_mirrored"), back,
                        mirrored(back, "Back Leg_mirrored"), strip("Front Waistband", 460, 44),
                        strip("Back Waistband", 460, 44), bib("Front Bib", 112), back_bib, strap,
                        mirrored(strap, "Strap_mirrored")});
  EXPECT_NEAR(worn.part("Front Waistband.e2", "Front Bib.e0").first, (460 - 296) / 2 / 460.0, 1e-6)
      << worn.text();
  EXPECT_NEAR(worn.part("Front Waistband.e2", "Front Bib.e0").second, 1 - (460 - 296) / 2 / 460.0, 1e-6);
  EXPECT_FALSE(worn.takes("Front Bib.e1") || worn.takes("Front Bib.e3")) << worn.text();
  EXPECT_TRUE(worn.takes("Strap.e5")) << worn.text();
  EXPECT_EQ(words_of({back_bib})[0].face, -1);
}

TEST(ReadyToWear, ASkirtWithOpenPleatsIsGatheredOntoItsWaistband) {
  const WornSeams worn(
      {strip("Skirt front", 800, 700), strip("Skirt back", 790, 700), strip("Waistband", 770, 70)});
  EXPECT_TRUE(worn.has({"Skirt back.e2", "Skirt front.e2"}, {"Waistband.e0"}) ||
              worn.has({"Skirt back.e2", "Skirt front.e2"}, {"Waistband.e2"}))
      << worn.text();
}

TEST(ReadyToWear, PiecesCutOfALiningLieOnOthers) {
  Panels panels{plain_top("1", 520), plain_top("2", 600), strip("3", 215, 170)};
  panels[2].fabric = "lining";
  EXPECT_TRUE(words_of(panels)[2].layer);
  EXPECT_FALSE(words_of(panels)[0].layer);
  for (pattern::Panel& panel : panels) panel.fabric = "lining";
  EXPECT_FALSE(words_of(panels)[2].layer) << "a garment of lining";
}

TEST(ReadyToWear, StrapsOfADressAreForItsBodice) {
  pattern::Panel strap = strip("Strap", 400, 24);
  strap.grain = {1, 0};
  const seams::SeamModel m =
      seams::make_seam_model({{strap, strip("Skirt front", 700, 800), strip("Bodice front", 400, 200)}, {}});
  EXPECT_TRUE(seams::never_sewn(m, 1, 6)) << "an end and the skirt's upper edge";
  EXPECT_FALSE(seams::never_sewn(m, 1, 10));
}

/// A shirt's stand with round ends: edges neck and top, which goes around the ends.
pattern::Panel round_stand(double neck) {
  return piece("Collar Stand", {{0, 10}, {neck, 10, Vec2{neck + 10, 50}, Vec2{-10, 50}}});
}

TEST(ReadyToWear, ACollarSitsInTheMiddleOfAStandWithRoundEnds) {
  const pattern::Panel half_front = piece("Front", {{0, 0},
                                                    {250, 0},
                                                    {245, 380, Vec2{190, 390}, Vec2{185, 430}},
                                                    {200, 600},
                                                    {70, 640, Vec2{60, 580}, Vec2{40, 540}},
                                                    {0, 540}});
  const pattern::Panel back = plain_top("Back", 600);
  const double neck = garments::length_of(back, 4) + 2 * garments::length_of(half_front, 4);
  const pattern::Panel stand = round_stand(neck);
  const double sits = garments::length_of(stand, 1) - 60;
  const pattern::Panel collar = piece("Collar", {{0, 0}, {sits, 0}, {sits + 16, 65}, {-16, 65}});
  const Panels panels{half_front, mirrored(half_front, "Front_mirrored"), back, stand, collar};
  const WornSeams worn(panels);
  EXPECT_TRUE(worn.has({"Collar.e0"}, {"Collar Stand.e1"})) << worn.text();
  EXPECT_TRUE(worn.has({"Front.e4", "Back.e4", "Front_mirrored.e4"}, {"Collar Stand.e0"})) << worn.text();
  const seams::SeamModel m = seams::make_seam_model({{stand, collar, back}, {}});
  EXPECT_TRUE(seams::never_sewn(m, 0, 2)) << "the collar along the neck's edge";
  EXPECT_TRUE(seams::never_sewn(m, 1, 3)) << "its end on the top";
  EXPECT_TRUE(seams::never_sewn(m, 1, 6 + 4)) << "the neck on the top";
}

TEST(ReadyToWear, NothingIsSewnToAFoldButTheOtherFrontsBand) {
  pattern::Panel band = strip("Waistband", 480, 40);
  band.outline.edges[2].id = pattern::kFoldEdge;
  const pattern::Panel skirt = strip("Skirt front", 480, 500);
  const WornSeams worn({band, skirt});
  EXPECT_TRUE(worn.has({"Waistband.e0"}, {"Skirt front.e2"})) << worn.text();
  EXPECT_GT(seams::make_seam_model({{band, skirt}, {}}).up[0].y, 0.9) << "a waist's fold lies above";
  pattern::Panel cuff = strip("Cuff", 215, 60);
  cuff.outline.edges[2].id = pattern::kFoldEdge;
  EXPECT_LT(seams::make_seam_model({{cuff}, {}}).up[0].y, -0.9) << "a cuff's below";
}

TEST(ReadyToWear, AFrontBandIsNoFrontAndKeepsTheNeckOpen) {
  pattern::Panel band = strip("FRONT BAND", 725, 65);
  band.outline.edges[2].id = pattern::kFoldEdge;
  const Panels panels{plain_top("Front", 520), plain_top("Back", 600), band,
                      mirrored(band, "FRONT BAND_mirrored")};
  const auto words = words_of(panels);
  EXPECT_EQ(words[2].face, 0);
  EXPECT_EQ(words[2].kind, PieceKind::kOther);
  const WornSeams worn(panels);
  EXPECT_FALSE(worn.has({"FRONT BAND.fold"}, {"FRONT BAND_mirrored.fold"})) << worn.text();
  EXPECT_FALSE(worn.has({"FRONT BAND.e0"}, {"FRONT BAND_mirrored.e0"})) << worn.text();
}

TEST(ReadyToWear, AFrontBandGoesUpToTheMiddleOfTheBacksNeck) {
  const pattern::Panel half_front = piece("Front", {{-60, -500},
                                                    {250, -500},
                                                    {245, 380, Vec2{190, 390}, Vec2{185, 430}},
                                                    {200, 600},
                                                    {70, 640, Vec2{60, 500}, Vec2{-60, 420}}});
  const pattern::Panel back = garments::bodice(
      "Back", {250, -500}, {245, 380, Vec2{190, 390}, Vec2{185, 430}}, {200, 600}, {70, 640, Vec2{60, 600}});
  pattern::Panel band =
      strip("FRONT BAND", garments::length_of(half_front, 4) + garments::length_of(back, 4) / 2, 65);
  band.outline.edges[2].id = pattern::kFoldEdge;
  band.grain = {1, 0};
  const pattern::Panel sleeve = plain_sleeve("Sleeve");
  const Panels panels{
      half_front, mirrored(half_front, "Front_mirrored"), back, sleeve, mirrored(sleeve, "Sleeve_mirrored"),
      band,       mirrored(band, "FRONT BAND_mirrored")};
  EXPECT_EQ(words_of(panels)[5].face, 0) << "it is no front";
  const WornSeams worn(panels);
  EXPECT_FALSE(worn.has({"FRONT BAND.fold"}, {"FRONT BAND_mirrored.fold"})) << "the neck stays open";
  EXPECT_TRUE(worn.has({"Back.e4", "Front.e4"}, {"FRONT BAND.e0"}) ||
              worn.has({"Back.e4", "Front.e4"}, {"FRONT BAND_mirrored.e0"}))
      << worn.text();
}

TEST(ReadyToWear, HalvesOfAWaistbandAreClosedBeforeAndBehind) {
  Panels panels = garments::trousers().panels;
  const double half = garments::length_of(panels[0], 3) + garments::length_of(panels[3], 3);
  panels.push_back(strip("Waistband left", half, 40));
  panels.push_back(strip("Waistband right", half, 40));
  const WornSeams worn(panels);
  EXPECT_TRUE(worn.has({"Waistband left.e1"}, {"Waistband right.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"Waistband left.e3"}, {"Waistband right.e1"})) << worn.text();
}

TEST(ReadyToWear, HalvesOfAWaistbandGoAroundNoLegEach) {
  const pattern::Panel front = piece(
      "Front", {{0, 0}, {220, 0}, {230, 300}, {200, 500}, {0, 500, Vec2{0, 380}, Vec2{0, 300}}, {-60, 290}});
  const pattern::Panel back = piece(
      "Back", {{0, 0}, {240, 0}, {250, 300}, {225, 500}, {30, 520, Vec2{0, 400}, Vec2{0, 310}}, {-90, 285}});
  const double half = garments::length_of(front, 3) + garments::length_of(back, 3);
  const WornSeams worn({front, mirrored(front, "Front_mirrored"), back, mirrored(back, "Back_mirrored"),
                        strip("Waistband left", half, 40), strip("Waistband right", half, 40)});
  EXPECT_TRUE(worn.has({"Waistband left.e1"}, {"Waistband right.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"Waistband left.e3"}, {"Waistband right.e1"})) << worn.text();
}

TEST(ReadyToWear, ACollarOfRibThatEndsInFrontIsStretchedAlongTheNeck) {
  const pattern::Panel front = plain_top("Front", 520), back = plain_top("Back", 600);
  const double along = 0.85 * (garments::length_of(front, 4) + garments::length_of(back, 4));
  const auto collar = [&](const std::string& name) {
    return piece(name, {{0, 0}, {along, 0, Vec2{along, 80}, Vec2{0, 80}}});
  };
  const pattern::Panel sleeve = plain_sleeve("Sleeve");
  const WornSeams worn({front, back, sleeve, mirrored(sleeve, "Sleeve_mirrored"), collar("Rib collar"),
                        mirrored(collar("Rib collar"), "Rib collar_mirrored")});
  EXPECT_TRUE(worn.has({"Back.e4", "Front.e4"}, {"Rib collar.e0"})) << worn.text();
  EXPECT_FALSE(worn.takes("Rib collar_mirrored.e0")) << "it lies on the other";
}

TEST(ReadyToWear, TheLongerEdgeOfAStandIsTheNecks) {
  // A collar whose outer edge is as long as the neck.
  const pattern::Panel stand =
      piece("Collar stand", {{0, 0, Vec2{200, -25}}, {400, 0}, {380, 35, Vec2{200, 10}}, {20, 35}});
  const pattern::Panel collar = piece("Collar", {{20, 0}, {380, 0}, {400, 60}, {0, 60}});
  const seams::SeamModel m = seams::make_seam_model({{plain_top("Back", 600), stand, collar}, {}});
  const Index neck = 4, lower = 8, upper = 10, inner = 12, outer = 14;
  EXPECT_TRUE(seams::never_sewn(m, lower, outer));
  EXPECT_TRUE(seams::never_sewn(m, lower, inner));
  EXPECT_TRUE(seams::never_sewn(m, upper, neck));
  EXPECT_FALSE(seams::never_sewn(m, lower, neck));
  EXPECT_FALSE(seams::never_sewn(m, upper, inner));
}

TEST(ReadyToWear, AYokesEndIsOfTheArmhole) {
  pattern::Panel yoke =
      piece("Back yoke", {{-200, 0}, {200, 0}, {200, 90}, {75, 130, Vec2{0, 60}}, {-75, 130}, {-200, 90}});
  const seams::SeamModel m = seams::make_seam_model(
      {{plain_top("Front", 520), plain_top("Back lower", 600), yoke, plain_sleeve("Sleeve")}, {}});
  for (const Index end : {8 + 8 + 1, 8 + 8 + 5})
    EXPECT_FALSE(seams::never_sewn(m, end, 8 + 8 + 6 + 3)) << "although it begins at the yoke's lower edge";
}

TEST(ReadyToWear, ACapIsCutAtAYokesEndsAlthoughACollarIsAsLong) {
  const pattern::Panel front = plain_top("Front", 520), back = plain_top("Back", 600);
  const double end = 74, armhole = garments::length_of(front, 2), cap = 1.036 * (2 * armhole + end);
  const pattern::Pattern shirt{
      {front, back, garments::sleeve("Sleeve", cap), strip("Yoke", 400, end), strip("Collar", cap, 60)}, {}};
  const seams::SeamModel m =
      seams::with_likely_cuts(shirt, seams::make_seam_model(shirt), seams::CutKind::kFirstFirst);
  EXPECT_EQ(std::count_if(m.runs.begin(), m.runs.end(),
                          [](const seams::SeamRun& run) { return run.panel == 2 && run.edge == 2; }),
            3);
}

TEST(ReadyToWear, AShapedWaistbandHangsFromItsShorterEdge) {
  for (const double along : {1.0, -1.0}) {
    pattern::Panel band =
        piece("5521-WBF", {{0, 0, Vec2{200, -40}}, {400, 0}, {370, 90, Vec2{200, 55}}, {30, 90}});
    band.grain = {along, 0};
    const seams::SeamModel m = seams::make_seam_model({{band}, {}});
    EXPECT_EQ(m.words[0].kind, PieceKind::kBand);
    EXPECT_GT(m.up[0].y, 0.9) << "its longer edge lies on the hip";
  }
}

TEST(ReadyToWear, ASleeveUnderANameOfNoLanguageIsToldByItsCap) {
  const pattern::Panel sleeve = plain_sleeve("Xqz");
  const auto words =
      words_of({plain_top("Front", 520), plain_top("Back", 600), sleeve, mirrored(sleeve, "Xqz_mirrored")});
  EXPECT_EQ(words[2].kind, PieceKind::kSleeve);
  EXPECT_TRUE(words[3].limb);
  const pattern::Panel pocket = piece("Xqz", {{0, 0}, {150, 0}, {150, 170}, {0, 170}});
  EXPECT_EQ(
      words_of({plain_top("Front", 520), plain_top("Back", 600), pocket, mirrored(pocket, "Xqz_mirrored")})[2]
          .kind,
      PieceKind::kOther);
}

TEST(ReadyToWear, TheRoundEdgeOfAFlatCollarIsItsOuterOne) {
  const pattern::Panel half = piece(
      "Collar", {{0, 0}, {0, 50, Vec2{-130, 50}, Vec2{-190, -20}}, {-110, -70, Vec2{-100, 0}, Vec2{-60, 0}}});
  const seams::SeamModel m = seams::make_seam_model({{half, plain_top("Back", 600)}, {}});
  ASSERT_GT(m.runs[1].turn.back(), 75) << "around its end";
  EXPECT_TRUE(seams::never_sewn(m, 1, 3 + 4)) << "to the neck";
  EXPECT_FALSE(seams::never_sewn(m, 2, 3 + 4));
}

TEST(ReadyToWear, BandsAndBeltsBySeveralNames) {
  const auto words =
      words_of({plain_top("ST204-FRT", 520), plain_top("ST204-BCK", 600), strip("ST204-NKB", 460, 40),
                strip("ST204-CFB", 170, 140), strip("ST204-HMB", 820, 120), strip("Schlitzbesatz", 50, 200),
                strip("Lazo", 850, 80), strip("Belt loop", 100, 30)});
  EXPECT_TRUE(words[2].kind == PieceKind::kCollar && words[2].stand);
  EXPECT_EQ(words[3].kind, PieceKind::kCuff);
  EXPECT_TRUE(words[4].hem_band);
  EXPECT_TRUE(words[5].layer) << "a facing";
  EXPECT_TRUE(seams::is_tied(words[6]));
  EXPECT_FALSE(seams::is_tied(words[7]));
  EXPECT_EQ(seams::words_of("CH77 DEL T42").face, 1) << "before its size";
}

TEST(ReadyToWear, AZipInANameTellsNothingAndWhatGuardsOneIsATrim) {
  const seams::PieceWords back = seams::words_of("ZIPER CENTRO COSTAS");
  EXPECT_TRUE(back.face < 0 && !back.layer);
  EXPECT_FALSE(seams::words_of("Delantero tela").layer) << "cut of the garment's cloth";
  for (const char* name : {"OSLONA ZAMKA", "FERMUAR PATI", "KEMER KOPRUSU", "rv beleg"})
    EXPECT_TRUE(seams::words_of(name).layer) << name;
}

TEST(ReadyToWear, AStandAloneIsTheNecksAndOneOfButtonsIsNone) {
  EXPECT_TRUE(seams::words_of("stojka").kind == PieceKind::kCollar && seams::words_of("stojka").stand);
  EXPECT_NE(seams::words_of("button stand").kind, PieceKind::kCollar);
}

TEST(ReadyToWear, ABandFarLongerThanTheHemIsABelt) {
  for (const double length : {900, 1600}) {
    const auto words = words_of({plain_top("Devant", 520), plain_top("Dos", 600), plain_sleeve("Manche"),
                                 strip("Ceinture", length, 60)});
    EXPECT_EQ(words[3].belt, length > 1200) << length;
    EXPECT_EQ(words[3].hem_band, length < 1200) << length;
  }
}

TEST(ReadyToWear, ABeltIsSewnToNothingButASkirtWhoseWaistbandItMayBe) {
  const seams::SeamModel m = seams::make_seam_model(
      {{strip("belt", 700, 60), strip("front", 60, 700), strip("skirt", 700, 600)}, {}});
  EXPECT_TRUE(seams::never_sewn(m, 1, 4));
  EXPECT_FALSE(seams::never_sewn(m, 1, 8 + 2));
}

}  // namespace
}  // namespace toile
