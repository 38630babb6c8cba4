// What single rules say of pairs of edges, and of what pieces are.

#include <gtest/gtest.h>

#include "core/pattern/seams/second_layers.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/pattern/seams/cuts.h"
#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/mirror_images.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/notch_cuts.h"
#include "core/pattern/seams/vents.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::bodice;
using garments::length_of;
using garments::mirrored;
using garments::piece;
using garments::strip;
using seams::PieceKind;
using seams::SeamModel;
using seams::SeamProposal;

SeamModel model_of(const std::vector<pattern::Panel>& panels) { return seams::make_seam_model({panels, {}}); }

Index run_of(const SeamModel& m, Index panel, Index edge) {
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r)
    if (m.runs[r].panel == panel && m.runs[r].edge == edge) return r;
  return kNone;
}

double best_merit(const SeamModel& m, Index a, Index b) {
  const std::array<double, 2> both = seams::pair_merit(m, a, b);
  return std::max(both[0], both[1]);
}

/// Steep slopes. Edges: hem, side, armhole's end, slope, neck, slope, armhole's end, side.
pattern::Panel raglan_body(const std::string& name, double neck) {
  return piece(name, {{-250, 0},
                      {250, 0},
                      {262, 262, Vec2{246, 262}, Vec2{236, 272}},
                      {226, 286},
                      {70, 520, Vec2{40, neck}, Vec2{-40, neck}},
                      {-70, 520},
                      {-226, 286, Vec2{-236, 272}, Vec2{-246, 262}},
                      {-262, 262}});
}

/// Edges: hem, side, slope, upper end, slope, side.
pattern::Panel raglan_sleeve() {
  return piece("sleeve", {{-110, 0}, {110, 0}, {200, 400}, {30, 655}, {-30, 680}, {-200, 400}});
}

/// Half a hood. Edges: neck, back and top, around the face.
pattern::Panel hood() {
  return piece("hood",
               {{0, 0}, {210, 0, Vec2{330, 160}, Vec2{250, 330}}, {20, 330, Vec2{90, 220}, Vec2{70, 90}}});
}

std::vector<pattern::Panel> hooded_raglan() {
  return {raglan_body("front", 430),
          raglan_body("back", 500),
          raglan_sleeve(),
          mirrored(raglan_sleeve(), "sleeve_mirrored"),
          hood(),
          mirrored(hood(), "hood_mirrored")};
}

TEST(PairRules, TheEndOfAnArmholeGoesUnderTheArm) {
  const SeamModel m = model_of(hooded_raglan());
  const Index end = run_of(m, 0, 2), other = run_of(m, 1, 6);
  EXPECT_LT(best_merit(m, end, other), 2) << "the arms come out between them";
  EXPECT_GT(best_merit(m, run_of(m, 0, 1), run_of(m, 1, 7)), 4) << "the sides";
  EXPECT_TRUE(seams::never_sewn(m, end, run_of(m, 2, 3))) << "a sleeve's upper end is at the neck";
  EXPECT_FALSE(seams::never_sewn(m, end, run_of(m, 2, 2))) << "its slope goes down to the side";
  EXPECT_TRUE(seams::never_sewn(m, end, run_of(m, 4, 0))) << "a hood";
}

/// Of large sizes that end is long.
TEST(PairRules, ARaglanSleeveIsEasedOntoTheSlopeAndTheArmholesEndOfAnySize) {
  for (const double size : {1.0, 1.8}) {
    const pattern::Panel body = garments::scaled(raglan_body("front", 430), size);
    const double armhole = length_of(body, 2) + length_of(body, 3);
    const pattern::Panel sleeve =
        garments::scaled(raglan_sleeve(), 1.01 * armhole / length_of(raglan_sleeve(), 2));
    const pattern::Pattern pattern{{body, sleeve, mirrored(sleeve, "sleeve_mirrored")}, {}};
    const SeamModel m =
        seams::with_likely_cuts(pattern, seams::make_seam_model(pattern), seams::CutKind::kExactFirst);
    EXPECT_NEAR(m.runs[run_of(m, 1, 2)].to, length_of(body, 2) / armhole, 0.01) << size;
  }
}

TEST(PairRules, NoSleeveIsSetIntoAHem) {
  const pattern::Panel sleeve =
      piece("sleeve", {{-100, 0}, {100, 0}, {190, 400, Vec2{120, 560}, Vec2{-120, 560}}, {-190, 400}});
  const SeamModel m = model_of({raglan_body("front", 430), sleeve});
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 0, 0), run_of(m, 1, 2)));
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 0, 3), run_of(m, 1, 2)));
}

TEST(PairRules, ANeckThatGoesThroughSleevesIsSewnAsAWhole) {
  const SeamModel m = model_of(hooded_raglan());
  ASSERT_TRUE(m.raglan);
  std::vector<pattern::Panel> cropped = hooded_raglan();
  cropped[2] = piece("sleeve", {{-110, 0},
                                {110, 0},
                                {200, 400, Vec2{120, 420}, Vec2{100, 655}},
                                {0, 655, Vec2{-100, 655}, Vec2{-120, 420}},
                                {-200, 400}});
  cropped[3] = mirrored(cropped[2], "sleeve_mirrored");
  const SeamModel set_in = model_of(cropped);
  ASSERT_FALSE(set_in.raglan);
  const auto merit = [](const SeamModel& model) {
    return best_merit(model, run_of(model, 0, 4), run_of(model, 4, 0));
  };
  EXPECT_LT(merit(m), merit(set_in) - 3) << "the front's neck alone, at half of the hood";
}

TEST(PairRules, AHoodStaysOpenAroundTheFace) {
  const SeamModel m = model_of(hooded_raglan());
  const auto merit = [&](Index edge) {
    const seams::SeamRun& run = m.runs[run_of(m, 4, edge)];
    return seams::twin_merit(m, run, 1);
  };
  EXPECT_LT(merit(2), -5) << "its hollow edge";
  EXPECT_GE(merit(1), 0) << "its round one goes over the head";
}

/// Half of trousers' back with a dart in its waist and a hollow side. Edges: hem, inner leg, crotch, waist,
/// two legs of the dart, waist, side.
pattern::Panel darted_back() {
  return piece("back", {{0, 0},
                        {260, 0, Vec2{270, 500}},
                        {320, 720, Vec2{235, 740}, Vec2{215, 850}},
                        {200, 1040},
                        {120, 1025},
                        {108, 940},
                        {96, 1020},
                        {20, 1005, Vec2{-20, 800}, Vec2{20, 500}}});
}

/// The same with a straight waist. Edges: hem, inner leg, crotch, waist, side.
pattern::Panel plain_back() {
  return piece("back", {{0, 0},
                        {260, 0, Vec2{270, 500}},
                        {320, 720, Vec2{235, 740}, Vec2{215, 850}},
                        {200, 1040},
                        {20, 1005, Vec2{95, 800}, Vec2{95, 500}}});
}

/// Edges: hem, inner leg, crotch, waist, side.
pattern::Panel leg_front() {
  return piece("front", {{0, 0},
                         {210, 0, Vec2{215, 500}},
                         {262, 720, Vec2{195, 735}, Vec2{185, 850}},
                         {180, 1000},
                         {10, 990, Vec2{-30, 800}, Vec2{0, 500}}});
}

std::vector<pattern::Panel> trousers_with(const pattern::Panel& back, double band) {
  return {leg_front(), mirrored(leg_front(), "front_mirrored"), back, mirrored(back, "back_mirrored"),
          strip("waistband", band, 40)};
}

TEST(PairRules, TrousersThatNameNoLegsAreKnownByTheirCrotch) {
  for (const pattern::Panel& back : {darted_back(), plain_back()}) {
    const SeamModel m = model_of(trousers_with(back, 740));
    for (Index p = 0; p < 4; ++p)
      EXPECT_EQ(m.words[p].kind, PieceKind::kLegs) << back.outline.edges.size() << " edges, piece " << p;
  }
}

/// The same drawn with a corner in its crotch. Edges: hem, inner leg, end of the crotch, middle, waist, side.
pattern::Panel parted_front() {
  return piece("front", {{0, 0},
                         {210, 0, Vec2{215, 500}},
                         {262, 720, Vec2{258, 722}, Vec2{242, 727}},
                         {238, 732, Vec2{200, 760}, Vec2{182, 850}},
                         {180, 1000},
                         {10, 990, Vec2{-30, 800}, Vec2{0, 500}}});
}

TEST(PairRules, ACrotchMayHaveACornerAndAnklesMayHaveCuffs) {
  std::vector<pattern::Panel> panels{
      parted_front(),         mirrored(parted_front(), "front_mirrored"),
      plain_back(),           mirrored(plain_back(), "back_mirrored"),
      strip("cuff", 265, 80), mirrored(strip("cuff", 265, 80), "cuff_mirrored")};
  const SeamModel m = model_of(panels);
  for (Index p = 0; p < 4; ++p) EXPECT_EQ(m.words[p].kind, PieceKind::kLegs) << p;
  EXPECT_TRUE(m.words[4].leg) << "the cuff's";
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 4, 2), run_of(m, 0, 0))) << "at the hem";
  EXPECT_LT(seams::pair_merit(m, run_of(m, 4, 0), run_of(m, 0, 4))[0], 0) << "and not at the waist";
}

TEST(PairRules, YokesOfLegsMeetAtTheirDeeperEnds) {
  const pattern::Panel yoke = piece("back yoke", {{0, 0}, {238, 30}, {225, 73}, {2, 70}});
  const auto never = [&](int edge, std::vector<pattern::Panel> panels) {
    const auto first = static_cast<Index>(panels.size());
    panels.push_back(yoke);
    panels.push_back(mirrored(yoke, "back yoke_mirrored"));
    const SeamModel m = model_of(panels);
    const Index r = run_of(m, first, edge);
    return seams::never_sewn(m, r, m.mirror[r]);
  };
  const std::vector<pattern::Panel> legs = trousers_with(plain_back(), 740);
  EXPECT_TRUE(never(1, legs)) << "45 mm: a side";
  EXPECT_FALSE(never(3, legs)) << "70 mm: the middle";
  EXPECT_FALSE(never(1, {strip("skirt", 900, 500)})) << "of a skirt either may be";
}

TEST(PairRules, AWaistbandEndsNoLegs) {
  const SeamModel m = model_of(trousers_with(plain_back(), 740));
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 4, 2), run_of(m, 0, 0))) << "its upper edge at a hem";
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 4, 0), run_of(m, 0, 3))) << "its lower one at a waist";
}

/// The band is as long as the legs' sides, to which it is never sewn: that parts no waist.
TEST(PairRules, LengthsOfWhatIsNeverSewnTogetherPartNothing) {
  const double waist = length_of(leg_front(), 3);
  const auto cuts_of_waist = [&](double band) {
    std::vector<pattern::Panel> panels = trousers_with(plain_back(), band);
    const pattern::CubicBezier& along = panels[0].outline.edges[3].curves[0];
    panels[0].notches.push_back({(along.p0 * 2 + along.p3) * (1.0 / 3), 0, {}});
    panels[1].notches.push_back({{-panels[0].notches[0].at.x, panels[0].notches[0].at.y}, 0, {}});
    for (const double x : {waist, waist + waist / 3, band - waist - waist / 3, band - waist})
      panels[4].notches.push_back({{x, 0}, 0, {}});
    const SeamModel m = model_of(panels);
    return seams::notch_cuts(m)[run_of(m, 0, 3)];
  };
  EXPECT_TRUE(cuts_of_waist(740).empty());
  EXPECT_TRUE(cuts_of_waist(length_of(leg_front(), 4)).empty()) << "as long as a side";
}

/// The armhole of a front and that of a back are of one length, as those of a top with a cowl.
TEST(PairRules, NoPartOfAnArmholeIsSewnToOneOfAnother) {
  const auto body = [](const std::string& name, double neck) {
    return bodice(name, {250, 0}, {262, 330, Vec2{200, 345}, Vec2{200, 470}}, {215, 530},
                  {80, 560, Vec2{70, neck}});
  };
  pattern::Pattern pattern{{body("front", 470), body("back", 545)}, {}};
  const pattern::PanelEdge& armhole = pattern.panels[0].outline.edges[2];
  const Vec2 notch = pattern::point_at_length(armhole, 0.55 * pattern::arc_length(armhole));
  pattern.panels[0].notches.push_back({notch, 0, {}});
  pattern.panels[1].notches.push_back({{-notch.x, notch.y}, 0, {}});
  SeamModel m = seams::make_seam_model(pattern);
  const Index front = run_of(m, 0, 2), back = run_of(m, 1, 6);
  for (const Index r : {front, back}) {
    ASSERT_EQ(m.runs[r].notches.size(), 1u);
    m = seams::with_cuts(pattern, m, r, {m.runs[r].notches[0]});
  }
  ASSERT_GT(m.runs[back].turn.back(), -30) << "this part alone hardly bends";
  EXPECT_LT(best_merit(m, m.runs[front].next, back), -4);
}

TEST(PairRules, ACollarOnAStandIsNotSewnToTheBack) {
  const pattern::Panel back =
      bodice("back", {250, 0, Vec2{215, 160}}, {255, 320, Vec2{215, 330}, Vec2{195, 400}}, {190, 440},
             {80, 470, Vec2{60, 450}});
  const SeamModel m = model_of({back, strip("collar stand", 400, 30), strip("collar", 400, 60)});
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 0, 4), run_of(m, 2, 0)));
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 0, 4), run_of(m, 1, 0)));
  const SeamModel alone = model_of({back, strip("collar", 400, 60)});
  EXPECT_FALSE(seams::never_sewn(alone, run_of(alone, 0, 4), run_of(alone, 1, 0)));
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 2, 1), run_of(m, 2, 3))) << "nor closed in front";
  EXPECT_FALSE(seams::never_sewn(alone, run_of(alone, 1, 1), run_of(alone, 1, 3)));
}

TEST(PairRules, APartOfAHollowNeckIsNoShoulderHoweverStraight) {
  const pattern::Panel half = piece("back_l", {{0, 0},
                                               {250, 0},
                                               {245, 380, Vec2{190, 390}, Vec2{185, 430}},
                                               {200, 600},
                                               {85, 645, Vec2{70, 620}, Vec2{60, 620}},
                                               {0, 620}});
  const pattern::Pattern pattern{{half, strip("hood middle", 90, 400)}, {}};
  SeamModel m = seams::make_seam_model(pattern);
  const Index neck = run_of(m, 0, 4);
  ASSERT_LT(m.runs[neck].turn.back(), -30);
  m = seams::with_cuts(pattern, m, neck, {m.runs[neck].length - 48});
  const Index part = m.runs[neck].next;
  ASSERT_GT(m.runs[part].turn.back(), -6) << "straight, and it lies on a slope as shoulders do";
  EXPECT_FALSE(seams::never_sewn(m, part, run_of(m, 1, 0)));
}

TEST(PairRules, CollarsLieOnNoHemAndOnNoSide) {
  const pattern::Panel back =
      bodice("back", {250, 0, Vec2{215, 160}}, {255, 320, Vec2{215, 330}, Vec2{195, 400}}, {190, 440},
             {185, 445, Vec2{60, 444}});
  const pattern::Panel yoke =
      piece("yoke",
            {{-200, 0}, {200, 0}, {205, 90}, {80, 120, Vec2{70, 95}, Vec2{-70, 95}}, {-80, 120}, {-205, 90}});
  const SeamModel m = model_of({back, yoke, strip("collar stand", 400, 30)});
  const Index collar = run_of(m, 2, 0);
  EXPECT_TRUE(seams::never_sewn(m, collar, run_of(m, 1, 0))) << "the yoke's hem";
  EXPECT_TRUE(seams::never_sewn(m, collar, run_of(m, 1, 2))) << "its shoulder";
  EXPECT_FALSE(seams::never_sewn(m, collar, run_of(m, 1, 3))) << "its neck";
  EXPECT_TRUE(seams::never_sewn(m, collar, run_of(m, 0, 1))) << "the back's side";
}

SeamProposal proposal(std::vector<pattern::SeamEdge> a, std::vector<pattern::SeamEdge> b, double confidence) {
  SeamProposal p;
  p.seam.a = std::move(a);
  p.seam.b = std::move(b);
  p.confidence = confidence;
  return p;
}

TEST(MirrorImages, AreToldWhereNothingWantsTheirEdges) {
  const pattern::Pattern pattern{trousers_with(plain_back(), 740), {}};
  // The inner seam of one leg, and its waist at the band's start. Mirrored outlines run the other way round.
  const std::vector<SeamProposal> told{proposal({{0, 1}}, {{2, 1}}, 0.9),
                                       proposal({{0, 3}}, {{4, 0, false, 0.1, 0.3}}, 0.8)};
  const std::vector<SeamProposal> all = seams::with_mirror_images(pattern, told);
  ASSERT_EQ(all.size(), 4u);
  const SeamModel m = seams::make_seam_model(pattern);
  const SeamProposal& inner = all[1];
  EXPECT_NEAR(inner.confidence, 0.95 * 0.9, 1e-9);
  EXPECT_EQ(inner.seam.a[0].panel, 1);
  EXPECT_EQ(inner.seam.a[0].edge, m.runs[run_of(m, 0, 1)].mirror_edge);
  EXPECT_EQ(inner.seam.b[0].panel, 3);
  EXPECT_FALSE(inner.seam.same_direction || inner.seam.a[0].reversed || inner.seam.b[0].reversed);
  EXPECT_EQ(all[3].seam.b[0].panel, 4);
  EXPECT_NEAR(all[3].seam.b[0].from, 0.7, 1e-9);
  EXPECT_NEAR(all[3].seam.b[0].to, 0.9, 1e-9);
}

TEST(MirrorImages, AreNotToldOfWhatIsTakenOrInDoubt) {
  const pattern::Pattern pattern{trousers_with(plain_back(), 740), {}};
  const SeamModel m = seams::make_seam_model(pattern);
  const Index inner = m.runs[run_of(m, 0, 1)].mirror_edge;
  const std::vector<SeamProposal> taken{proposal({{0, 1}}, {{2, 1}}, 0.9),
                                        proposal({{1, inner}}, {{4, 0, false, 0, 0.5}}, 0.6)};
  EXPECT_EQ(seams::with_mirror_images(pattern, taken).size(), 2u);
  EXPECT_EQ(seams::with_mirror_images(pattern, {proposal({{0, 1}}, {{2, 1}}, 0.6)}).size(), 1u);
  const std::vector<SeamProposal> both{proposal({{0, 1}}, {{2, 1}}, 0.9),
                                       proposal({{3, inner}}, {{1, inner}}, 0.4)};
  const std::vector<SeamProposal> surer = seams::with_mirror_images(pattern, both);
  ASSERT_EQ(surer.size(), 2u) << "told already";
  EXPECT_NEAR(surer[1].confidence, 0.95 * 0.9, 1e-9);
}

/// A skirt of six gores that only its waistband tells to be one: middles, then sides, front and back, then
/// the band. Edges: hem, side, waist, side.
std::vector<pattern::Panel> six_gores() {
  std::vector<pattern::Panel> panels;
  for (const std::string face : {"front", "back"}) {
    panels.push_back(piece("center_" + face, {{0, 0}, {260, 0}, {200, 640}, {60, 640}}));
    panels.push_back(piece("side_" + face, {{0, 0}, {260, 0}, {190, 640}, {66, 640}}));
    panels.push_back(mirrored(panels.back(), "side_" + face + "_mirrored"));
  }
  panels.push_back(strip("waistband", 770, 60));
  return panels;
}

TEST(PairRules, GoresGoToTheNearestOfTheirFace) {
  const SeamModel m = model_of(six_gores());
  for (Index p = 0; p < 6; ++p) EXPECT_EQ(m.words[p].kind, PieceKind::kSkirt) << p;
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 0, 1), run_of(m, 3, 3))) << "middle of the front to the back's";
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 0, 1), run_of(m, 4, 3))) << "to the side of the back";
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 1, 1), run_of(m, 3, 3)));
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 0, 1), run_of(m, 1, 3)));
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 1, 1), run_of(m, 4, 3))) << "sides to sides";
}

TEST(PairRules, PiecesUnderAWaistbandThatHaveACrotchAreNoSkirt) {
  std::vector<pattern::Panel> panels = six_gores();
  panels[2] = piece("side_front_x", {{0, 0}, {220, 0}, {250, 720, Vec2{195, 745}}, {185, 980}, {20, 990}});
  const SeamModel m = model_of(panels);
  EXPECT_EQ(m.words[0].kind, PieceKind::kOther);
}

/// Halves of a waistcoat whose fronts end in points. Edges of the front: hem, side, armhole, shoulder, neck,
/// middle, point; of the back: hem, side, armhole, shoulder, neck, middle. `notch`: mm above the hems.
std::vector<pattern::Panel> waistcoat(double notch) {
  pattern::Panel front = piece("front", {{70, 0},
                                         {280, 60},
                                         {290, 350, Vec2{220, 360}, Vec2{225, 430}},
                                         {230, 560},
                                         {100, 620, Vec2{80, 480}},
                                         {0, 380},
                                         {0, 55}});
  pattern::Panel back = piece("back", {{10, 60},
                                       {285, 60},
                                       {295, 350, Vec2{225, 360}, Vec2{225, 430}},
                                       {230, 560},
                                       {90, 620, Vec2{70, 595}},
                                       {0, 595}});
  const auto mark = [&](pattern::Panel& panel, double x) { panel.notches = {{{x, 60 + notch}, 0, {}}}; };
  mark(front, 280 + notch * 10 / 290);
  mark(back, 285 + notch * 10 / 290);
  return {front, mirrored(front, "front_mirrored"), back, mirrored(back, "back_mirrored")};
}

TEST(PairRules, NoHemIsSewnToANeck) {
  const SeamModel m = model_of(waistcoat(100));
  EXPECT_NEAR(m.runs[run_of(m, 0, 6)].length, m.runs[run_of(m, 2, 4)].length, 8) << "they are like by chance";
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 0, 6), run_of(m, 2, 4)));
  EXPECT_TRUE(seams::never_sewn(m, run_of(m, 0, 6), run_of(m, 3, 2)));
  EXPECT_FALSE(seams::never_sewn(m, run_of(m, 0, 1), run_of(m, 2, 1)));
}

TEST(PairRules, ASideIsNotPartedByANotchThatIsAsFarUpAsANeckIsLong) {
  const std::vector<pattern::Panel> plain = waistcoat(100);
  const double neck = length_of(plain[2], 4);
  const SeamModel m = model_of(waistcoat(neck));
  const Index side = run_of(m, 0, 1);
  ASSERT_EQ(m.runs[side].notches.size(), 1u);
  EXPECT_NEAR(m.runs[side].notches[0], neck, 0.5);
  EXPECT_TRUE(seams::notch_cuts(m)[side].empty());
}

TEST(PairRules, ASleeveWhoseGrainLineRunsDownStandsOnItsWristAllTheSame) {
  pattern::Panel sleeve =
      piece("sleeve", {{-100, 0}, {100, 0}, {190, 400, Vec2{120, 560}, Vec2{-120, 560}}, {-190, 400}});
  for (const double sense : {1.0, -1.0}) {
    sleeve.grain = {0, sense};
    const SeamModel m = model_of({raglan_body("front", 430), sleeve});
    EXPECT_GT(m.runs[run_of(m, 1, 2)].up, 0.9) << sense;
    EXPECT_GT(m.up[1].y, 0.9) << sense;
  }
}

TEST(SecondLayers, AYokesLiningIsFoundWhereItsGrainLineIsDrawnAslant) {
  pattern::Panel yoke =
      piece("YOKE BACK", {{-200, 0}, {200, 0}, {205, 90}, {90, 120}, {0, 105}, {-90, 120}, {-205, 90}});
  yoke.grain = normalized(Vec2{0.06, 1});
  pattern::Panel lining = yoke;
  lining.id = "YOKE BACK_2";
  const auto front = piece("FRONT", {{-250, 0}, {250, 0}, {240, 400}, {200, 560}, {-200, 560}, {-240, 400}});
  const std::vector<char> layers = seams::lying_on_others({{front, yoke, lining}, {}});
  EXPECT_EQ(layers, (std::vector<char>{0, 0, 1}));
}

TEST(SecondLayers, ASailorsCollarIsDeepAndCutTwice) {
  const pattern::Panel collar = piece("sailor collar", {{-180, 0},
                                                        {180, 0},
                                                        {200, 250},
                                                        {60, 420},
                                                        {75, 250, Vec2{40, 200}, Vec2{-40, 200}},
                                                        {-75, 250},
                                                        {-60, 420},
                                                        {-200, 250}});
  pattern::Panel under = collar;
  under.id = "sailor collar_2";
  const auto front = piece("FRONT", {{-250, 0}, {250, 0}, {240, 400}, {200, 560}, {-200, 560}, {-240, 400}});
  EXPECT_EQ(seams::lying_on_others({{front, collar, under}, {}}), (std::vector<char>{0, 0, 1}));
}

}  // namespace
}  // namespace toile
