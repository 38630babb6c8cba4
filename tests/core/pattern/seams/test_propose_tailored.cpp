// What proposals make of tailored clothes: fronts that open, side panels, sleeves of two pieces, collars.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/propose.h"
#include "core/pattern/seams/vents.h"
#include "core/pattern/validate.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using seams::SeamProposal;

/// Half a front, its middle at the left, rounded into the hem. Edges: hem, side, armhole, shoulder, gorge,
/// top of the lapel, front. `further`: mm that its side lies further out.
pattern::Panel front(double further = 0) {
  return garments::piece("front", {{200, 0},
                                   {230 + further, 0},
                                   {262 + further, 430, Vec2{222, 450}},
                                   {243, 690},
                                   {100, 726},
                                   {92, 668},
                                   {4, 670, Vec2{0, 330}, Vec2{0, 0}}});
}

/// Half a back, its fitted middle at the left. Edges: hem, side, armhole, shoulder, neck, middle.
pattern::Panel back() {
  return garments::piece("back", {{0, 0},
                                  {230, 0},
                                  {250, 438, Vec2{240, 460}},
                                  {236, 680},
                                  {93, 714, Vec2{80, 694}},
                                  {14, 694, Vec2{28, 420}, Vec2{26, 200}}});
}

/// Edges: hem, to the back, under the arm, to the front.
pattern::Panel side() {
  return garments::piece("side", {{0, 0}, {60, 0}, {58, 438, Vec2{30, 425}}, {4, 431}});
}

/// Edges: hem, elbow, cap, inner seam.
pattern::Panel top_sleeve() {
  return garments::piece("topsleeve", {{40, 0},
                                       {220, 0, Vec2{262, 220}, Vec2{258, 420}},
                                       {226, 560, Vec2{160, 760}, Vec2{60, 640}},
                                       {0, 470}});
}

/// Edges: hem, elbow, upper end, inner seam.
pattern::Panel under_sleeve() {
  return garments::piece("undersleeve", {{40, 0},
                                         {170, 0, Vec2{212, 220}, Vec2{208, 420}},
                                         {176, 560, Vec2{120, 470}, Vec2{60, 470}},
                                         {0, 470}});
}

pattern::Pattern with_mirror_images(const std::vector<pattern::Panel>& halves) {
  pattern::Pattern pattern;
  for (const pattern::Panel& half : halves) {
    pattern.panels.push_back(half);
    pattern.panels.push_back(garments::mirrored(half, half.id + "_mirrored"));
  }
  return pattern;
}

bool is_of(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& edges,
           const std::string& piece) {
  return std::any_of(edges.begin(), edges.end(), [&](const pattern::SeamEdge& e) {
    return pattern.panels[e.panel].id.starts_with(piece);
  });
}

/// Those of at least 0.8 that join something of the one piece, or its mirror image, to the other.
std::vector<SeamProposal> sure(const pattern::Pattern& pattern, const std::vector<SeamProposal>& proposals,
                               const std::string& x, const std::string& y) {
  std::vector<SeamProposal> found;
  for (const SeamProposal& p : proposals) {
    const auto joins = [&](const std::string& a, const std::string& b) {
      return is_of(pattern, p.seam.a, a) && is_of(pattern, p.seam.b, b);
    };
    if (p.confidence >= 0.8 && (joins(x, y) || joins(y, x))) found.push_back(p);
  }
  return found;
}

/// Names of the edges of the piece in the seam.
std::vector<std::string> edges_of(const pattern::Pattern& pattern, const SeamProposal& p,
                                  const std::string& piece) {
  std::vector<std::string> names;
  for (const std::vector<pattern::SeamEdge>* edges : {&p.seam.a, &p.seam.b})
    for (const pattern::SeamEdge& e : *edges)
      if (pattern.panels[e.panel].id.starts_with(piece))
        names.push_back(pattern.panels[e.panel].outline.edges[e.edge].id);
  return names;
}

class TailoredJacket : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    pattern_ = with_mirror_images({front(), back(), side(), top_sleeve(), under_sleeve()});
    proposals_ = seams::propose_seams(pattern_);
  }

  inline static pattern::Pattern pattern_;
  inline static std::vector<SeamProposal> proposals_;
};

TEST_F(TailoredJacket, IsMadeOfPiecesThatCanBeCut) { EXPECT_TRUE(pattern::validate(pattern_)); }

TEST_F(TailoredJacket, LeavesItsFrontsOpen) {
  EXPECT_EQ(sure(pattern_, proposals_, "front", "front").size(), 0u);
  for (const SeamProposal& p : proposals_)
    for (const std::string& edge : edges_of(pattern_, p, "front"))
      EXPECT_NE(edge, "e6") << "the front edge is sewn at " << p.confidence;
}

TEST_F(TailoredJacket, PutsASidePanelBetweenFrontAndBack) {
  EXPECT_EQ(sure(pattern_, proposals_, "front", "side").size(), 2u);
  EXPECT_EQ(sure(pattern_, proposals_, "side", "back").size(), 2u);
  EXPECT_EQ(sure(pattern_, proposals_, "side", "side").size(), 0u);
}

TEST_F(TailoredJacket, SewsTheTwoPiecesOfASleeveToEachOtherAndNotToTheOtherSleeve) {
  for (const char* elbow_or_inner : {"e1", "e3"}) {
    int sewn = 0;
    for (const SeamProposal& p : sure(pattern_, proposals_, "topsleeve", "undersleeve"))
      sewn += edges_of(pattern_, p, "topsleeve") == std::vector<std::string>{elbow_or_inner} &&
              edges_of(pattern_, p, "undersleeve") == std::vector<std::string>{elbow_or_inner};
    EXPECT_EQ(sewn, 2) << elbow_or_inner;
  }
  EXPECT_EQ(sure(pattern_, proposals_, "topsleeve", "topsleeve").size(), 0u);
  std::vector<std::string> mates(pattern_.panels.size());
  for (const SeamProposal& p : sure(pattern_, proposals_, "topsleeve", "undersleeve")) {
    const bool first = is_of(pattern_, p.seam.a, "topsleeve");
    const Index top = (first ? p.seam.a : p.seam.b)[0].panel, under = (first ? p.seam.b : p.seam.a)[0].panel;
    std::string& mate = mates[static_cast<std::size_t>(top)];
    if (mate.empty()) mate = pattern_.panels[under].id;
    EXPECT_EQ(mate, pattern_.panels[under].id) << "left and right mixed";
  }
}

TEST_F(TailoredJacket, EasesASleeveIntoItsArmholeAsAWhole) {
  for (const SeamProposal& p : proposals_) {
    const bool at_body = is_of(pattern_, p.seam.a, "front") || is_of(pattern_, p.seam.b, "front") ||
                         is_of(pattern_, p.seam.a, "back") || is_of(pattern_, p.seam.b, "back");
    const std::vector<std::string> top = edges_of(pattern_, p, "topsleeve");
    if (!at_body || top.empty() || p.confidence < 0.5) continue;
    EXPECT_EQ(top, std::vector<std::string>{"e2"}) << "the cap alone";
    EXPECT_LT(std::abs(p.length_a - p.length_b), 0.08 * p.length_a) << "nothing is gathered";
  }
}

/// A place on one side of a seam: the piece, and where on it, mm.
struct Place {
  std::string piece;
  Vec2 at;
};

/// Evenly along a side, from where side a begins.
std::vector<Place> places_along(const pattern::Pattern& pattern, std::vector<pattern::SeamEdge> side,
                                bool against, int count) {
  if (against) std::reverse(side.begin(), side.end());
  double all = 0;
  std::vector<double> lengths;
  for (const pattern::SeamEdge& e : side) {
    lengths.push_back((e.to - e.from) * pattern::arc_length(pattern.panels[e.panel].outline.edges[e.edge]));
    all += lengths.back();
  }
  std::vector<Place> places;
  for (int k = 0; k < count; ++k) {
    double s = all * (k + 0.5) / count;
    std::size_t i = 0;
    while (s > lengths[i]) s -= lengths[i++];
    const pattern::SeamEdge& e = side[i];
    const pattern::PanelEdge& edge = pattern.panels[e.panel].outline.edges[e.edge];
    const bool backwards = e.reversed != against;
    const double whole = pattern::arc_length(edge);
    const Vec2 at = pattern::point_at_length(edge, backwards ? e.to * whole - s : e.from * whole + s);
    places.push_back({pattern.panels[e.panel].id, at});
  }
  return places;
}

/// What meets what where a sleeve is set into an armhole: places of the bodice, and the sleeve's at each.
std::pair<std::vector<Place>, std::vector<Place>> armhole_and_sleeve(const pattern::Pattern& pattern,
                                                                     const SeamProposal& p) {
  constexpr int kPlaces = 400;
  std::vector<Place> a = places_along(pattern, p.seam.a, false, kPlaces);
  std::vector<Place> b = places_along(pattern, p.seam.b, !p.seam.same_direction, kPlaces);
  if (is_of(pattern, p.seam.a, "topsleeve")) std::swap(a, b);
  return {a, b};
}

/// The sleeves' seams into the armholes.
std::vector<SeamProposal> sleeve_heads(const pattern::Pattern& pattern,
                                       const std::vector<SeamProposal>& proposals) {
  std::vector<SeamProposal> heads;
  for (const SeamProposal& p : sure(pattern, proposals, "front", "topsleeve"))
    if (!edges_of(pattern, p, "undersleeve").empty()) heads.push_back(p);
  return heads;
}

/// Whether the seam at the elbow of each sleeve lies behind.
void expect_elbows_behind(const pattern::Pattern& pattern, const std::vector<SeamProposal>& proposals) {
  for (const SeamProposal& p : sleeve_heads(pattern, proposals)) {
    const auto [armhole, sleeve] = armhole_and_sleeve(pattern, p);
    int seams = 0;
    for (std::size_t k = 0; k < sleeve.size(); ++k) {
      const std::string &here = sleeve[k].piece, &next = sleeve[(k + 1) % sleeve.size()].piece;
      if (here.starts_with("top") == next.starts_with("top")) continue;
      ++seams;
      const Vec2 top = here.starts_with("top") ? sleeve[k].at : sleeve[(k + 1) % sleeve.size()].at;
      const bool elbow = std::abs(top.x) > 150;  // the inner seam is drawn at the piece's other end, at 0
      EXPECT_EQ(armhole[k].piece.starts_with("back"), elbow) << armhole[k].piece << " at " << top.x;
    }
    EXPECT_EQ(seams, 2);
  }
}

TEST_F(TailoredJacket, GivesEachArmTheSleeveWhoseElbowIsBehind) {
  expect_elbows_behind(pattern_, proposals_);
}

/// Whether each sleeve's highest point lies at the shoulder.
void expect_highest_at_shoulder(const pattern::Pattern& pattern, const std::vector<SeamProposal>& proposals) {
  const std::vector<SeamProposal> heads = sleeve_heads(pattern, proposals);
  ASSERT_EQ(heads.size(), 2U);
  for (const SeamProposal& p : heads) {
    const auto [armhole, sleeve] = armhole_and_sleeve(pattern, p);
    double highest = 0, at_shoulder = 0;
    for (const Place& place : sleeve)
      if (place.piece.starts_with("topsleeve")) highest = std::max(highest, place.at.y);
    for (std::size_t k = 0; k + 1 < armhole.size(); ++k) {
      const std::string &x = armhole[k].piece, &y = armhole[k + 1].piece;
      if ((x.starts_with("front") && y.starts_with("back")) ||
          (x.starts_with("back") && y.starts_with("front")))
        at_shoulder = sleeve[k].at.y;
    }
    EXPECT_NEAR(at_shoulder, highest, 2);
  }
}

TEST_F(TailoredJacket, TurnsASleeveSoThatItsHighestPointLiesAtTheShoulder) {
  expect_highest_at_shoulder(pattern_, proposals_);
}

TEST(Tailored, ASleeveWhoseHighestPointIsInItsMiddleIsTurnedToo) {
  pattern::Panel even = top_sleeve();
  even.outline.edges[2].curves.front().p1 = {210, 735};
  even.outline.edges[2].curves.front().p2 = {20, 660};
  const pattern::Pattern jacket = with_mirror_images({front(), back(), side(), even, under_sleeve()});
  expect_highest_at_shoulder(jacket, seams::propose_seams(jacket));
}

TEST(Tailored, WhereOnTheSheetTheUndersleeveIsDrawnSaysNothingOfTheHighestPoint) {
  pattern::Panel under = under_sleeve();
  for (pattern::PanelEdge& edge : under.outline.edges)
    for (auto& c : edge.curves)
      for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) p->y += 900;
  const pattern::Pattern jacket = with_mirror_images({front(), back(), side(), top_sleeve(), under});
  expect_highest_at_shoulder(jacket, seams::propose_seams(jacket));
}

/// The jacket's body without its side panels, its back of one piece.
pattern::Pattern with_whole_back() {
  pattern::Pattern pattern = with_mirror_images({front(30), top_sleeve(), under_sleeve()});
  pattern.panels.push_back(garments::piece("back", {{-262, 0},
                                                    {262, 0},
                                                    {290, 430, Vec2{240, 460}},
                                                    {236, 680},
                                                    {93, 714, Vec2{30, 694}, Vec2{-30, 694}},
                                                    {-93, 714},
                                                    {-236, 680, Vec2{-240, 460}},
                                                    {-290, 430}}));
  return pattern;
}

TEST(Tailored, SleevesAreSetIntoABackOfOnePieceAsIntoTwo) {
  const pattern::Pattern jacket = with_whole_back();
  const std::vector<SeamProposal> proposals = seams::propose_seams(jacket);
  expect_highest_at_shoulder(jacket, proposals);
  expect_elbows_behind(jacket, proposals);
}

TEST_F(TailoredJacket, SetsASleeveByTheNotchNearItsHighestPoint) {
  pattern::Pattern notched = pattern_;
  constexpr double kAside = 12;  // mm along the cap
  for (pattern::Panel& panel : notched.panels) {
    if (!panel.id.starts_with("topsleeve")) continue;
    const auto cap = std::find_if(panel.outline.edges.begin(), panel.outline.edges.end(),
                                  [](const pattern::PanelEdge& e) { return e.id == "e2"; });
    const double whole = pattern::arc_length(*cap);
    double crown = 0;
    for (double s = 0; s < whole; s += 0.5)
      if (pattern::point_at_length(*cap, s).y > pattern::point_at_length(*cap, crown).y) crown = s;
    // On the front part of the cap, of both sleeves.
    const bool front_last = std::abs(cap->curves.back().p3.x) < 150;
    panel.notches.push_back({pattern::point_at_length(*cap, crown + (front_last ? kAside : -kAside)), 0, {}});
  }
  const std::vector<SeamProposal> heads = sleeve_heads(notched, seams::propose_seams(notched));
  ASSERT_EQ(heads.size(), 2U);
  for (const SeamProposal& p : heads) {
    const auto [armhole, sleeve] = armhole_and_sleeve(notched, p);
    for (std::size_t k = 0; k + 1 < armhole.size(); ++k) {
      if (armhole[k].piece.substr(0, 4) == armhole[k + 1].piece.substr(0, 4)) continue;
      if (armhole[k].piece.starts_with("side") || armhole[k + 1].piece.starts_with("side")) continue;
      const auto top = std::find_if(notched.panels.begin(), notched.panels.end(),
                                    [&](const pattern::Panel& panel) { return panel.id == sleeve[k].piece; });
      ASSERT_TRUE(sleeve[k].piece.starts_with("topsleeve"));
      EXPECT_LT(length(top->notches[0].at - sleeve[k].at), 4);
    }
  }
}

TEST(Tailored, ACollarGoesToANeckAndToNoShoulderOrArmhole) {
  pattern::Pattern pattern = with_mirror_images({front(), back()});
  const double neck = 2 * (garments::length_of(back(), 4) + garments::length_of(front(), 4));
  pattern.panels.push_back(garments::piece(
      "collar", {{0, 0, Vec2{neck / 2, 12}}, {neck, 0}, {neck + 8, 70, Vec2{neck / 2, 84}}, {-8, 70}}));
  for (const SeamProposal& p : seams::propose_seams(pattern)) {
    if (edges_of(pattern, p, "collar").empty() || p.confidence < 0.5) continue;
    for (const std::string& edge : edges_of(pattern, p, "front"))
      EXPECT_TRUE(edge == "e4" || edge == "e5") << edge;
    for (const std::string& edge : edges_of(pattern, p, "back")) EXPECT_EQ(edge, "e4");
    EXPECT_LT(edges_of(pattern, p, "collar").size(), 2u) << "above fronts that open it is no ring";
  }
}

TEST(Tailored, AStandGoesAllAroundTheNeckAndTheCollarOnIt) {
  pattern::Pattern pattern = with_mirror_images({front(), back(), side(), top_sleeve(), under_sleeve()});
  const double neck = 2 * (garments::length_of(back(), 4) + garments::length_of(front(), 4)), fold = neck + 4;
  pattern.panels.push_back(garments::piece("collarStand", {{0, 0}, {neck, 0}, {neck + 2, 28}, {-2, 28}}));
  // Its outer edge is about as long as the neck, too.
  pattern.panels.push_back(
      garments::piece("collar", {{0, 0}, {fold, 0}, {fold + 10, 50}, {neck - 2, 72}, {6, 72}, {-6, 50}}));
  ASSERT_TRUE(pattern::validate(pattern));
  const std::vector<SeamProposal> proposals = seams::propose_seams(pattern);
  const std::vector<SeamProposal> neck_seams = sure(pattern, proposals, "collarStand", "back");
  ASSERT_EQ(neck_seams.size(), 1U);
  EXPECT_EQ(edges_of(pattern, neck_seams[0], "collarStand"), std::vector<std::string>{"e0"});
  EXPECT_EQ(edges_of(pattern, neck_seams[0], "back"), (std::vector<std::string>{"e4", "e4"}));
  EXPECT_EQ(edges_of(pattern, neck_seams[0], "front"), (std::vector<std::string>{"e4", "e4"}));
  std::vector<std::string> upon;
  for (const SeamProposal& p : sure(pattern, proposals, "collarStand", "collar"))
    for (const std::string& edge : edges_of(pattern, p, "collar")) upon.push_back(edge);
  EXPECT_EQ(std::count(upon.begin(), upon.end(), "e2"), 1) << "the stand's upper edge";
  EXPECT_EQ(std::count(upon.begin(), upon.end(), "e3"), 0) << "the collar's outer edge stays free";
}

TEST(Tailored, TheCapOfAnUndersleeveIsItsHollowUpperEnd) {
  const seams::SeamModel model = seams::make_seam_model({{top_sleeve(), under_sleeve()}, {}});
  EXPECT_TRUE(model.tailored);
  for (const seams::SeamRun& run : model.runs)
    EXPECT_EQ(run.cap, run.edge == 2) << run.panel << ' ' << run.edge;
  const seams::SeamModel one = seams::make_seam_model({{top_sleeve()}, {}});
  EXPECT_FALSE(one.tailored) << "the cap of a sleeve in one piece may be gathered";
}

TEST(Tailored, AnUndersleeveIsNeverClosedByItselfWhereTheOtherPartIsThere) {
  const auto closes = [](std::vector<pattern::Panel> panels) {
    const seams::SeamModel m = seams::make_seam_model({std::move(panels), {}});
    return !seams::never_sewn(m, 1, 3);  // its elbow and its inner seam
  };
  EXPECT_FALSE(closes({under_sleeve(), top_sleeve()}));
  EXPECT_TRUE(closes({under_sleeve()}));
  for (const char* name : {"MGA SUP", "TOP SLV", "Dessus manche"})
    EXPECT_EQ(seams::words_of(name).sleeve_part, 1) << name;
  for (const char* name : {"Manga inferior", "UND SLV", "Unterärmel"})
    EXPECT_EQ(seams::words_of(name).sleeve_part, -1) << name;
}

TEST(Tailored, ARaglanCutInFrontAndBackEndsAtTheNeck) {
  const auto half = [](const std::string& name) {  // hem, underarm, slope, neck, along the arm
    return garments::piece(name, {{0, 0}, {150, 0}, {220, 460}, {60, 780}, {20, 790}});
  };
  const seams::SeamModel m =
      seams::make_seam_model({{front(), back(), half("sleeve front"), half("sleeve back")}, {}});
  EXPECT_TRUE(m.raglan);
  for (const seams::SeamRun& run : m.runs)
    EXPECT_EQ(run.raglan_top, run.panel >= 2 && run.edge == 3) << run.panel << " e" << run.edge;
  const seams::SeamModel one = seams::make_seam_model({{front(), back(), half("sleeve front")}, {}});
  EXPECT_FALSE(one.raglan);
}

TEST(Tailored, NoSleeveGoesToTheNeck) {
  const pattern::Pattern pattern = with_mirror_images({back(), top_sleeve(), under_sleeve()});
  const seams::SeamModel model = seams::make_seam_model(pattern);
  const seams::SeamRun &neck = model.runs[4], &cap = model.runs[6 * 2 + 4 * 2 + 2];
  ASSERT_TRUE(neck.panel == 0 && neck.edge == 4 && cap.cap);
  EXPECT_TRUE(seams::never_sewn(model, 4, 6 * 2 + 4 * 2 + 2)) << "however like their lengths are";
}

TEST(Tailored, AVentOfASkirtStaysOpenWhereverTheSeamAboveHasANotch) {
  // Edges: hem, vent, step, middle, waist, side.
  const pattern::Panel back = garments::piece(
      "skirt back", {{0, 0}, {280, 0}, {280, 200}, {232, 215}, {230, 585}, {25, 600, Vec2{-10, 400}}});
  const pattern::Panel mirror = garments::mirrored(back, "skirt back_mirrored");
  seams::SeamModel m = seams::make_seam_model({{back, mirror}, {}});
  const double uncut = seams::twin_merit(m, m.runs[1], 1);
  m = seams::with_cuts({{back, mirror}, {}}, std::move(m), 3, {190});
  EXPECT_TRUE(seams::stands_out(m, m.runs[1])) << "though the part above it is shorter";
  EXPECT_DOUBLE_EQ(seams::twin_merit(m, m.runs[1], 1), uncut);
  EXPECT_LT(uncut, -5);
  EXPECT_GT(seams::twin_merit(m, m.runs[3], 1), 0);
}

TEST(Tailored, ASeamEndsWhereAVentGoesOutFromIt) {
  // The vent of a sleeve: up its edge, in by a step, on along the elbow.
  const pattern::Panel sleeve = garments::piece(
      "sleeve",
      {{0, 0}, {200, 0}, {202, 90}, {160, 110, Vec2{190, 300}}, {180, 480, Vec2{100, 700}}, {0, 420}});
  const seams::SeamModel model =
      seams::make_seam_model({{sleeve, garments::mirrored(sleeve, "sleeve_mirrored")}, {}});
  EXPECT_TRUE(seams::stands_out(model, model.runs[1]));
  EXPECT_FALSE(seams::stands_out(model, model.runs[3]));
  EXPECT_FALSE(seams::turns_in(model, model.runs[3])) << "the corner is the vent's";
  // The same with its hem turned up, where the edge bends.
  const pattern::Panel turned = garments::piece("sleeve", {{5, -30},
                                                           {195, -30},
                                                           {200, 0},
                                                           {202, 90},
                                                           {160, 110, Vec2{190, 300}},
                                                           {180, 480, Vec2{100, 700}},
                                                           {0, 420}});
  const seams::SeamModel hem =
      seams::make_seam_model({{turned, garments::mirrored(turned, "sleeve_mirrored")}, {}});
  for (const seams::SeamRun& run : hem.runs)
    EXPECT_EQ(seams::stands_out(hem, run),
              run.panel == 0 ? run.edge == 1 || run.edge == 2
                             : run.length < 95 && run.length > 29 && std::abs(run.at[0].x - run.at[8].x) < 6)
        << run.panel << ' ' << run.edge;
  const pattern::Panel square =
      garments::piece("front_l", {{0, 0}, {250, 0}, {250, 400}, {120, 560}, {90, 560}, {88, 300}, {0, 300}});
  const seams::SeamModel neck = seams::make_seam_model({{square}, {}});
  EXPECT_TRUE(seams::turns_in(neck, neck.runs[5])) << "the corner of a square neck";
}

}  // namespace
}  // namespace toile
