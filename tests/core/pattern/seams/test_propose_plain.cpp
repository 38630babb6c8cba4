// What proposals make of plain garments of other makes: legs that are cut in one piece, sleeves that go up to
// the neck or are set on without a cap, bands, straps, gathered caps.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/seams/accept.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/propose.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::bodice;
using garments::mirrored;
using garments::piece;
using garments::strip;
using test::WornSeams;

TEST(PlainGarments, LegsOfOnePieceMeetInFrontAndBehind) {
  const pattern::Panel left = piece("left leg", {{-95, 0},
                                                 {95, 0, Vec2{115, 300}, Vec2{150, 600}},
                                                 {200, 740, Vec2{175, 755}, Vec2{160, 800}},
                                                 {150, 960},
                                                 {-165, 1000, Vec2{-175, 850}, Vec2{-190, 780}},
                                                 {-270, 740, Vec2{-180, 600}, Vec2{-115, 300}}});
  const WornSeams worn({left, mirrored(left, "right leg")});
  EXPECT_TRUE(worn.has({"left leg.e1"}, {"left leg.e5"})) << "between hem and crotch";
  EXPECT_TRUE(worn.has({"left leg.e2"}, {"right leg.e2"})) << "in front";
  EXPECT_TRUE(worn.has({"left leg.e4"}, {"right leg.e4"})) << "behind";
  EXPECT_FALSE(worn.takes("left leg.e0")) << "the hem";
}

/// Edges: hem, inner leg, crotch, waist, side.
pattern::Panel half_leg(const std::string& name, double crotch, double back) {
  return piece(name, {{25, 0},
                      {225, 0, Vec2{228, 300}, Vec2{245, 600}},
                      {250 + crotch, 740, Vec2{250 + crotch * 0.4, 755}, Vec2{254, 810}},
                      {250, 975 + back},
                      {65, 971 + back, Vec2{0, 880}, Vec2{-10, 400}}});
}

TEST(PlainGarments, HalvesWithACrotchAreLegsWithoutBeingNamedSo) {
  const pattern::Panel front = half_leg("Front", 50, 0), back = half_leg("Back", 110, 5);
  const WornSeams worn(
      {front, mirrored(front, "Front_2"), back, mirrored(back, "Back_2"), strip("Waistband", 740, 40)});
  EXPECT_TRUE(worn.has({"Front.e2"}, {"Front_2.e2"}));
  EXPECT_TRUE(worn.has({"Back.e2"}, {"Back_2.e2"}));
  EXPECT_FALSE(worn.takes("Front.e0")) << "a left hem does not hang from the right waist";
  EXPECT_TRUE(worn.takes("Front.e3")) << "the waist, at the band";
}

/// Whether a piece is sewn to another so that the one shows its right side where the other shows its wrong
/// one.
bool any_shows_its_wrong_side(const std::vector<seams::SeamProposal>& proposals) {
  return std::any_of(proposals.begin(), proposals.end(), [](const seams::SeamProposal& p) {
    const bool alike = p.seam.a[0].reversed == p.seam.b[0].reversed;
    return p.confidence >= 0.8 && alike == p.seam.same_direction;
  });
}

TEST(PlainGarments, ABandShowsItsRightSideWhicheverWayItsOutlineIsDrawn) {
  const pattern::Panel front = half_leg("Front", 50, 0), back = half_leg("Back", 110, 5);
  const pattern::Pattern pattern{
      {front, mirrored(front, "Front_2"), back, mirrored(back, "Back_2"), strip("Waistband", 740, 40)}, {}};
  EXPECT_FALSE(any_shows_its_wrong_side(seams::propose_seams(pattern, {false, {0, 0, 0, 0, 1}})));
  EXPECT_FALSE(any_shows_its_wrong_side(seams::propose_seams(pattern, {false, {1, 1, 1, 1, 0}})));
  const pattern::Pattern skirt{
      {piece("Front", {{0, 0}, {560, 0}, {475, 600}, {85, 600}}),
       piece("Back", {{0, 0}, {560, 0}, {475, 600}, {85, 600}}), strip("Waistband", 780, 40)},
      {}};
  EXPECT_FALSE(any_shows_its_wrong_side(seams::propose_seams(skirt, {false, {0, 0, 1}})));
}

TEST(PlainGarments, WindingsCountWhereOtherPiecesAreDrawnBothWays) {
  const pattern::Panel front = half_leg("Front", 50, 0), back = half_leg("Back", 110, 5);
  const pattern::Pattern pattern{
      {front, mirrored(front, "Front_2"), mirrored(back, "Back"), mirrored(mirrored(back, "Back"), "Back_2"),
       strip("Front band", 370, 40), strip("Back band", 370, 40)},
      {}};
  EXPECT_TRUE(any_shows_its_wrong_side(seams::propose_seams(pattern, {false, {0, 0, 1, 1, 0, 1}})))
      << "the back's pieces are drawn from their wrong sides";
}

/// Edges: hem, side, raglan line, neck, raglan line, side.
pattern::Panel raglan_body(const std::string& name, double neck, double top) {
  return piece(name, {{-260, 0},
                      {260, 0},
                      {260, 380, Vec2{190, 400}, Vec2{100, 520}},
                      {65, top, Vec2{45, neck}, Vec2{-45, neck}},
                      {-65, top, Vec2{-100, 520}, Vec2{-190, 400}},
                      {-260, 380}});
}

/// What is set into it, from half of its hem's width and the hem's height. Edges: hem, side, raglan line,
/// upper end, raglan line, side.
pattern::Panel raglan_sleeve(double half_hem, double hem) {
  return piece("Sleeve", {{-half_hem, hem},
                          {half_hem, hem},
                          {190, 400, Vec2{140, 420}, Vec2{70, 540}},
                          {35, 690},
                          {-35, 665, Vec2{-70, 540}, Vec2{-140, 420}},
                          {-190, 400}});
}

TEST(PlainGarments, ASweatshirtHasItsBands) {
  const pattern::Panel sleeve = raglan_sleeve(100, 0);
  const pattern::Panel cuff = strip("Cuff", 180, 70);
  const WornSeams worn({raglan_body("Front", 545, 620), raglan_body("Back", 610, 640), sleeve,
                        mirrored(sleeve, "Sleeve_2"), cuff, mirrored(cuff, "Cuff_2"),
                        strip("Neck band", 430, 50), strip("Hem band", 920, 70)});
  EXPECT_TRUE(worn.has({"Sleeve.e1"}, {"Sleeve.e5"}));
  EXPECT_TRUE(worn.has({"Hem band.e1"}, {"Hem band.e3"})) << "and not to a cuff that is as high";
  EXPECT_TRUE(worn.has({"Front.e0", "Back.e0"}, {"Hem band.e2"}));
  EXPECT_TRUE(worn.takes("Sleeve.e3")) << "its upper end, at the neck band";
  EXPECT_TRUE(worn.takes("Sleeve.e0")) << "at a cuff";
}

TEST(PlainGarments, AShortRaglanSleeveStandsAndANeckbandOfRibIsStretchedOntoTheNeck) {
  const pattern::Panel sleeve = raglan_sleeve(165, 255);
  const pattern::Panel front = raglan_body("Front", 545, 620), back = raglan_body("Back", 610, 640);
  const double sides = garments::length_of(front, 3) + garments::length_of(back, 3);
  // As long as three of the four edges, by chance.
  const double band = sides + garments::length_of(sleeve, 3);
  const WornSeams worn({front, back, sleeve, mirrored(sleeve, "Sleeve_2"), strip("Neckband", band, 50)});
  EXPECT_TRUE(worn.has({"Sleeve.e1"}, {"Sleeve.e5"}));
  for (const char* edge : {"Front.e3", "Back.e3", "Sleeve.e3", "Sleeve_2.e3"})
    EXPECT_TRUE(worn.takes(edge)) << edge;
}

/// Edges: hem, side and armhole in one, shoulder, neck, shoulder, the other side.
pattern::Panel boxy(const std::string& name, double neck, bool notched) {
  pattern::Panel panel = piece(
      name,
      {{-300, 0}, {300, 0}, {300, 560}, {95, 600, Vec2{60, neck}, Vec2{-60, neck}}, {-95, 600}, {-300, 560}});
  if (notched)
    for (const double x : {-300.0, 300.0}) panel.notches.push_back({{x, 350}, 0, {}});
  return panel;
}

TEST(PlainGarments, SidesThatGoUpToTheShoulderLeaveTheArmsTheirWay) {
  const WornSeams notched({boxy("Front", 500, true), boxy("Back", 575, true)});
  EXPECT_TRUE(notched.has({"Front.e2"}, {"Back.e4"})) << "shoulders, though nearly level";
  EXPECT_TRUE(notched.has({"Front.e1"}, {"Back.e5"})) << "up to the notch";
  const WornSeams open({boxy("Front", 500, false), boxy("Back", 575, false)});
  EXPECT_TRUE(open.has({"Front.e2"}, {"Back.e4"}));
  EXPECT_FALSE(open.takes("Front.e1")) << "where nothing tells where the arm comes out it hangs as a poncho";
}

TEST(PlainGarments, SleevesWithoutACapAreSetOnAtDroppedShoulders) {
  const pattern::Panel sleeve = piece("Sleeve", {{-190, 0}, {190, 0}, {210, 150}, {-210, 150}});
  const WornSeams worn(
      {boxy("Front", 500, false), boxy("Back", 575, false), sleeve, mirrored(sleeve, "Sleeve_2")});
  EXPECT_TRUE(worn.takes("Sleeve.e2"));
  EXPECT_TRUE(worn.has({"Sleeve.e1"}, {"Sleeve.e3"}));
  EXPECT_FALSE(worn.takes("Sleeve.e0"));
  EXPECT_FALSE(worn.takes("Front.e3")) << "the neck";
  // The outlines run against each other: what goes up a front's right side begins in the sleeve's middle.
  for (const char* top : {"Sleeve.e2", "Sleeve_2.e2"}) {
    const auto [from, to] = worn.part(top, "Front.e1");
    EXPECT_TRUE(to == 0 || std::abs(from - 0.5) < 0.01) << top << " from " << from << " to " << to;
  }
  EXPECT_GT(worn.part("Sleeve.e2", "Front.e1").second + worn.part("Sleeve_2.e2", "Front.e1").second, 0);
}

/// Edges: hem, side, armhole, shoulder, neck, shoulder, armhole, side.
pattern::Panel tee(const std::string& name, double neck) {
  return piece(name, {{-270, 0},
                      {270, 0},
                      {250, 430, Vec2{190, 450}, Vec2{185, 550}},
                      {190, 610},
                      {90, 650, Vec2{60, neck}, Vec2{-60, neck}},
                      {-90, 650},
                      {-190, 610, Vec2{-185, 550}, Vec2{-190, 450}},
                      {-250, 430}});
}

TEST(PlainGarments, AGatheredCapGoesToFrontAndBack) {
  const pattern::Panel sleeve = piece("Sleeve", {{-150, 0},
                                                 {150, 0},
                                                 {185, 110, Vec2{110, 130}, Vec2{100, 240}},
                                                 {0, 245, Vec2{-100, 240}, Vec2{-110, 130}},
                                                 {-185, 110}});
  pattern::Panel whole = sleeve;  // the cap is one edge
  whole.outline.edges[2].curves.push_back(whole.outline.edges[3].curves.front());
  whole.outline.edges.erase(whole.outline.edges.begin() + 3);
  for (std::size_t e = 0; e < whole.outline.edges.size(); ++e)
    whole.outline.edges[e].id = "e" + std::to_string(e);
  const WornSeams worn({tee("Front", 560), tee("Back", 625), whole, mirrored(whole, "Sleeve_2")});
  EXPECT_TRUE(worn.has({"Sleeve.e2"}, {"Front.e2", "Back.e6"}) ||
              worn.has({"Sleeve.e2"}, {"Back.e2", "Front.e6"}));
}

TEST(PlainGarments, ABandGoesAroundTheFrontsOfARobeWhichStayOpen) {
  const pattern::Panel front = piece("Front", {{0, 0}, {320, 0}, {320, 1100}, {105, 1140}, {0, 800}});
  const pattern::Panel back = piece("Back", {{-300, 0},
                                             {300, 0},
                                             {300, 1100},
                                             {85, 1140, Vec2{50, 1120}, Vec2{-50, 1120}},
                                             {-85, 1140},
                                             {-300, 1100}});
  const pattern::Panel sleeve = piece("Sleeve", {{-205, 0}, {205, 0}, {250, 430}, {-250, 430}});
  const WornSeams worn({back, front, mirrored(front, "Front_2"), sleeve, mirrored(sleeve, "Sleeve_2"),
                        strip("Collar band", 2480, 100)});
  EXPECT_TRUE(worn.has({"Front.e3", "Front.e4", "Back.e3", "Front_2.e3", "Front_2.e4"}, {"Collar band.e2"}));
  EXPECT_FALSE(worn.has({"Front.e4"}, {"Front_2.e4"}));
  EXPECT_TRUE(worn.takes("Front.e2")) << "the shoulder";
}

TEST(PlainGarments, StrapsAreSewnByTheirEndsOverOneShoulder) {
  const auto camisole = [](const std::string& name, double top) {
    return piece(name, {{-240, 0},
                        {240, 0},
                        {225, 330, Vec2{180, 330}, Vec2{125, 360}},
                        {106, top},
                        {94, top, Vec2{50, top - 60}, Vec2{-50, top - 60}},
                        {-94, top},
                        {-106, top, Vec2{-125, 360}, Vec2{-180, 330}},
                        {-225, 330}});
  };
  const pattern::Panel strap = strip("Strap", 300, 12);
  const WornSeams worn({camisole("Front", 480), camisole("Back", 420), strap, mirrored(strap, "Strap_2")});
  for (const char* edge : {"Front.e3", "Front.e5", "Back.e3", "Back.e5"})
    EXPECT_TRUE(worn.takes(edge)) << edge;
  EXPECT_FALSE(worn.takes("Strap.e0"));
  EXPECT_FALSE(worn.takes("Strap.e2"));
  EXPECT_FALSE(worn.takes("Front.e4")) << "the neck";
}

TEST(PlainGarments, SleevesThatAreCutOnAreSewnAboveAndBelow) {
  const auto dolman = [](const std::string& name, double neck) {
    return piece(name, {{-250, 0},
                        {250, 0, Vec2{250, 250}, Vec2{280, 330}},
                        {620, 380},
                        {610, 520},
                        {95, 620, Vec2{60, neck}, Vec2{-60, neck}},
                        {-95, 620},
                        {-610, 520},
                        {-620, 380, Vec2{-280, 330}, Vec2{-250, 250}}});
  };
  const WornSeams worn({dolman("Front", 530), dolman("Back", 600)});
  EXPECT_TRUE(worn.has({"Front.e1"}, {"Back.e7"})) << "under the arm, hollow as it is";
  EXPECT_TRUE(worn.has({"Front.e3"}, {"Back.e5"})) << "over it";
  EXPECT_FALSE(worn.takes("Front.e2")) << "the wrist";
}

TEST(PlainGarments, ATShapeIsSewnBelowItsArms) {
  const auto tunic = [](const std::string& name, double neck) {
    return piece(name, {{-270, 0},
                        {270, 0},
                        {250, 450},
                        {420, 450},
                        {420, 650},
                        {90, 660, Vec2{60, neck}, Vec2{-60, neck}},
                        {-90, 660},
                        {-420, 650},
                        {-420, 450},
                        {-250, 450}});
  };
  const WornSeams worn({tunic("Front", 560), tunic("Back", 635)});
  EXPECT_TRUE(worn.has({"Front.e1"}, {"Back.e9"})) << "the side";
  EXPECT_TRUE(worn.has({"Front.e2"}, {"Back.e8"})) << "below the arm, level as a hem";
  EXPECT_TRUE(worn.has({"Front.e4"}, {"Back.e6"})) << "above it";
  EXPECT_FALSE(worn.takes("Front.e3")) << "the wrist";
  EXPECT_FALSE(worn.takes("Front.e0")) << "the hem";
}

TEST(PlainGarments, CuffsOfTrousersTakeTheHemsOfFrontAndBack) {
  const auto half = [](const std::string& name, double hem, double top) {
    return piece(name, {{0, 0},
                        {hem, 0, Vec2{hem + 10, 300}, Vec2{top, 600}},
                        {top + 60, 740, Vec2{top + 20, 755}, Vec2{top + 4, 810}},
                        {top, 970},
                        {40, 970},
                        {-10, 760, Vec2{-10, 500}, Vec2{-2, 300}}});
  };
  const pattern::Panel front = half("Front Leg", 170, 215), back = half("Back Leg", 190, 240),
                       cuff = strip("Cuff", 270, 70);
  const WornSeams worn({front, mirrored(front, "Front Leg_2"), back, mirrored(back, "Back Leg_2"), cuff,
                        mirrored(cuff, "Cuff_2")});
  EXPECT_TRUE(worn.has({"Cuff.e1"}, {"Cuff.e3"}));
  int sewn = 0;
  for (const char* edge : {"Front Leg.e0", "Back Leg.e0"}) sewn += worn.takes(edge);
  EXPECT_EQ(sewn, 2) << "both hems, gathered a little";
  EXPECT_FALSE(worn.has({"Cuff.e2"}, {"Back Leg.e0"})) << "not one of them alone";
}

TEST(PlainGarments, ASleeveIsSetIntoFrontYokeAndBack) {
  const pattern::Panel yoke =
      piece("Yoke",
            {{-200, 0}, {200, 0}, {190, 70}, {80, 110, Vec2{50, 95}, Vec2{-50, 95}}, {-80, 110}, {-190, 70}});
  const pattern::Panel back = piece("Back", {{-265, 0},
                                             {265, 0},
                                             {255, 430, Vec2{215, 445}, Vec2{205, 490}},
                                             {200, 540},
                                             {-200, 540, Vec2{-205, 490}, Vec2{-215, 445}},
                                             {-255, 430}});
  const pattern::Panel front = bodice("Front", {270, 0}, {255, 430, Vec2{205, 445}, Vec2{195, 560}},
                                      {190, 620}, {80, 660, Vec2{70, 575}});
  const pattern::Panel sleeve =
      piece("Sleeve", {{-130, 0}, {130, 0}, {192, 430, Vec2{90, 520}, Vec2{-90, 520}}, {-192, 430}});
  const WornSeams worn({yoke, back, front, sleeve, mirrored(sleeve, "Sleeve_2")});
  EXPECT_TRUE(worn.has({"Back.e3"}, {"Yoke.e0"}));
  for (const char* end : {"Yoke.e1", "Yoke.e5"}) EXPECT_TRUE(worn.takes(end)) << end << ", into a sleeve";
  EXPECT_TRUE(worn.takes("Yoke.e2") && worn.takes("Yoke.e4")) << "the shoulders";
  EXPECT_FALSE(worn.takes("Yoke.e3")) << "the neck";
}

TEST(PlainGarments, ATShapeWithAPointedNeckIsSewnAsOthers) {
  const auto tunic = [](const std::string& name, double point) {
    return piece(name, {{-300, 0},
                        {300, 0},
                        {255, 620},
                        {560, 650},
                        {550, 790},
                        {80, 830},
                        {0, point},
                        {-80, 830},
                        {-550, 790},
                        {-560, 650},
                        {-255, 620}});
  };
  const WornSeams worn({tunic("Front", 640), tunic("Back", 770)});
  EXPECT_TRUE(worn.has({"Front.e2"}, {"Back.e9"})) << "below the arm";
  EXPECT_TRUE(worn.has({"Front.e4"}, {"Back.e7"})) << "above it";
  EXPECT_FALSE(worn.takes("Front.e3")) << "the wrist";
}

TEST(PlainGarments, BandsAreTakenAtTheirWord) {
  EXPECT_EQ(seams::words_of("NECK RIB").kind, seams::PieceKind::kCollar);
  EXPECT_TRUE(seams::words_of("hem_band").hem_band);
  EXPECT_TRUE(seams::words_of("Waist Rib").hem_band);
  EXPECT_FALSE(seams::words_of("Waistband").hem_band);
  EXPECT_EQ(seams::words_of("shoulder strap").kind, seams::PieceKind::kStrap);
}

}  // namespace
}  // namespace toile
