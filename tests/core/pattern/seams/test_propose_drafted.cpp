// What proposals make of garments as drafting programs write them: pieces with the number of times that they
// are cut, darts of all forms, eased sides, bindings.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/second_layers.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::bodice;
using garments::length_of;
using garments::mirrored;
using garments::piece;
using garments::scaled;
using garments::strip;
using test::WornSeams;

std::vector<std::string> on_others(const std::vector<pattern::Panel>& panels) {
  const std::vector<char> layers = seams::lying_on_others({panels, {}});
  std::vector<std::string> names;
  for (std::size_t p = 0; p < panels.size(); ++p)
    if (layers[p]) names.push_back(panels[p].id);
  return names;
}

pattern::Panel hood(const std::string& name) {
  return piece(name, {{0, 0, Vec2{90, 40}, Vec2{150, 10}},
                      {220, 0, Vec2{170, 120}, Vec2{190, 220}},
                      {210, 320, Vec2{20, 380}, Vec2{-60, 140}}});
}

TEST(DraftedGarments, WhatIsCutTwiceAsOftenAsItIsWornLiesOnItself) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(on_others({hood("hood"), hood("hood_2"), mirrored(hood("hood"), "hood_mirrored"),
                       mirrored(hood("hood"), "hood_mirrored_2")}),
            (Names{"hood_2", "hood_mirrored_2"}));
  const auto cuff = [](const std::string& name) { return strip(name, 230, 60); };
  EXPECT_EQ(on_others({cuff("cuff_1"), cuff("cuff_2"), cuff("cuff_3"), cuff("cuff_4")}),
            (Names{"cuff_3", "cuff_4"}));
  EXPECT_EQ(on_others({strip("Collar", 400, 50), strip("Collar_mirrored", 400, 50)}),
            (Names{"Collar_mirrored"}));
  const auto yoke = [](const std::string& name) {
    return piece(name, {{-200, 0}, {200, 0}, {200, 90}, {75, 130, Vec2{0, 60}}, {-75, 130}, {-200, 90}});
  };
  EXPECT_EQ(on_others({yoke("Yoke"), yoke("Yoke_2"), strip("Collar", 400, 50), strip("Collar_2", 400, 50)}),
            (Names{"Yoke_2", "Collar_2"}));
  EXPECT_EQ(on_others({cuff("cuff_1"), cuff("cuff_2")}), Names{}) << "one for each arm";
  const pattern::Panel half =
      piece("Collar", {{0, 0}, {200, 20}, {230, 90}, {0, 60}});  // of the collar, from the middle
  EXPECT_EQ(on_others({half, mirrored(half, "Collar_mirrored")}), Names{});
  EXPECT_EQ(on_others({strip("waistband", 400, 50), strip("waistband_mirrored", 400, 50)}), Names{})
      << "it may be of two halves";
  EXPECT_EQ(on_others({strip("armBinding", 400, 50), strip("sleevePlacket", 150, 40)}),
            (Names{"armBinding", "sleevePlacket"}));
}

/// A bodice of which the front has a dart at its armhole's end and another, with curved legs, at the waist.
/// Edges of the front's half, from the middle of the hem: e0 hem, e1 and e2 the waist's dart, e3 hem, e4
/// side, e5 and e6 the dart below the arm, e7 armhole, e8 shoulder, e9 neck, e10 the middle.
pattern::Panel darted_front(const std::string& name) {
  return piece(name, {{0, 0},
                      {60, 0, Vec2{62, 60}, Vec2{85, 100}},
                      {95, 120, Vec2{105, 100}, Vec2{138, 60}},
                      {140.7, 3.9},
                      {255, -10},
                      {272, 165},
                      {130, 160},
                      {266.2, 124.4 + 95, Vec2{215, 225}, Vec2{205, 320}},
                      {215, 430},
                      {90, 470, Vec2{85, 400}, Vec2{30, 390}},
                      {0, 385}});
}

TEST(DraftedGarments, DartsWithCurvedLegsAndInCornersAreClosed) {
  pattern::Panel front = darted_front("Front");
  const auto same_leg = [&](int from, int to) {  // as drafted: both legs of one length
    return std::abs(garments::length_of(front, from) / garments::length_of(front, to) - 1);
  };
  ASSERT_LT(same_leg(1, 2), 0.05);
  // Draw the second legs to the first ones' lengths, along their own directions.
  for (const int leg : {1, 5}) {
    pattern::PanelEdge& second = front.outline.edges[leg + 1];
    const double scale = garments::length_of(front, leg) / garments::length_of(front, leg + 1);
    const Vec2 tip = second.curves[0].p0;
    pattern::CubicBezier& c = second.curves[0];
    for (Vec2* p : {&c.p1, &c.p2, &c.p3}) *p = tip + (*p - tip) * scale;
    pattern::CubicBezier& next = front.outline.edges[leg + 2].curves[0];
    const Vec2 moved = c.p3 - next.p0;
    next.p0 = c.p3;
    next.p1 = next.p1 + moved * (2.0 / 3);
    next.p2 = next.p2 + moved * (1.0 / 3);
  }
  const pattern::Panel back = piece("Back", {{0, 0},
                                             {205, -10},
                                             {215, 165, Vec2{180, 170}, Vec2{175, 300}},
                                             {190, 390},
                                             {80, 430, Vec2{70, 415}, Vec2{30, 412}},
                                             {0, 412}});
  const WornSeams worn({front, mirrored(front, "Front_2"), back, mirrored(back, "Back_2")});
  EXPECT_TRUE(worn.has({"Front.e1"}, {"Front.e2"})) << "at the waist";
  EXPECT_TRUE(worn.has({"Front.e5"}, {"Front.e6"})) << "below the arm";
  EXPECT_FALSE(worn.takes("Front.e7")) << "the armhole";
}

/// Edges: hem, side, armhole's end, slope, neck, slope, armhole's end, side.
pattern::Panel raglan_body(const std::string& name, double neck, double slope) {
  return piece(name, {{-235, 0},
                      {235, 0, Vec2{240, 130}, Vec2{255, 260}},
                      {270, 262, Vec2{250, 263}, Vec2{238, 272}},
                      {230, 284},
                      {75, 290 + slope, Vec2{40, neck}, Vec2{-40, neck}},
                      {-75, 290 + slope},
                      {-230, 284, Vec2{-238, 272}, Vec2{-250, 263}},
                      {-270, 262, Vec2{-255, 260}, Vec2{-240, 130}}});
}

void expect_raglan_sewn(double size) {
  const pattern::Panel front = raglan_body("Front", 440, 215), back = raglan_body("Back", 530, 262);
  const double front_length = garments::length_of(front, 2) + garments::length_of(front, 3);
  const double back_length = garments::length_of(back, 2) + garments::length_of(back, 3);
  // Its two slopes are drawn straight, a hundredth longer than what they are sewn to.
  const Vec2 left{-190, 540}, right{190, 540};
  const auto up = [](Vec2 from, double aside, double length) {
    const double dx = aside - from.x;
    return Vec2{aside, from.y + std::sqrt(length * length - dx * dx)};
  };
  const Vec2 front_top = up(right, 48, 1.01 * front_length), back_top = up(left, -42, 1.01 * back_length);
  const pattern::Panel sleeve = piece("Sleeve", {{-105, 0},
                                                 {105, 0},
                                                 {right.x, right.y},
                                                 {front_top.x, front_top.y},
                                                 {back_top.x, back_top.y},
                                                 {left.x, left.y}});
  const pattern::Panel whole = scaled(sleeve, size);
  const WornSeams worn({scaled(front, size), scaled(back, size), whole, mirrored(whole, "Sleeve_2")});
  EXPECT_TRUE(worn.has({"Front.e1"}, {"Back.e7"}) || worn.has({"Front.e7"}, {"Back.e1"})) << "the sides";
  for (const char* end : {"Front.e2", "Front.e6", "Back.e2", "Back.e6"})
    for (const char* other : {"Front.e2", "Front.e6", "Back.e2", "Back.e6"})
      EXPECT_FALSE(worn.has({end}, {other})) << "the arms come out between " << end << " and " << other;
  const std::vector<std::string> of_front{"Front.e2", "Front.e3"}, of_back{"Back.e2", "Back.e3"};
  EXPECT_TRUE(worn.has(of_front, {"Sleeve.e2"}) || worn.has(of_front, {"Sleeve_2.e2"}));
  EXPECT_TRUE(worn.has(of_back, {"Sleeve.e4"}) || worn.has(of_back, {"Sleeve_2.e4"})) << worn.text();
}

TEST(DraftedGarments, ARaglanSleeveTakesTheSlopeAndTheArmholesEnd) {
  expect_raglan_sewn(1);
  expect_raglan_sewn(1.5);  // an armhole's end of 80 mm
}

TEST(DraftedGarments, AFrontWhoseDartIsDrawnInsideIsEasedIntoTheBacksSide) {
  const auto front = [](const std::string& name) {  // its side, e1 and e2, bends at the dart
    return piece(name, {{10, 0},
                        {270, 0},
                        {250, 300, Vec2{256, 340}},
                        {270, 380, Vec2{225, 390}, Vec2{200, 470}},
                        {205, 560},
                        {80, 610, Vec2{60, 530}, Vec2{10, 520}},
                        {10, 520}});
  };
  const pattern::Panel right = front("frontRight"), left = mirrored(right, "frontLeft");
  const pattern::Panel back = bodice("Back", {265, 0}, {262, 345, Vec2{215, 355}, Vec2{195, 440}}, {205, 530},
                                     {80, 575, Vec2{40, 560}});
  const WornSeams worn({right, left, back});
  EXPECT_TRUE(worn.takes("Back.e1") && worn.takes("Back.e7")) << "both sides of the back";
  const std::vector<std::string> side{"frontRight.e1", "frontRight.e2"};
  EXPECT_TRUE(worn.has(side, {"Back.e1"}) || worn.has(side, {"Back.e7"})) << "as one";
  EXPECT_FALSE(worn.takes("Back.e2")) << "the armhole";
}

pattern::Panel sweater_body(const std::string& name, double neck) {
  return bodice(name, {227, 0, Vec2{230, 200}, Vec2{260, 320}}, {285, 360, Vec2{235, 375}, Vec2{220, 480}},
                {223, 605}, {88, 640, Vec2{80, neck}});
}

TEST(DraftedGarments, CuffsCloseSoThatAHandPassesAndOneBandGoesAround) {
  const pattern::Panel sleeve =
      piece("sleeve", {{-105, 0}, {105, 0}, {222, 445, Vec2{80, 500}, Vec2{90, 640}}, {-222, 445}});
  pattern::Panel cap = sleeve;
  cap.outline.edges[2].curves = {{{222, 445}, {120, 480}, {90, 595}, {0, 597}},
                                 {{0, 597}, {-90, 595}, {-120, 480}, {-222, 445}}};
  // Cut along the stretch of the rib: a cuff of 178 mm around and 96 mm high stands on its end.
  const pattern::Panel cuff = strip("cuff", 96, 178), band = strip("waistband", 770, 96);
  const WornSeams worn({sweater_body("front", 540), sweater_body("back", 620), cap,
                        mirrored(cap, "sleeve_mirrored"), cuff, mirrored(cuff, "cuff_mirrored"), band,
                        mirrored(band, "waistband_mirrored")});
  EXPECT_TRUE(worn.has({"cuff.e0"}, {"cuff.e2"})) << worn.text();
  EXPECT_FALSE(worn.has({"cuff.e1"}, {"cuff.e3"})) << "96 mm around: no hand passes";
  EXPECT_TRUE(worn.has({"front.e0", "back.e0"}, {"waistband.e0"}) ||
              worn.has({"front.e0", "back.e0"}, {"waistband.e2"}))
      << worn.text();
  EXPECT_FALSE(worn.takes("waistband_mirrored.e0")) << "it lines the other";
}

TEST(DraftedGarments, SidePartsOfAFrontGoToTheBacks) {
  const pattern::Panel front = piece("frontInside", {{-60, 0},
                                                     {60, 0, Vec2{70, 120}, Vec2{120, 200}},
                                                     {150, 390},
                                                     {80, 410, Vec2{70, 320}, Vec2{-70, 320}},
                                                     {-80, 410},
                                                     {-150, 390, Vec2{-120, 200}, Vec2{-70, 120}}});
  const pattern::Panel side = piece("frontOutside", {{0, 20},
                                                     {150, 0},
                                                     {152, 172, Vec2{115, 190}, Vec2{120, 280}},
                                                     {165, 372},
                                                     {95, 398, Vec2{-20, 220}, Vec2{-40, 140}}});
  const pattern::Panel back = piece("backInside", {{0, 0},
                                                   {100, 0, Vec2{98, 150}, Vec2{110, 280}},
                                                   {150, 385},
                                                   {82, 405, Vec2{70, 385}, Vec2{40, 380}},
                                                   {0, 380}});
  const pattern::Panel back_side = piece("backOutside", {{0, 0},
                                                         {98, 0},
                                                         {100, 172, Vec2{70, 190}, Vec2{65, 290}},
                                                         {92, 362},
                                                         {22, 385, Vec2{-10, 280}, Vec2{-8, 150}}});
  const WornSeams worn({front, side, mirrored(side, "frontOutside_mirrored"), back,
                        mirrored(back, "backInside_mirrored"), back_side,
                        mirrored(back_side, "backOutside_mirrored")});
  EXPECT_TRUE(worn.has({"frontOutside.e1"}, {"backOutside.e1"}) ||
              worn.has({"frontOutside.e1"}, {"backOutside_mirrored.e1"}))
      << worn.text();
  EXPECT_FALSE(worn.takes("frontOutside.e2")) << "the armhole";
}

/// A T-shirt whose hem happens to be as long as a sleeve's cap: the cap has no partner there, and is parted
/// between front and back as any other.
TEST(DraftedGarments, ACapThatIsAsLongAsAHemIsSetIn) {
  const auto body = [](const std::string& name, double half, double neck) {
    return bodice(name, {half, 0}, {half, 287, Vec2{half - 45, 300}, Vec2{half - 72, 390}}, {half - 48, 485},
                  {78, 515, Vec2{70, neck}});
  };
  const double armhole = length_of(body("probe", 242, 440), 2);
  const pattern::Panel front = body("front", armhole, 440), back = body("back", armhole, 500);
  const auto sleeve = [](double size) {
    return piece("sleeve",
                 {{-97 * size, 0},
                  {97 * size, 0},
                  {162 * size, 468 * size, Vec2{80 * size, 480 * size}, Vec2{75 * size, 594 * size}},
                  {0, 594 * size, Vec2{-75 * size, 594 * size}, Vec2{-80 * size, 480 * size}},
                  {-162 * size, 468 * size}});
  };
  pattern::Panel set_in = sleeve(1);
  set_in = sleeve(2 * armhole / (length_of(set_in, 2) + length_of(set_in, 3)));
  auto& edges = set_in.outline.edges;
  edges[2].curves.push_back(edges[3].curves[0]);  // the cap is one edge
  edges.erase(edges.begin() + 3);
  for (std::size_t k = 0; k < edges.size(); ++k) edges[k].id = "e" + std::to_string(k);
  ASSERT_NEAR(length_of(set_in, 2), length_of(front, 0), 1);
  const WornSeams worn({front, back, set_in, mirrored(set_in, "sleeve_mirrored")});
  EXPECT_TRUE(worn.takes("front.e2") && worn.takes("front.e6") && worn.takes("back.e2") &&
              worn.takes("back.e6"))
      << worn.text();
  EXPECT_FALSE(worn.takes("front.e0") || worn.takes("back.e0")) << worn.text();
}

/// Shoulders are straight, and all straight edges else that differ are drawn to be sewn to others.
TEST(DraftedGarments, TheBacksShoulderIsEasedOntoTheFronts) {
  const auto merit = [](double front, double back) {
    const auto body = [](const std::string& name, double shoulder, double neck) {
      return bodice(name, {250, 0}, {255, 345, Vec2{215, 355}, Vec2{195, 440}}, {70 + shoulder, 530},
                    {70, 545, Vec2{40, neck}});
    };
    const pattern::Pattern pattern{{body("Front", front, 470), body("Back", back, 535)}, {}};
    const seams::SeamModel model = seams::make_seam_model(pattern);
    return seams::pair_merit(model, 3, 8 + 5)[0];
  };
  EXPECT_GT(merit(130, 135), merit(135, 130) + 1);
  EXPECT_GT(merit(130, 135), merit(130, 150) + 1) << "by so much nothing is eased there";
}

}  // namespace
}  // namespace toile
