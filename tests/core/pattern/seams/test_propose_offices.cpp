// What proposals make of garments as drafting offices hand them on: ribs, straps, circles, bias cuts, pieces
// cut twice, names with sizes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/propose.h"
#include "core/pattern/seams/upper_ends.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::mirrored;
using garments::piece;
using garments::plain_sleeve;
using garments::plain_top;
using garments::strip;
using test::WornSeams;

constexpr double kPi = std::numbers::pi;

TEST(Offices, ANeckBindingThatIsCutAlongItsGrainIsClosedAndStretchedOntoTheNeck) {
  pattern::Panel band = strip("Neckband", 330, 32);
  band.grain = {1, 0};
  const pattern::Panel arm = plain_sleeve("Sleeve", 110);
  const WornSeams worn(
      {plain_top("Front", 520), plain_top("Back", 600), arm, mirrored(arm, "Sleeve_2"), band});
  EXPECT_TRUE(worn.has({"Neckband.e1"}, {"Neckband.e3"})) << worn.text();
  EXPECT_TRUE(worn.has({"Front.e4", "Back.e4"}, {"Neckband.e2"}) ||
              worn.has({"Front.e4", "Back.e4"}, {"Neckband.e0"}))
      << worn.text();
}

TEST(Offices, AStripIsNeverSewnToAHose) {
  const seams::SeamModel m = seams::make_seam_model({{strip("any", 420, 30), strip("sheet", 420, 300)}, {}});
  EXPECT_TRUE(seams::never_sewn(m, 0, 2));
  EXPECT_FALSE(seams::never_sewn(m, 1, 3)) << "a ring";
  EXPECT_FALSE(seams::never_sewn(m, 4, 6)) << "as wide as a sleeve";
}

/// Sleeves are cut on; edges: hem, side and lower arm, wrist, upper arm, neck, …
pattern::Panel batwing(const std::string& name, double neck) {
  return piece(name, {{-290, 0},
                      {290, 0, Vec2{290, 330}, Vec2{480, 330}},
                      {730, 240},
                      {780, 345},
                      {100, 610, Vec2{60, neck}, Vec2{-60, neck}},
                      {-100, 610},
                      {-780, 345},
                      {-730, 240, Vec2{-480, 330}, Vec2{-290, 330}}});
}

std::vector<pattern::Panel> batwing_with_ribs() {
  const pattern::Panel cuff = strip("Cuff", 185, 160);
  return {batwing("Front", 470), batwing("Back", 560), strip("Rib hem", 905, 140), cuff,
          mirrored(cuff, "Cuff_mirrored")};
}

TEST(Offices, ABatwingHasSidesThatSweepToItsWristsAndCuffsThere) {
  const WornSeams worn(batwing_with_ribs());
  EXPECT_TRUE(worn.has({"Front.e1"}, {"Back.e7"})) << worn.text();
  EXPECT_TRUE(worn.has({"Front.e3"}, {"Back.e5"})) << worn.text();
  EXPECT_TRUE(worn.takes("Front.e2") && worn.takes("Back.e6")) << "the wrist, at a cuff\n" << worn.text();
  EXPECT_TRUE(worn.has({"Front.e0", "Back.e0"}, {"Rib hem.e2"})) << worn.text();
}

TEST(Offices, ABatwingsNeckTellsItsUpperEnd) {
  std::vector<pattern::Panel> panels = batwing_with_ribs();
  for (pattern::Panel& panel : panels) panel = garments::turned(panel, kPi);
  for (std::size_t p = 0; p < 2; ++p) panels[p].grain = {0, 1};  // against what is up
  const std::vector<Vec2> up = seams::grains_upwards(panels);
  EXPECT_LT(up[0].y, -0.9);
  EXPECT_LT(up[1].y, -0.9);
}

/// Edges: hem, side, waist, side.
pattern::Panel half_circle(const std::string& name) {
  return piece(name, {{-640, 0, Vec2{-640, -853}, Vec2{640, -853}},
                      {640, 0},
                      {105, 0, Vec2{105, -140}, Vec2{-105, -140}},
                      {-105, 0}});
}

TEST(Offices, HalvesOfACircleBelowAWaistbandAreASkirtAndNoCape) {
  const pattern::Panel front = half_circle("Front");
  const WornSeams worn({front, half_circle("Back"), strip("Waistband", 680, 40)});
  EXPECT_TRUE(worn.takes("Front.e2") && worn.takes("Back.e2")) << worn.text();
  const seams::SeamModel m =
      seams::make_seam_model({{front, half_circle("Back"), strip("Waistband", 680, 40)}, {}});
  EXPECT_TRUE(seams::has_shoulder(m, 0)) << "as a cape has";
  EXPECT_EQ(m.words[0].kind, seams::PieceKind::kSkirt);
  EXPECT_TRUE(worn.has({"Waistband.e1"}, {"Waistband.e3"})) << worn.text();
}

/// Edges: hem, inner leg, crotch, waist, pocket's corner, side.
pattern::Panel pocketed_leg(const std::string& name, double crotch, double back) {
  return piece(name, {{25, 0},
                      {225, 0, Vec2{228, 300}, Vec2{245, 600}},
                      {250 + crotch, 740, Vec2{250 + crotch * 0.4, 755}, Vec2{254, 810}},
                      {250, 975 + back},
                      {65, 971 + back},
                      {15, 820 + back, Vec2{-5, 700}, Vec2{-5, 300}}});
}

TEST(Offices, LegsWhoseSidesArePartedAtAPocketAreLegs) {
  const pattern::Panel front = pocketed_leg("Front", 50, 0), back = pocketed_leg("Back", 110, 5);
  const WornSeams worn(
      {front, mirrored(front, "Front_2"), back, mirrored(back, "Back_2"), strip("Waistband", 740, 40)});
  EXPECT_TRUE(worn.has({"Front.e2"}, {"Front_2.e2"})) << worn.text();
  EXPECT_TRUE(worn.has({"Back.e2"}, {"Back_2.e2"})) << worn.text();
  EXPECT_FALSE(worn.has({"Back.e5"}, {"Back_2.e5"})) << worn.text();
  const seams::SeamModel m = seams::make_seam_model(
      {{front, mirrored(front, "Front_2"), back, mirrored(back, "Back_2"), strip("Waistband", 740, 40)}, {}});
  EXPECT_TRUE(m.words[0].leg);
  const Index back_side = 17;
  ASSERT_EQ(m.runs[back_side].panel, 2);
  EXPECT_TRUE(seams::never_sewn(m, back_side, m.mirror[back_side])) << "the sides of two legs";
  EXPECT_EQ(m.crotch_side[0], 1);
  EXPECT_EQ(m.crotch_side[1], -1);
}

TEST(Offices, TheStraightEdgeOfAHoodIsAroundTheFace) {
  const pattern::Panel half =
      piece("hood", {{0, 0}, {210, 0}, {210, 336, Vec2{150, 420}, Vec2{-90, 420}}, {-60, 220}});
  const seams::SeamModel m = seams::make_seam_model({{half, mirrored(half, "hood_mirrored")}, {}});
  ASSERT_EQ(m.words[0].kind, seams::PieceKind::kHood);
  const WornSeams worn(
      {plain_top("Front", 520), plain_top("Back", 600), half, mirrored(half, "hood_mirrored")});
  EXPECT_TRUE(worn.has({"hood.e2"}, {"hood_mirrored.e2"}) ||
              worn.has({"hood.e2", "hood.e3"}, {"hood_mirrored.e2", "hood_mirrored.e3"}))
      << worn.text();
  EXPECT_FALSE(worn.has({"hood.e1"}, {"hood_mirrored.e1"})) << worn.text();
  const seams::SeamModel whole = seams::make_seam_model({{plain_top("Front", 520), half}, {}});
  EXPECT_TRUE(seams::never_sewn(whole, 1, 8 + 1)) << "the face, at a side";
  EXPECT_TRUE(seams::never_sewn(whole, 1, 8 + 2)) << "what goes over the head";
  EXPECT_FALSE(seams::never_sewn(whole, 4, 8 + 0)) << "the necks";
}

TEST(Offices, TheFaceOfAHoodIsToldThoughItsCrownIsCut) {
  const pattern::Panel half = piece("hood", {{0, 0}, {250, 20, Vec2{330, 300}, Vec2{100, 420}}, {-20, 365}});
  const pattern::Pattern both{{half, mirrored(half, "hood_mirrored")}, {}};
  seams::SeamModel m = seams::make_seam_model(both);
  const auto face_of = [&](Index panel) {
    return static_cast<Index>(std::find_if(m.runs.begin(), m.runs.end(),
                                           [&](const seams::SeamRun& run) {
                                             return run.panel == panel && run.straight && run.length > 300;
                                           }) -
                              m.runs.begin());
  };
  ASSERT_TRUE(seams::never_sewn(m, face_of(0), face_of(1)));
  m = seams::with_cuts(both, std::move(m), 1, {m.runs[1].length / 2});
  ASSERT_LT(m.runs[1].length, m.runs[face_of(0)].length);
  EXPECT_TRUE(seams::never_sewn(m, face_of(0), face_of(1)));
}

TEST(Offices, ANumberThatEndsOneNameAloneIsASizeAndNoRow) {
  const pattern::Panel arm = plain_sleeve("SLV-2", 110);
  const seams::SeamModel m = seams::make_seam_model({{arm, mirrored(arm, "SLV-2_mirrored")}, {}});
  EXPECT_EQ(m.twin[0], 1);
}

TEST(Offices, WhatIsCutTwiceForOneFaceOrSideLiesOnItself) {
  const pattern::Panel bib = piece("Bib", {{-160, 0}, {160, 0}, {90, 260}, {-90, 260}});
  pattern::Panel second = bib;
  second.id = "Bib_mirrored";
  const auto layers = [](std::vector<pattern::Panel> panels) {
    std::vector<bool> is;
    for (const seams::PieceWords& w : seams::make_seam_model({std::move(panels), {}}).words)
      is.push_back(w.layer);
    return is;
  };
  EXPECT_EQ(layers({bib, second, plain_top("Back", 600)}), (std::vector{false, true, false}));
  EXPECT_EQ(layers({bib, second}), (std::vector{false, false})) << "front and back may be one piece";
  const pattern::Panel left = strip("Waistband left", 420, 40);
  EXPECT_EQ(layers({left, mirrored(left, "Waistband left_mirrored")}), (std::vector{false, true}));
}

TEST(Offices, ABiasCutDressStandsOnItsMiddle) {
  const auto slip = [](const std::string& name, double top) {
    pattern::Panel p = piece(name, {{-300, 0},
                                    {300, 0},
                                    {230, 800, Vec2{150, 820}},
                                    {100, top, Vec2{0, top - 110}},
                                    {-100, top, Vec2{-150, 820}},
                                    {-230, 800}});
    p = garments::turned(p, kPi / 4);
    p.grain = {0, 1};
    return p;
  };
  const pattern::Pattern pattern{{slip("Front", 960), slip("Back", 900)}, {}};
  const seams::SeamModel m = seams::make_seam_model(pattern);
  EXPECT_NEAR(dot(m.up[0], normalized(Vec2{-1, 1})), 1, 1e-6);
  const pattern::Panel strap = strip("Strap", 400, 16);
  const WornSeams worn({pattern.panels[0], pattern.panels[1], strap, mirrored(strap, "Strap_2")});
  EXPECT_TRUE(worn.has({"Front.e1"}, {"Back.e5"})) << worn.text();
  EXPECT_TRUE(worn.has({"Strap.e1"}, {"Front.e3"}) || worn.has({"Strap.e1"}, {"Front.e4"})) << worn.text();
  EXPECT_FALSE(worn.has({"Front.e3"}, {"Back.e3"})) << "the neck";
}

/// A skirt with a bib in front and a band behind.
std::vector<pattern::Panel> pinafore() {
  const pattern::Panel strap = strip("Strap", 600, 40);
  std::vector<pattern::Panel> panels{
      piece("Skirt front", {{0, 0}, {620, 0}, {510, 510}, {110, 510}}),
      piece("Skirt back", {{0, 0}, {620, 0}, {505, 510}, {115, 510}}),
      piece("Bib",
            {{0, 0}, {400, 0}, {400, 50, Vec2{320, 80}}, {310, 260}, {90, 260, Vec2{80, 80}}, {0, 50}}),
      strip("Waistband back", 390, 50),
      strap,
      mirrored(strap, "Strap_2")};
  for (const double x : {130.0, 260.0}) panels[3].notches.push_back({{x, 50}, 0, {0, -1}});
  return panels;
}

TEST(Offices, StrapsAreSewnOntoABibsCornersAndAtNotchesBehind) {
  const WornSeams worn(pinafore());
  const auto [front_from, front_to] = worn.part("Bib.e3", "Strap.e1");
  EXPECT_NEAR((front_to - front_from) * 220, 40, 0.5) << worn.text();
  EXPECT_NEAR(std::min(front_from, 1 - front_to), 0, 1e-6) << "at a corner";
  const auto [back_from, back_to] = worn.part("Waistband back.e2", "Strap.e3");
  EXPECT_NEAR(std::abs((back_from + back_to) / 2 - 0.5) * 390, 65, 0.5) << "at a notch\n" << worn.text();
  // Seen from outside the wearer's left is a front's right half and a back's left one; both edges run
  // leftwards.
  EXPECT_TRUE((front_from < 0.5) != (back_from < 0.5)) << "over one shoulder";
}

TEST(Offices, WithoutANotchStrapsAreSewnOnAtAQuarterOfTheEdge) {
  std::vector<pattern::Panel> panels = pinafore();
  panels[3].notches.clear();
  const WornSeams worn(panels);
  const auto [from, to] = worn.part("Waistband back.e2", "Strap.e3");
  EXPECT_NEAR(std::abs((from + to) / 2 - 0.5), 0.25, 1e-3) << worn.text();
}

TEST(Offices, BeltsAreNoStraps) {
  std::vector<pattern::Panel> panels = pinafore();
  panels[4].id = "Belt";
  panels[5].id = "Belt_2";
  const WornSeams worn(panels);
  for (const char* end : {"Belt.e1", "Belt.e3", "Belt_2.e1", "Belt_2.e3"})
    EXPECT_FALSE(worn.takes(end)) << end;
}

TEST(Offices, ARibIsClosedSoThatAHandPasses) {
  pattern::Panel cuff = strip("Cuff", 180, 140);
  cuff.grain = {1, 0};
  const pattern::Panel arm = plain_sleeve("Sleeve", 120);
  const WornSeams worn({plain_top("Front", 520), plain_top("Back", 600), arm, mirrored(arm, "Sleeve_2"), cuff,
                        mirrored(cuff, "Cuff_2")});
  EXPECT_TRUE(worn.has({"Cuff.e1"}, {"Cuff.e3"})) << worn.text();
}

TEST(Offices, WhatIsGatheredHangsFromItsYoke) {
  const auto body = [](const std::string& name, double top) {
    return piece(name, {{-310, 0},
                        {310, 0},
                        {280, 320, Vec2{230, 330}, Vec2{220, 400}},
                        {top / 2, 470},
                        {-top / 2, 470, Vec2{-220, 400}, Vec2{-230, 330}},
                        {-280, 320}});
  };
  const pattern::Panel yoke =
      piece("Back yoke", {{-160, 0}, {160, 0}, {175, 80}, {70, 110, Vec2{0, 90}}, {-70, 110}, {-175, 80}});
  const seams::SeamModel m = seams::make_seam_model({{body("Front", 430), body("Back body", 420), yoke}, {}});
  EXPECT_EQ(seams::hangs_from(m, 1, 2), 1);
  EXPECT_EQ(seams::hangs_from(m, 2, 1), -1);
  EXPECT_EQ(seams::hangs_from(m, 0, 2), -1) << "a front from the back's yoke";
}

TEST(Offices, RtBesideVtIsABack) {
  const seams::SeamModel german = seams::make_seam_model(
      {{plain_top("VT", 520), plain_top("RT", 600), strip("RT_mirrored", 90, 30)}, {}});
  EXPECT_EQ(german.words[1].face, -1);
  EXPECT_EQ(german.words[1].side, 0);
  EXPECT_EQ(german.words[2].face, -1);
  const seams::SeamModel english =
      seams::make_seam_model({{plain_top("Front", 520), plain_top("RT", 600)}, {}});
  EXPECT_EQ(english.words[1].side, 1);
}

/// Half of a front of jeans, its pocket cut away: hem, side, pocket, waist, crotch, inner leg.
pattern::Panel jeans_front(const std::string& name, double waist_rise) {
  return piece(name, {{0, 0},
                      {208, 0},
                      {230, 955, Vec2{185, 955}, Vec2{140, 975}},
                      {135, 1010},
                      {10, 1010 - waist_rise, Vec2{0, 830}, Vec2{-30, 760}},
                      {-65, 745}});
}

TEST(Offices, TrousersWhosePocketsAreCutAwayAreNoBodices) {
  const pattern::Panel front = jeans_front("Front", 2);
  const std::vector<pattern::Panel> trousers{front, mirrored(front, "Front_2"), strip("Waistband", 900, 40)};
  EXPECT_NE(seams::make_seam_model({trousers, {}}).words[0].kind, seams::PieceKind::kTorso);
  const std::vector<pattern::Panel> top{front, mirrored(front, "Front_2")};
  EXPECT_EQ(seams::make_seam_model({top, {}}).words[0].kind, seams::PieceKind::kTorso)
      << "by its shape alone it may be one";
}

TEST(Offices, ASideThatAllNamesTellIsNone) {
  const pattern::Panel arm = plain_sleeve("Sleeve_L", 110);
  const seams::SeamModel size =
      seams::make_seam_model({{plain_top("Front_L", 520), plain_top("Back_L", 600), arm}, {}});
  for (const seams::PieceWords& words : size.words) EXPECT_EQ(words.side, 0);
  const seams::SeamModel sides = seams::make_seam_model(
      {{plain_top("Front", 520), plain_top("Back", 600), arm, plain_sleeve("Sleeve_R", 110)}, {}});
  EXPECT_EQ(sides.words[2].side, -1);
  EXPECT_EQ(sides.words[3].side, 1);
}

TEST(Offices, AShortSleeveOfTwoCapHalvesStandsOnItsHem) {
  const auto short_sleeve = [](double under) {
    return piece("Sleeve", {{-170, 0},
                            {170, 0},
                            {185, 30, Vec2{120, 40}, Vec2{80, 150}},
                            {0, 160, Vec2{-80, 150}, Vec2{-120, 40}},
                            {-185, under}});
  };
  const auto stands = [](const pattern::Panel& panel) {
    return seams::make_seam_model({{plain_top("Front", 520), plain_top("Back", 600), panel}, {}})
               .upright[2] != 0;
  };
  EXPECT_TRUE(stands(short_sleeve(30)));
}

/// Half a front with so much beyond its middle to button it over the other, mm.
pattern::Panel buttoned_front(const std::string& name, double beyond) {
  return piece(name, {{-beyond, 0},
                      {250, 0},
                      {245, 380, Vec2{190, 390}, Vec2{185, 430}},
                      {200, 600},
                      {70, 640, Vec2{60, 540}, Vec2{30, 540}},
                      {-beyond, 540}});
}

TEST(Offices, ACollarEndsInTheMiddleOfFrontsThatAreButtonedOverEachOther) {
  const pattern::Panel front = buttoned_front("Front", 15), back = plain_top("Back", 600);
  const double neck = 2 * garments::length_of(front, 4) + garments::length_of(back, 4) - 30;
  const pattern::Panel arm = plain_sleeve("Sleeve", 110);
  pattern::Panel collar = piece("Collar", {{0, 0}, {neck, 0}, {neck + 50, 70}, {-50, 70}});
  const pattern::Pattern pattern{
      {front, mirrored(front, "Front_mirrored"), back, arm, mirrored(arm, "Sleeve_2"), collar}, {}};
  const auto proposals = seams::propose_seams(pattern, {});
  const auto on_collar = [](const seams::SeamProposal& p) {
    return p.seam.b.size() == 1 && p.seam.b[0].panel == 5 && p.seam.b[0].edge == 0 && p.seam.a.size() == 3;
  };
  const auto met = std::find_if(proposals.begin(), proposals.end(), [&](const seams::SeamProposal& p) {
    seams::SeamProposal other = p;
    if (other.seam.a.size() == 1) std::swap(other.seam.a, other.seam.b);
    return on_collar(other);
  });
  ASSERT_NE(met, proposals.end()) << WornSeams(pattern.panels).text();
  EXPECT_NEAR(met->length_a, met->length_b, 1) << "15 mm of each front go on beyond it";
  EXPECT_GT(met->confidence, 0.6);
}

/// The seams of trousers with a yoke behind, their sides notched at one height or not.
WornSeams trousers_with_yoke(bool notched) {
  pattern::Panel front = piece(
      "Front pants",
      {{0, 0}, {200, 0, Vec2{205, 600}}, {220, 1185}, {0, 1185, Vec2{0, 1000}, Vec2{0, 770}}, {-60, 760}});
  pattern::Panel back = piece(
      "Back pants",
      {{0, 0}, {230, 0, Vec2{235, 600}}, {250, 1140}, {10, 1140, Vec2{0, 1000}, Vec2{0, 775}}, {-110, 760}});
  pattern::Panel yoke = piece("Back yoke", {{0, 0}, {240, 0}, {240, 45}, {0, 75}});
  if (notched)
    for (pattern::Panel* panel : {&front, &back})
      panel->notches.push_back({pattern::point_at_length(panel->outline.edges[1], 400), 0, {}});
  const std::vector<pattern::Panel> trousers{front, mirrored(front, "Front pants_mirrored"),
                                             back,  mirrored(back, "Back pants_mirrored"),
                                             yoke,  mirrored(yoke, "Back yoke_mirrored")};
  EXPECT_NEAR(garments::length_of(front, 1), garments::length_of(back, 1) + 45, 3);
  return WornSeams(trousers);
}

TEST(Offices, ABacksSideGoesOnAlongItsYoke) {
  for (const bool notched : {false, true}) {
    const WornSeams worn = trousers_with_yoke(notched);
    const bool either = worn.has({"Front pants.e1"}, {"Back pants.e1", "Back yoke.e1"}) ||
                        worn.has({"Front pants.e1"}, {"Back yoke.e1", "Back pants.e1"}) ||
                        worn.has({"Front pants.e1"}, {"Back yoke_mirrored.e1", "Back pants_mirrored.e1"}) ||
                        worn.has({"Front pants.e1"}, {"Back pants_mirrored.e1", "Back yoke_mirrored.e1"});
    EXPECT_TRUE(either) << notched << worn.text();
  }
}

TEST(Offices, AStripThatFitsTheNeckOfATopIsItsBandWhateverItIsCalled) {
  const pattern::Panel front = plain_top("front", 540), back = plain_top("back", 620);
  const double neck = garments::length_of(front, 4) + garments::length_of(back, 4);
  for (const bool fits : {true, false}) {
    const WornSeams worn({front, back, garments::strip("Blende", (fits ? 0.9 : 0.6) * neck, 36)});
    const bool around = worn.has({"Blende.e0"}, {"front.e4", "back.e4"}) ||
                        worn.has({"Blende.e0"}, {"back.e4", "front.e4"}) ||
                        worn.has({"Blende.e2"}, {"front.e4", "back.e4"}) ||
                        worn.has({"Blende.e2"}, {"back.e4", "front.e4"});
    EXPECT_EQ(around, fits) << worn.text();
  }
}

TEST(Offices, ASkirtCutTwiceOfOnePieceHasAFrontAndABack) {
  const pattern::Panel half = piece("Skirt", {{-350, 0}, {350, 0}, {180, 600}, {-180, 600}});
  const auto faces_with = [&](const std::vector<pattern::Panel>& others) {
    pattern::Pattern pattern{{half, half}, {}};
    pattern.panels[1].id = "Skirt_2";
    pattern.panels.insert(pattern.panels.end(), others.begin(), others.end());
    const seams::SeamModel model = seams::make_seam_model(pattern);
    return model.words[0].face * model.words[1].face;
  };
  EXPECT_EQ(faces_with({}), -1);
  EXPECT_EQ(faces_with({mirrored(half, "Skirt_3")}), 0) << "three are gores";
  const WornSeams worn({half, mirrored(half, "Skirt_2"), garments::strip("Waistband", 720, 35)});
  EXPECT_FALSE(worn.has({"Skirt.e1"}, {"Skirt.e3"})) << "no cone of its own";
  EXPECT_TRUE(worn.has({"Skirt.e1"}, {"Skirt_2.e3"}) || worn.has({"Skirt.e1"}, {"Skirt_2.e1"}))
      << worn.text();
}

TEST(Offices, SkirtsAreGatheredOntoABodicesWaist) {
  const auto half = [](const std::string& name, double width) {
    return piece(name, {{0, 0}, {width, 0}, {width, 600}, {0, 600}});
  };
  for (const double times : {1.8, 2.5}) {
    const WornSeams worn({plain_top("bodice front", 540), plain_top("bodice back", 620),
                          half("skirt front", times * 500), half("skirt back", times * 500)});
    EXPECT_TRUE(worn.has({"bodice front.e0"}, {"skirt front.e2"})) << times << worn.text();
    EXPECT_TRUE(worn.has({"bodice back.e0"}, {"skirt back.e2"})) << times << worn.text();
  }
}

}  // namespace
}  // namespace toile
