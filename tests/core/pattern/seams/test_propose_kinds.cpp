// What names that tell kinds of pieces make of proposals.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/seams/confidence.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/propose.h"
#include "core/pattern/validate.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using seams::SeamProposal;

pattern::Panel sheet(const std::string& id, double hem, double top, double height) {
  return garments::piece(id, {{0, 0}, {hem, 0}, {(hem + top) / 2, height}, {(hem - top) / 2, height}});
}

/// The most sure proposal that joins edges of the two pieces; none: 0.
double surest(const pattern::Pattern& pattern, const std::vector<SeamProposal>& proposals,
              const std::string& a, const std::string& b) {
  double most = 0;
  for (const SeamProposal& p : proposals) {
    const std::string& x = pattern.panels[p.seam.a[0].panel].id;
    const std::string& y = pattern.panels[p.seam.b[0].panel].id;
    if ((x == a && y == b) || (x == b && y == a)) most = std::max(most, p.confidence);
  }
  return most;
}

TEST(ProposeByKinds, HangASkirtFromTheBandAndTheBandFromTheBodice) {
  // The skirt is gathered to the band; its upper edge is as long as the bodice's lower one.
  const pattern::Pattern pattern{
      {sheet("bodice_front", 500, 420, 350), sheet("bodice_back", 480, 420, 350),
       sheet("waistband_front", 380, 380, 50), sheet("waistband_back", 370, 370, 50),
       sheet("skirt_front", 700, 500, 600), sheet("skirt_back", 690, 480, 600)},
      {}};
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  for (const std::string face : {"front", "back"}) {
    EXPECT_GT(surest(pattern, proposals, "bodice_" + face, "waistband_" + face), 0.8) << face;
    EXPECT_GT(surest(pattern, proposals, "waistband_" + face, "skirt_" + face), 0.8) << face;
    EXPECT_EQ(surest(pattern, proposals, "bodice_" + face, "skirt_" + face), 0) << face;
  }
}

TEST(ProposeByKinds, SewABriefsCrotchBetweenTheOpeningsForTheLegs) {
  const auto brief = [](const std::string& id, double crotch) {
    return garments::piece(id, {{-40, -crotch},
                                {40, -crotch, Vec2{60, -crotch + 90}, Vec2{170, -150}},
                                {215, -110},
                                {205, 0},
                                {-205, 0},
                                {-215, -110, Vec2{-170, -150}, Vec2{-60, -crotch + 90}}});
  };
  const pattern::Pattern pattern{{brief("front", 300), brief("back", 330)}, {}};
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  EXPECT_TRUE(std::any_of(proposals.begin(), proposals.end(), [](const SeamProposal& p) {
    return p.confidence > 0.8 && p.seam.a[0].edge == 0 && p.seam.b[0].edge == 0;
  }));
}

TEST(ProposeByKinds, SewTheLevelShouldersOfACapeLeftToLeft) {
  const auto cape = [](const std::string& id, double neck) {
    return garments::piece(id, {{-750, 0, Vec2{-750, -1000}, Vec2{750, -1000}},
                                {750, 0},
                                {95, 0, Vec2{60, -neck}, Vec2{-60, -neck}},
                                {-95, 0}});
  };
  const pattern::Pattern pattern{{cape("front", 130), cape("back", 90)}, {}};
  int shoulders = 0;
  for (const SeamProposal& p : seams::propose_seams(pattern, {true})) {
    if (p.confidence < 0.8) continue;
    EXPECT_EQ(p.seam.a[0].edge + p.seam.b[0].edge, 4) << "e1 to e3";
    ++shoulders;
  }
  EXPECT_EQ(shoulders, 2);
}

TEST(ProposeByKinds, NeverHangAFrontFromItsBack) {
  // The back's hem is by chance as long as the front's waist, the front's inner leg a little shorter.
  const auto half = [](const std::string& id, double waist, double hem, double crotch) {
    return garments::piece(id, {{10, -1000},
                                {10 + hem, -1000, Vec2{235, -500}, Vec2{245, -180}},
                                {5 + waist, 0},
                                {5, 0, Vec2{-10, -210}, Vec2{crotch + 40, -270}},
                                {crotch, -285, Vec2{crotch + 40, -400}, Vec2{10, -700}}});
  };
  const pattern::Panel front = half("Front L", 205, 190, -60), back = half("Back R", 230, 205, -110);
  const pattern::Pattern pattern{
      {front, garments::mirrored(front, "Front R"), back, garments::mirrored(back, "Back L")}, {}};
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  EXPECT_GT(surest(pattern, proposals, "Front L", "Front R"), 0.8);
  EXPECT_GT(surest(pattern, proposals, "Back L", "Back R"), 0.8);
  EXPECT_GT(surest(pattern, proposals, "Front L", "Back L"), 0.8);
  for (const SeamProposal& p : proposals)
    EXPECT_FALSE(p.confidence > 0.5 && (p.seam.a[0].edge == 0 || p.seam.b[0].edge == 0)) << "hems";
}

TEST(PieceWords, TheSideOfAHoodIsNoFlank) {
  EXPECT_FALSE(seams::words_of("Hood Side").flank);
  EXPECT_TRUE(seams::words_of("Side Front").flank);
}

/// The half of a bodice's front or back that lies right of its middle at x = 0, seen from outside: of a front
/// the wearer's left, of a back the right. Edges: hem, side, armhole, shoulder, neck, middle.
pattern::Panel half_bodice(const std::string& id, double hem, double neck) {
  return garments::piece(id, {{0, 0},
                              {hem, 0},
                              {hem - 20, 250, Vec2{hem - 100, 260}},
                              {hem - 50, 430},
                              {90, 460, Vec2{85, neck}},
                              {0, neck}});
}

/// The most sure proposal that joins one edge of the piece to edges of just the others; none: 0.
double sharing(const pattern::Pattern& pattern, const std::vector<SeamProposal>& proposals,
               const std::string& piece, const std::set<std::string>& others) {
  const auto pieces = [&](const std::vector<pattern::SeamEdge>& side) {
    std::set<std::string> ids;
    for (const pattern::SeamEdge& e : side) ids.insert(pattern.panels[e.panel].id);
    return ids;
  };
  double most = 0;
  for (const SeamProposal& p : proposals)
    for (const auto& [one, more] : {std::pair(&p.seam.a, &p.seam.b), std::pair(&p.seam.b, &p.seam.a)})
      if (one->size() == 1 && pieces(*one) == std::set{piece} && pieces(*more) == others)
        most = std::max(most, p.confidence);
  return most;
}

TEST(ProposeByKinds, ShareABandBetweenTheHalvesThatAreGatheredToIt) {
  // Each half is nearer to the whole band (1:1.25) than to its half of it (1.6:1).
  const pattern::Panel front = half_bodice("left_ftorso", 320, 340),
                       back = half_bodice("right_btorso", 304, 430);
  const pattern::Pattern pattern{
      {front, garments::mirrored(front, "right_ftorso"), back, garments::mirrored(back, "left_btorso"),
       sheet("wb_front", 400, 400, 60), sheet("wb_back", 380, 380, 60)},
      {}};
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  for (const std::string face : {"front", "back"}) {
    const std::string half = face.substr(0, 1) + "torso";
    EXPECT_GT(sharing(pattern, proposals, "wb_" + face, {"left_" + half, "right_" + half}), 0.8) << face;
  }
}

TEST(ProposeByKinds, HangLevelsOfASkirtInTheOrderOfTheirNumbers) {
  const pattern::Pattern pattern{
      {sheet("skirt_front", 600, 400, 250), sheet("skirt_back", 600, 400, 250),
       sheet("skirt_front_0", 900, 900, 200), sheet("skirt_back_0", 900, 900, 200),
       sheet("skirt_front_1", 1300, 1300, 180), sheet("skirt_back_1", 1300, 1300, 180)},
      {}};
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  EXPECT_GT(surest(pattern, proposals, "skirt_front", "skirt_front_0"), 0.8);
  EXPECT_GT(surest(pattern, proposals, "skirt_front_0", "skirt_front_1"), 0.8);
  EXPECT_EQ(surest(pattern, proposals, "skirt_front", "skirt_front_1"), 0);
}

TEST(ProposeByKinds, SewGoresInTheOrderOfTheirNumbers) {
  pattern::Pattern pattern;
  for (int k = 0; k < 6; ++k)
    pattern.panels.push_back(sheet("skirt_panel_" + std::to_string(k), 220, 120, 500));
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  for (int k = 0; k < 6; ++k) {
    const std::string here = "skirt_panel_" + std::to_string(k),
                      next = "skirt_panel_" + std::to_string((k + 1) % 6);
    EXPECT_GT(surest(pattern, proposals, here, next), 0.5) << here;
  }
  EXPECT_EQ(surest(pattern, proposals, "skirt_panel_0", "skirt_panel_2"), 0);
}

TEST(ProposeByKinds, DoNotSayHowFarARingOfGoresIsTurnedInItsBand) {
  // Seven gores in a band of two pieces: its side seams meet no more than one of theirs.
  pattern::Pattern pattern{{sheet("waistband_front", 430, 430, 60), sheet("waistband_back", 400, 400, 60)},
                           {}};
  for (int k = 0; k < 7; ++k)
    pattern.panels.push_back(sheet("skirt_panel_" + std::to_string(k), 220, 120, 500));
  double gores = 0;
  for (const SeamProposal& p : seams::propose_seams(pattern, {true})) {
    const bool waist = (p.seam.a[0].panel < 2) != (p.seam.b[0].panel < 2);
    if (waist) {
      EXPECT_LT(p.confidence, 0.8) << p.seam.id;
    }
    if (!waist && p.seam.a[0].panel >= 2) gores = std::max(gores, p.confidence);
  }
  EXPECT_GT(gores, 0.8) << "of the gores themselves it is sure";
}

TEST(ProposeByKinds, CountGoresFromTheFrontsSide) {
  // Six gores, three for the front: that the first begins at a side, the front's, is what their numbers say.
  pattern::Pattern pattern{{sheet("waistband_front", 360, 360, 60), sheet("waistband_back", 360, 360, 60)},
                           {}};
  for (int k = 0; k < 6; ++k)
    pattern.panels.push_back(sheet("skirt_panel_" + std::to_string(k), 220, 120, 500));
  std::set<Index> front, back;
  for (const SeamProposal& p : seams::propose_seams(pattern, {true})) {
    for (const auto& [band, gores] : {std::pair{&p.seam.a, &p.seam.b}, std::pair{&p.seam.b, &p.seam.a}}) {
      if (band->front().panel > 1 || gores->front().panel < 2) continue;
      for (const pattern::SeamEdge& e : *gores) (band->front().panel == 0 ? front : back).insert(e.panel - 2);
    }
  }
  EXPECT_EQ(front, (std::set<Index>{0, 1, 2}));
  EXPECT_EQ(back, (std::set<Index>{3, 4, 5}));
}

TEST(ProposeByKinds, LeaveANeckOpenForTheHead) {
  // A V-neck's edges are straight, of one length, and mirror each other.
  const pattern::Panel front =
      garments::piece("left_ftorso", {{0, 0}, {282, 0}, {290, 154}, {175, 485}, {108, 511}, {0, 343}});
  const pattern::Panel back =
      garments::piece("right_btorso", {{0, 0}, {258, 0}, {265, 153}, {174, 484}, {108, 510}, {0, 443}});
  const pattern::Pattern pattern{
      {front, garments::mirrored(front, "right_ftorso"), garments::mirrored(back, "left_btorso"), back}, {}};
  bool shoulders = false;
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    const auto is_neck = [&](const pattern::SeamEdge& e) {
      const std::vector<pattern::CubicBezier>& curves = pattern.panels[e.panel].outline.edges[e.edge].curves;
      const double from = std::abs(curves.front().p0.x), to = std::abs(curves.back().p3.x);
      return std::min(from, to) < 1 && std::abs(std::max(from, to) - 108) < 1;
    };
    EXPECT_FALSE(is_neck(p.seam.a[0]) && p.confidence > 0.3) << p.seam.id << ' ' << p.confidence;
    shoulders = shoulders || p.length_a < 80;
  }
  EXPECT_TRUE(shoulders);
}

TEST(ProposeByKinds, NeverSewAHemToAHem) {
  const pattern::Pattern pattern{
      {sheet("skirt_front", 700, 500, 600), sheet("skirt_back", 700, 500, 600),
       sheet("skirt_front_lining", 700, 500, 600), sheet("skirt_back_lining", 700, 500, 600)},
      {}};
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    const bool hems = p.seam.a[0].edge == 0 && p.seam.b[0].edge == 0;
    EXPECT_FALSE(hems && p.confidence >= 0.5) << p.seam.id;
  }
}

TEST(ProposeByKinds, AreUnsureOfEveryPieceThatHasARival) {
  // Two fronts for one back: which of them is meant a person knows.
  const pattern::Pattern pattern{{garments::bodice("front", 500, 85), garments::bodice("back", 610, 70),
                                  garments::bodice("front_plain", 520, 85)},
                                 {}};
  for (const SeamProposal& p : seams::propose_seams(pattern)) EXPECT_LT(p.confidence, 0.8) << p.seam.id;
}

TEST(ProposeByKinds, LeaveAVentOpen) {
  // The centre back runs down to a vent, which stands out from it.
  const auto half = [](const std::string& id) {
    return garments::piece(id, {{0, 0}, {290, 0}, {260, 620}, {30, 610}, {30, 280}, {0, 250}});
  };
  const pattern::Pattern pattern{{half("back_r"), garments::mirrored(half("x"), "back_l"),
                                  garments::piece("front", {{0, 0}, {500, 0}, {470, 620}, {30, 620}})},
                                 {}};
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    const std::string& a = pattern.panels[p.seam.a[0].panel].outline.edges[p.seam.a[0].edge].id;
    const bool across =
        p.seam.a[0].panel != p.seam.b[0].panel && p.seam.a[0].panel < 2 && p.seam.b[0].panel < 2;
    EXPECT_FALSE(across && a == "e5" && p.confidence >= 0.8);
  }
}

TEST(ProposeByKinds, CloseABackThatIsCutInHalvesOverItsVent) {
  const std::vector<garments::Node> half{{-40, 0}, {210, 0}, {225, 400}, {190, 600},
                                         {0, 590}, {0, 250}, {-40, 250}};
  std::vector<garments::Node> other;
  for (auto p = half.rbegin(); p != half.rend(); ++p) {
    garments::Node node = *p;
    node.x = -node.x;
    other.push_back(node);
  }
  const pattern::Pattern pattern{
      {garments::piece("front", {{-215, 0}, {215, 0}, {230, 400}, {195, 600}, {-195, 600}, {-230, 400}}),
       garments::piece("back", half), garments::piece("back_mirrored", other)},
      {}};
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern, {true});
  EXPECT_GE(surest(pattern, proposals, "back", "back_mirrored"), 0.8);
  EXPECT_GE(surest(pattern, proposals, "front", "back"), 0.8);
}

TEST(ProposeByKinds, CloseABackAboveAVentThatIsNearlyAsLong) {
  // A pencil skirt drawn by halves, with names that tell no kinds.
  const auto half_back = [](const std::string& id) {
    return garments::piece(id, {{0, 0}, {290, 0}, {260, 627}, {26, 612}, {26, 278}, {0, 252}});
  };
  const auto half_front = [](const std::string& id) {
    return garments::piece(id, {{0, 0}, {248, 0}, {219, 627}, {0, 612}});
  };
  const pattern::Pattern pattern{{half_back("back"), garments::mirrored(half_back("x"), "back_mirrored"),
                                  half_front("front"), garments::mirrored(half_front("y"), "front_mirrored")},
                                 {}};
  double middle = 0, vent = 0, hem = 0;
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    const pattern::SeamEdge &a = p.seam.a[0], &b = p.seam.b[0];
    const auto length = [&](const pattern::SeamEdge& e) {
      return pattern::arc_length(pattern.panels[e.panel].outline.edges[e.edge]);
    };
    const auto is = [&](double x, double y) {
      return (std::abs(length(a) - x) < 1 && std::abs(length(b) - y) < 1) ||
             (std::abs(length(a) - y) < 1 && std::abs(length(b) - x) < 1);
    };
    if (is(334, 334)) middle = std::max(middle, p.confidence);
    if (is(252, 252)) vent = std::max(vent, p.confidence);
    if (is(252, 248)) hem = std::max(hem, p.confidence);
  }
  EXPECT_GE(middle, 0.8);
  EXPECT_LT(vent, 0.65);
  EXPECT_LT(hem, 0.65) << "an upright edge and a hem";
}

TEST(ProposeByKinds, PartASeamWhereEdgesEndOnBothSides) {
  // Darts parted both waists at the same places.
  const auto darted = [](const std::string& id, bool above, double width) {
    const double y = above ? 0 : 400, tip = above ? 120 : 280;
    std::vector<garments::Node> nodes{{0, y}, {140, y}, {140 + width / 2, tip}, {140 + width, y}, {400, y}};
    if (above)
      nodes.insert(nodes.end(), {{390, 400}, {10, 400}});
    else
      nodes = {{-80, 0}, {480, 0}, {400, y}, {140 + width, y}, {140 + width / 2, tip}, {140, y}, {0, y}};
    return garments::piece(id, nodes);
  };
  const pattern::Pattern pattern{{darted("bodice_front", true, 20), darted("bodice_back", true, 24),
                                  darted("skirt_front", false, 20), darted("skirt_back", false, 24)},
                                 {}};
  int parts = 0;
  for (const SeamProposal& p : seams::propose_seams(pattern, {true})) {
    const bool waist = (p.seam.a[0].panel < 2) != (p.seam.b[0].panel < 2);
    if (!waist) continue;
    EXPECT_EQ(p.seam.a.size(), 1u);
    EXPECT_EQ(p.seam.b.size(), 1u);
    EXPECT_NEAR(p.length_a, p.length_b, 1);
    ++parts;
  }
  EXPECT_EQ(parts, 4);
}

/// "piece.edge" of all edges of the proposal.
std::set<std::string> edges_in(const pattern::Pattern& pattern, const SeamProposal& p) {
  std::set<std::string> names;
  for (const std::vector<pattern::SeamEdge>* side : {&p.seam.a, &p.seam.b})
    for (const pattern::SeamEdge& e : *side)
      names.insert(pattern.panels[e.panel].id + "." + pattern.panels[e.panel].outline.edges[e.edge].id);
  return names;
}

TEST(ProposeByKinds, AWaistbandThatIsCutAlongItsGrainGoesAroundTheWaist) {
  pattern::Panel band = sheet("waistband", 780, 780, 35);
  band.grain = {1, 0};
  const pattern::Pattern pattern{
      {sheet("front skirt", 560, 390, 600), sheet("back skirt", 560, 390, 600), band}, {}};
  std::set<std::string> waist, ends;
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    if (p.confidence < 0.8) continue;
    const std::set<std::string> names = edges_in(pattern, p);
    if (names.contains("waistband.e1") || names.contains("waistband.e3")) ends = names;
    if (names.contains("waistband.e0") || names.contains("waistband.e2")) waist = names;
  }
  EXPECT_EQ(ends, (std::set<std::string>{"waistband.e1", "waistband.e3"}));
  EXPECT_EQ(waist.size(), 3U) << "one long edge, and both waists";
  EXPECT_TRUE(waist.contains("front skirt.e2") && waist.contains("back skirt.e2"));
}

TEST(ProposeByKinds, ATopOnStrapsKeepsItsArmholesAndItsNeckOpen) {
  const std::vector<garments::Node> sheet_of_top{{-230, 0},
                                                 {230, 0},
                                                 {240, 300, Vec2{170, 330}},
                                                 {150, 480},
                                                 {110, 480, Vec2{0, 250}},
                                                 {-110, 480},
                                                 {-150, 480, Vec2{-170, 330}},
                                                 {-240, 300}};
  const std::vector<garments::Node> strap{{0, 0}, {60, 0}, {60, 40}, {0, 40}};
  pattern::Pattern pattern{{garments::piece("front", sheet_of_top), garments::piece("back", sheet_of_top),
                            garments::piece("strap", strap)},
                           {}};
  pattern.panels.push_back(garments::mirrored(pattern.panels[2], "strap_mirrored"));
  ASSERT_TRUE(pattern::validate(pattern));
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    const std::set<std::string> names = edges_in(pattern, p);
    for (const std::string piece : {"front", "back"})
      for (const std::string edge : {".e2", ".e4", ".e6"})
        EXPECT_TRUE(p.confidence < 0.5 || !names.contains(piece + edge)) << piece << edge << " is open";
  }
}

TEST(PieceWords, TellKindsOfPieces) {
  using seams::PieceKind;
  EXPECT_EQ(seams::words_of("left_ftorso").kind, PieceKind::kTorso);
  EXPECT_EQ(seams::words_of("skirt_panel_3").kind, PieceKind::kSkirt);
  EXPECT_EQ(seams::words_of("sl_left_cuff_skirt_f").kind, PieceKind::kFrill);
  EXPECT_EQ(seams::words_of("pant_r_cuff_f").kind, PieceKind::kCuff);
  EXPECT_TRUE(seams::words_of("pant_r_cuff_f").leg);
  EXPECT_EQ(seams::words_of("Waistband").kind, PieceKind::kBand);
  EXPECT_EQ(seams::words_of("front").kind, PieceKind::kOther);
  EXPECT_EQ(seams::hangs_from(PieceKind::kSkirt, PieceKind::kTorso), 1);
  EXPECT_EQ(seams::hangs_from(PieceKind::kTorso, PieceKind::kSkirt), -1);
  EXPECT_EQ(seams::hangs_from(PieceKind::kSkirt, PieceKind::kOther), 0);
  EXPECT_FALSE(seams::ever_meet(PieceKind::kHood, PieceKind::kLegs));
}

/// Half a front with a V-neck: hem, side, armhole, shoulder, neck, middle.
pattern::Panel half_front(const std::string& id, double side, double width) {
  const std::vector<garments::Node> nodes{
      {0, 0}, {side * width, 0}, {side * width, 250}, {side * 180, 480}, {side * 110, 510}, {0, 340}};
  return garments::piece(id, nodes);
}

TEST(ProposeKinds, HalvesOfAFrontAreSewnInTheMiddleAndNotOnAlongTheNeck) {
  seams::FoundSeams found;
  found.model =
      seams::make_seam_model({{half_front("left_ftorso", 1, 280), half_front("right_ftorso", -1, 300)}, {}});
  const auto run_between = [&](Index panel, Vec2 a, Vec2 b) {
    for (Index r = 0; r < static_cast<Index>(found.model.runs.size()); ++r) {
      const seams::SeamRun& run = found.model.runs[r];
      const auto ends = [&](Vec2 p, Vec2 q) {
        return length(run.at.front() - p) < 1 && length(run.at.back() - q) < 1;
      };
      if (run.panel == panel && (ends(a, b) || ends(b, a))) return r;
    }
    ADD_FAILURE() << "no such edge";
    return kNone;
  };
  const seams::FoundSeam middle{{run_between(0, {0, 0}, {0, 340})}, {run_between(1, {0, 0}, {0, 340})}, 6};
  const seams::FoundSeam neck{
      {run_between(0, {110, 510}, {0, 340})}, {run_between(1, {-110, 510}, {0, 340})}, 6};
  found.seams = {neck};
  const double alone = seams::confidence_of(found, neck, 202, 202);
  found.seams = {middle, neck};
  EXPECT_GT(alone, 0.8);
  EXPECT_LT(seams::confidence_of(found, neck, 202, 202), 0.6) << "a head has to go through";
  EXPECT_GT(seams::confidence_of(found, middle, 340, 340), 0.8);
}

}  // namespace
}  // namespace toile
