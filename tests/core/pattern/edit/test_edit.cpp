#include "core/pattern/edit/edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/pattern/curve.h"
#include "core/pattern/validate.h"
#include "tests/core/pattern/edit/edit_pattern.h"

namespace toile {
namespace {

using test::two_sheets;

pattern::Pattern edited(const pattern::Pattern& pattern, const edit::PatternEdit& edit) {
  const Result<edit::EditedPattern> out = edit::apply_edit(pattern, edit);
  EXPECT_TRUE(out) << to_string(out.error());
  return out ? out->pattern : pattern;
}

Error refused(const pattern::Pattern& pattern, const edit::PatternEdit& edit) {
  const Result<edit::EditedPattern> out = edit::apply_edit(pattern, edit);
  EXPECT_FALSE(out) << "the edit was carried out";
  return out ? Error{} : out.error();
}

const pattern::PanelEdge& edge(const pattern::Pattern& pattern, std::size_t panel, const std::string& id) {
  for (const pattern::PanelEdge* found : pattern::edges_of(pattern.panels[panel]))
    if (found->id == id) return *found;
  ADD_FAILURE() << "there is no edge " << id;
  return pattern.panels[panel].outline.edges[0];
}

/// The points along a seam's side at equal steps of its length, in its direction.
std::vector<Vec2> along(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& series,
                        int steps = 16) {
  std::vector<Vec2> points;
  double whole = 0;
  std::vector<double> lengths;
  for (const pattern::SeamEdge& item : series) {
    const pattern::PanelEdge& one =
        *pattern::edges_of(pattern.panels[std::size_t(item.panel)])[std::size_t(item.edge)];
    lengths.push_back(pattern::arc_length(one) * (item.to - item.from));
    whole += lengths.back();
  }
  for (int k = 0; k <= steps; ++k) {
    double s = whole * k / steps;
    std::size_t i = 0;
    while (i + 1 < series.size() && s > lengths[i]) s -= lengths[i++];
    const pattern::PanelEdge& one =
        *pattern::edges_of(pattern.panels[std::size_t(series[i].panel)])[std::size_t(series[i].edge)];
    const double l = pattern::arc_length(one);
    points.push_back(
        pattern::point_at_length(one, series[i].reversed ? series[i].to * l - s : series[i].from * l + s));
  }
  return points;
}

void expect_same_path(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(length(a[i] - b[i]), 1e-6) << i;
}

TEST(PatternEdit, MovesACornerOfBothItsEdgesAndKeepsThemStraight) {
  const pattern::Pattern now = edited(two_sheets(), edit::MovePoint{"back", "right", 1, {410, 210}});
  EXPECT_EQ(edge(now, 1, "right").curves[0].p3, (Vec2{410, 210}));
  EXPECT_EQ(edge(now, 1, "top").curves[0].p0, (Vec2{410, 210}));
  EXPECT_TRUE(pattern::is_straight(edge(now, 1, "right").curves[0]));
  EXPECT_TRUE(pattern::is_straight(edge(now, 1, "top").curves[0]));
}

TEST(PatternEdit, MovesTheHandlesBesideAPointOfACurveAlong) {
  const pattern::Pattern bent =
      edited(two_sheets(), edit::BendEdge{"back", "right", 0, {420, 60}, {420, 140}});
  const pattern::Pattern now = edited(bent, edit::MovePoint{"back", "right", 1, {410, 205}});
  EXPECT_EQ(edge(now, 1, "right").curves[0].p1, (Vec2{420, 60}));
  EXPECT_EQ(edge(now, 1, "right").curves[0].p2, (Vec2{430, 145}));
}

TEST(PatternEdit, TakesTheNotchAtAPointAlong) {
  const pattern::Pattern now = edited(two_sheets(), edit::MovePoint{"front", "right", 1, {120, 90}});
  EXPECT_EQ(now.panels[0].notches[0].at, (Vec2{120, 90}));
}

TEST(PatternEdit, TakesANotchOnAScaledEdgeToTheSamePartOfIt) {
  pattern::Pattern pattern = two_sheets();
  pattern.panels[0].notches = {{{100, 50}, 5, {-1, 0}}};
  const pattern::Pattern now = edited(pattern, edit::SetEdgeLength{"front", "right", 240, "start"});
  EXPECT_NEAR(now.panels[0].notches[0].at.y, 60, 1e-3);
}

TEST(PatternEdit, MovesAHandle) {
  const pattern::Pattern now = edited(two_sheets(), edit::MoveHandle{"back", "right", 0, 2, {430, 150}});
  EXPECT_EQ(edge(now, 1, "right").curves[0].p2, (Vec2{430, 150}));
  EXPECT_EQ(edge(now, 1, "right").curves[0].p1, edge(two_sheets(), 1, "right").curves[0].p1);
}

TEST(PatternEdit, InsertsAPointThatChangesNoShapeAndDeletesItAgain) {
  const pattern::Pattern bent =
      edited(two_sheets(), edit::BendEdge{"back", "right", 0, {430, 60}, {420, 140}});
  const pattern::Pattern two = edited(bent, edit::InsertPoint{"back", "right", 0.3});
  ASSERT_EQ(edge(two, 1, "right").curves.size(), 2u);
  EXPECT_NEAR(pattern::arc_length(edge(two, 1, "right").curves[0]),
              0.3 * pattern::arc_length(edge(bent, 1, "right")), 1e-6);
  EXPECT_NEAR(pattern::signed_area(two.panels[1].outline), pattern::signed_area(bent.panels[1].outline),
              1e-6);
  const pattern::Pattern one = edited(two, edit::DeletePoint{"back", "right", 1});
  ASSERT_EQ(edge(one, 1, "right").curves.size(), 1u);
  EXPECT_LT(length(edge(one, 1, "right").curves[0].p1 - Vec2{430, 60}), 1e-6);
  EXPECT_LT(length(edge(one, 1, "right").curves[0].p2 - Vec2{420, 140}), 1e-6);
}

TEST(PatternEdit, ASplitEdgeKeepsItsSeamOnBothHalves) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::SplitEdge{"front", "right", 0.25, "above"});
  ASSERT_EQ(now.seams[0].a.size(), 2u);
  EXPECT_EQ(now.seams[0].a[0].edge, 1);
  EXPECT_EQ(now.seams[0].a[1].edge, 2);
  EXPECT_EQ(now.seams[1].a[0].edge, 3) << "the edges behind it have moved up";
  for (std::size_t s = 0; s < 2; ++s) {
    expect_same_path(along(was, was.seams[s].a), along(now, now.seams[s].a));
    expect_same_path(along(was, was.seams[s].b), along(now, now.seams[s].b));
  }
}

TEST(PatternEdit, ASplitWithinASewnPartOfAReversedEdgeKeepsItsPath) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::SplitEdge{"back", "top", 0.4, ""});
  ASSERT_EQ(now.seams[1].b.size(), 2u);
  EXPECT_EQ(edge(now, 1, "top_2").curves.size(), 1u);
  expect_same_path(along(was, was.seams[1].b), along(now, now.seams[1].b));
}

TEST(PatternEdit, SplitsAtTheJointThatIsThere) {
  const pattern::Pattern now = edited(two_sheets(), edit::SplitEdge{"front", "right", 0.5, "above"});
  EXPECT_EQ(edge(now, 0, "right").curves.size(), 1u);
  EXPECT_EQ(edge(now, 0, "above").curves.size(), 1u);
  EXPECT_EQ(edge(now, 0, "above").curves[0].p0, (Vec2{100, 100}));
}

TEST(PatternEdit, JoiningTheHalvesAgainGivesTheSeamBack) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(edited(was, edit::SplitEdge{"front", "right", 0.25, "above"}),
                                      edit::JoinEdges{"front", "right", "above"});
  ASSERT_EQ(now.seams[0].a.size(), 1u);
  EXPECT_EQ(now.seams[0].a[0].from, 0);
  EXPECT_EQ(now.seams[0].a[0].to, 1);
  EXPECT_EQ(now.seams[1].a[0].edge, 2);
}

TEST(PatternEdit, JoinedEdgesOfTwoSeamsKeepTheirPartsOfTheLine) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::JoinEdges{"front", "right", "top"});
  for (std::size_t s = 0; s < 2; ++s)
    expect_same_path(along(was, was.seams[s].a), along(now, now.seams[s].a));
}

TEST(PatternEdit, JoinsTheLastEdgeOfALoopWithItsFirst) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::JoinEdges{"back", "left", "bottom"});
  ASSERT_EQ(now.panels[1].outline.edges.size(), 3u);
  EXPECT_EQ(now.panels[1].outline.edges[2].id, "left");
  expect_same_path(along(was, was.seams[0].b), along(now, now.seams[0].b));
  expect_same_path(along(was, was.seams[1].b), along(now, now.seams[1].b));
}

TEST(PatternEdit, RefusesToJoinEdgesThatDoNotMeet) {
  EXPECT_EQ(refused(two_sheets(), edit::JoinEdges{"front", "right", "left"}).code, "edit.not_neighbours");
  EXPECT_EQ(refused(two_sheets(), edit::JoinEdges{"front", "right", "right"}).code, "edit.not_neighbours");
  EXPECT_EQ(refused(two_sheets(), edit::JoinEdges{"front", "top", "right"}).code, "edit.not_neighbours");
}

TEST(PatternEdit, StraightensAndBends) {
  const pattern::Pattern bent =
      edited(two_sheets(), edit::BendEdge{"back", "right", 0, {430, 60}, {420, 140}});
  EXPECT_FALSE(pattern::is_straight(edge(bent, 1, "right").curves[0]));
  const pattern::Pattern now = edited(bent, edit::StraightenEdge{"back", "right", 0});
  EXPECT_NEAR(pattern::arc_length(edge(now, 1, "right")), 200, 1e-9);
  const pattern::Pattern whole = edited(two_sheets(), edit::StraightenEdge{"front", "right"});
  EXPECT_EQ(edge(whole, 0, "right").curves.size(), 1u);
}

TEST(PatternEdit, GivesAnEdgeTheLengthThatIsAskedFor) {
  const pattern::Pattern bent =
      edited(two_sheets(), edit::BendEdge{"back", "right", 0, {430, 60}, {420, 140}});
  for (const char* keep : {"start", "end", "middle"}) {
    const pattern::Pattern now = edited(bent, edit::SetEdgeLength{"back", "right", 180, keep});
    EXPECT_NEAR(pattern::arc_length(edge(now, 1, "right")), 180, 1e-6) << keep;
    EXPECT_TRUE(pattern::is_straight(edge(now, 1, "top").curves[0])) << keep;
  }
  const pattern::Pattern start = edited(bent, edit::SetEdgeLength{"back", "right", 180, "start"});
  EXPECT_EQ(edge(start, 1, "right").curves[0].p0, (Vec2{400, 0}));
  const pattern::Pattern end = edited(bent, edit::SetEdgeLength{"back", "right", 180, "end"});
  EXPECT_EQ(edge(end, 1, "right").curves[0].p3, (Vec2{400, 200}));
}

TEST(PatternEdit, TurnsAPieceOverWithoutMovingItsSeams) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::MirrorPiece{"back"});
  EXPECT_EQ(edge(now, 1, "right").curves[0].p0, (Vec2{300, 200}))
      << "right lies on the left, run the other way";
  EXPECT_EQ(edge(now, 1, "right").curves[0].p3, (Vec2{300, 0}));
  std::vector<Vec2> mirrored = along(was, was.seams[1].b);
  for (Vec2& p : mirrored) p.x = 700 - p.x;
  expect_same_path(mirrored, along(now, now.seams[1].b));
  const pattern::Pattern back = edited(now, edit::MirrorPiece{"back"});
  expect_same_path(along(was, was.seams[1].b), along(back, back.seams[1].b));
  EXPECT_EQ(back.panels[1].outline.edges[1].id, "right");
}

TEST(PatternEdit, TurnsTheGrain) {
  const pattern::Pattern now = edited(two_sheets(), edit::RotateGrain{"back", 90});
  EXPECT_NEAR(now.panels[1].grain.x, -1, 1e-12);
  EXPECT_NEAR(now.panels[1].grain.y, 0, 1e-12);
}

TEST(PatternEdit, AddsAndRemovesALine) {
  const pattern::Pattern now =
      edited(two_sheets(), edit::AddLine{"back", {"crease", {{310, 50}, {390, 50}}}});
  ASSERT_EQ(now.panels[1].lines.size(), 1u);
  EXPECT_TRUE(edited(now, edit::RemoveLine{"back", "crease"}).panels[1].lines.empty());
  EXPECT_EQ(refused(now, edit::RemoveLine{"back", "fold"}).code, "edit.unknown_line");
  EXPECT_EQ(refused(now, edit::AddLine{"back", {"out", {{310, 50}, {500, 50}}}}).code, "pattern.bad_line");
}

TEST(PatternEdit, ANotchIsAPointOfItsEdgeThatPointsIntoTheCloth) {
  pattern::Pattern was = two_sheets();
  was = edited(was, edit::BendEdge{"back", "right", 0, {430, 60}, {430, 140}});
  const pattern::PanelEdge bare = edge(was, 1, "right");
  const pattern::Pattern now = edited(was, edit::AddNotch{"back", "right", 0.5, 6});
  ASSERT_EQ(now.panels[1].notches.size(), 1u);
  const pattern::Notch& notch = now.panels[1].notches[0];
  EXPECT_NEAR(notch.at.y, 100, 1e-6);
  EXPECT_NEAR(notch.inwards.x, -1, 1e-6);
  EXPECT_EQ(notch.depth, 6);
  ASSERT_EQ(edge(now, 1, "right").curves.size(), 2u);
  EXPECT_EQ(edge(now, 1, "right").curves[1].p0, notch.at);
  const pattern::Pattern back = edited(now, edit::RemoveNotch{"back", 0});
  EXPECT_TRUE(back.panels[1].notches.empty());
  ASSERT_EQ(edge(back, 1, "right").curves.size(), 1u) << "nobody needs the point any more";
  EXPECT_LT(length(edge(back, 1, "right").curves[0].p1 - bare.curves[0].p1), 1e-6);
}

TEST(PatternEdit, ANotchMovesAlongItsPieceAndLeavesNoPointBehind) {
  const pattern::Pattern was = two_sheets();  // front has one in the middle of its right side
  const pattern::Pattern now = edited(was, edit::MoveNotch{"front", 0, "top", 0.25, {}});
  ASSERT_EQ(now.panels[0].notches.size(), 1u);
  EXPECT_LT(length(now.panels[0].notches[0].at - Vec2{75, 200}), 1e-9);
  EXPECT_EQ(now.panels[0].notches[0].depth, 5);
  EXPECT_LT(length(now.panels[0].notches[0].inwards - Vec2{0, -1}), 1e-9);
  EXPECT_EQ(edge(now, 0, "right").curves.size(), 1u);
  const pattern::Pattern corner = edited(now, edit::MoveNotch{"front", 0, "top", 0, 8});
  EXPECT_EQ(corner.panels[0].notches[0].at, (Vec2{100, 200}));
  EXPECT_EQ(corner.panels[0].notches[0].depth, 8);
  EXPECT_EQ(edge(corner, 0, "top").curves.size(), 1u);
  const pattern::Pattern beside = edited(was, edit::MoveNotch{"front", 0, "right", 0.502, {}});
  EXPECT_EQ(beside.panels[0].notches[0].at, (Vec2{100, 100})) << "a point near by is meant";
  EXPECT_EQ(edge(beside, 0, "right").curves.size(), 2u);
  pattern::Pattern bent = edited(was, edit::MovePoint{"front", "right", 1, {110, 100}});
  bent = edited(bent, edit::RemoveNotch{"front", 0});
  EXPECT_EQ(edge(bent, 0, "right").curves.size(), 2u) << "a point that shapes the edge stays";
}

TEST(PatternEdit, RefusesNotchesWhereThereAreNone) {
  const pattern::Pattern was = two_sheets();
  EXPECT_EQ(refused(was, edit::RemoveNotch{"front", 1}).code, "edit.unknown_notch");
  EXPECT_EQ(refused(was, edit::RemoveNotch{"back", 0}).code, "edit.unknown_notch");
  EXPECT_EQ(refused(was, edit::MoveNotch{"front", -1, "top", 0.5, {}}).code, "edit.unknown_notch");
  EXPECT_EQ(refused(was, edit::MoveNotch{"front", 0, "hem", 0.5, {}}).code, "edit.unknown_edge");
  EXPECT_EQ(refused(was, edit::AddNotch{"front", "right", 0.5, 5}).code, "edit.out_of_range")
      << "there is one";
  EXPECT_EQ(refused(was, edit::AddNotch{"front", "top", 1.5, 5}).code, "edit.out_of_range");
  EXPECT_EQ(refused(was, edit::AddNotch{"front", "top", NAN, 5}).code, "edit.out_of_range");
  EXPECT_EQ(refused(was, edit::AddNotch{"front", "top", 0.5, NAN}).code, "edit.out_of_range");
}

TEST(PatternEdit, CutsADartThatKeepsTheSeamOnBothSidesOfIt) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::AddDart{"back", "left", 0.5, 20, 50, "dart"});
  ASSERT_EQ(now.panels[1].outline.edges.size(), 7u);
  EXPECT_NEAR(pattern::signed_area(now.panels[1].outline), 200 * 100 - 0.5 * 20 * 50, 1e-6);
  ASSERT_EQ(now.seams.size(), 3u);
  EXPECT_EQ(now.seams[2].id, "dart");
  ASSERT_EQ(now.seams[0].b.size(), 2u);
  EXPECT_NEAR(pattern::arc_length(edge(now, 1, "left")) + pattern::arc_length(edge(now, 1, "left_2")), 180,
              1e-6);
  EXPECT_EQ(edge(now, 1, "dart_a").curves[0].p3, edge(now, 1, "dart_b").curves[0].p0);
}

TEST(PatternEdit, TakesADartAwayAgain) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now =
      edited(edited(was, edit::AddDart{"back", "left", 0.5, 20, 50, "dart"}), edit::RemoveDart{"dart"});
  EXPECT_EQ(now.seams.size(), 2u);
  EXPECT_NEAR(pattern::signed_area(now.panels[1].outline), 200 * 100, 1e-6);
  EXPECT_EQ(now.panels[1].outline.edges.size(), 5u);
  expect_same_path(along(was, was.seams[1].b), along(now, now.seams[1].b));
  EXPECT_EQ(refused(was, edit::RemoveDart{"side"}).code, "edit.no_dart");
}

TEST(PatternEdit, CutsAFishEyeDartWithinTheClothAndTakesItAway) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now =
      edited(was, edit::AddInnerDart{"back", {350, 40}, {350, 160}, 16, 0.25, "waist"});
  ASSERT_EQ(now.panels[1].holes.size(), 1u);
  EXPECT_NEAR(pattern::signed_area(now.panels[1].holes[0]), -0.5 * 16 * 120, 1e-6) << "clockwise";
  ASSERT_EQ(now.seams.size(), 3u);
  const pattern::PanelEdge &a = edge(now, 1, "waist_a"), &b = edge(now, 1, "waist_b");
  EXPECT_NEAR(pattern::arc_length(a), pattern::arc_length(b), 1e-9);
  EXPECT_NEAR(pattern::arc_length(a.curves[0]), std::hypot(30, 8), 1e-9) << "widest a quarter of the way up";
  EXPECT_EQ(a.curves.front().p0, b.curves.back().p3);
  EXPECT_FALSE(now.seams[2].same_direction) << "tips stay where they are";
  const pattern::Pattern back = edited(now, edit::RemoveDart{"waist"});
  EXPECT_TRUE(back.panels[1].holes.empty());
  EXPECT_EQ(back.seams.size(), 2u);
  expect_same_path(along(was, was.seams[0].b), along(back, back.seams[0].b));
  EXPECT_EQ(refused(was, edit::AddInnerDart{"back", {350, 40}, {350, 300}, 16, 0.5, "d"}).code,
            "pattern.self_crossing");
  EXPECT_EQ(refused(was, edit::AddInnerDart{"back", {350, 40}, {350, 40}, 16, 0.5, "d"}).code,
            "edit.out_of_range");
  EXPECT_EQ(refused(now, edit::AddInnerDart{"back", {310, 40}, {310, 60}, 4, 0.5, "waist"}).code,
            "pattern.duplicate_id");
}

TEST(PatternEdit, RenamesAnEdgeThatStaysSewn) {
  const pattern::Pattern was = two_sheets();
  const pattern::Pattern now = edited(was, edit::RenameEdge{"back", "left", "side"});
  EXPECT_NEAR(pattern::arc_length(edge(now, 1, "side")), pattern::arc_length(edge(was, 1, "left")), 1e-12);
  expect_same_path(along(was, was.seams[0].b), along(now, now.seams[0].b));
  EXPECT_EQ(refused(was, edit::RenameEdge{"back", "none", "side"}).code, "edit.unknown_edge");
  EXPECT_EQ(refused(was, edit::RenameEdge{"back", "left", "top"}).code, "pattern.duplicate_id");
}

TEST(PatternEdit, RefusesADartThatDoesNotFit) {
  EXPECT_EQ(refused(two_sheets(), edit::AddDart{"back", "left", 0.01, 20, 50, "dart"}).code,
            "edit.out_of_range");
  EXPECT_EQ(refused(two_sheets(), edit::AddDart{"back", "left", 0.5, 20, 150, "dart"}).code,
            "pattern.self_crossing");
  EXPECT_EQ(refused(two_sheets(), edit::AddDart{"back", "left", 0.5, 20, 50, "side"}).code,
            "pattern.duplicate_id");
  pattern::Pattern tacked = two_sheets();
  tacked.seams = {{"tack", {{0, 1, false, 0.49, 0.51}}, {{1, 3, false, 0.49, 0.51}}, false}};
  EXPECT_EQ(refused(tacked, edit::AddDart{"back", "left", 0.5, 20, 50, "dart"}).code, "edit.sewn");
}

TEST(PatternEdit, CutsAHoleAndFillsItWithItsSeams) {
  const std::vector<edit::DrawnEdge> slot{{"s0", {{340, 90}, {360, 90}}, {}},
                                          {"s1", {}, {{{{360, 90}, {365, 95}, {365, 105}, {360, 110}}}}},
                                          {"s2", {{360, 110}, {340, 110}}, {}},
                                          {"s3", {{340, 110}, {340, 90}}, {}}};
  pattern::Pattern now = edited(two_sheets(), edit::AddHole{"back", slot});
  ASSERT_EQ(now.panels[1].holes.size(), 1u);
  EXPECT_LT(pattern::signed_area(now.panels[1].holes[0]), 0);
  EXPECT_EQ(refused(two_sheets(), edit::AddHole{"back", {slot[0], slot[2]}}).where,
            "piece back, hole, edge s2");
  now = edited(now, edit::AddSeam{"shut", {{"back", "s0"}}, {{"back", "s2"}}, false});
  now = edited(now, edit::RemoveHole{"back", "s1"});
  EXPECT_TRUE(now.panels[1].holes.empty());
  EXPECT_EQ(now.seams.size(), 2u);
  EXPECT_EQ(refused(now, edit::RemoveHole{"back", "left"}).code, "edit.unknown_edge");
}

TEST(PatternEdit, MovesRenamesDuplicatesAndDeletesPieces) {
  const pattern::Pattern was = two_sheets();
  EXPECT_EQ(edge(edited(was, edit::MovePiece{"front", {5, -5}}), 0, "bottom").curves[0].p0, (Vec2{5, -5}));
  EXPECT_EQ(edited(was, edit::RenamePiece{"front", "fore"}).panels[0].id, "fore");
  EXPECT_EQ(refused(was, edit::RenamePiece{"front", "back"}).code, "pattern.duplicate_id");

  const pattern::Pattern three = edited(was, edit::DuplicatePiece{"front", "lining", {0, 500}, true});
  ASSERT_EQ(three.panels.size(), 3u);
  EXPECT_EQ(three.panels[2].id, "lining");
  EXPECT_EQ(three.panels[2].notches[0].at, (Vec2{0, 600}));
  EXPECT_TRUE(pattern::validate(three));

  const pattern::Pattern two = edited(three, edit::DeletePiece{"front"});
  ASSERT_EQ(two.panels.size(), 2u);
  EXPECT_TRUE(two.seams.empty()) << "front was one side of both";
  const pattern::Pattern sewn =
      edited(three, edit::AddSeam{"hem", {{"back", "bottom"}}, {{"lining", "bottom"}}, false});
  const pattern::Pattern later = edited(sewn, edit::DeletePiece{"front"});
  ASSERT_EQ(later.seams.size(), 1u);
  EXPECT_EQ(later.seams[0].a[0].panel, 0);
  EXPECT_EQ(later.seams[0].b[0].panel, 1);
  EXPECT_EQ(refused(edited(was, edit::DeletePiece{"front"}), edit::DeletePiece{"back"}).code,
            "edit.last_piece");
}

TEST(PatternEdit, AddsRemovesAndReversesSeams) {
  const pattern::Pattern was = two_sheets();
  const edit::AddSeam hem{"hem", {{"front", "bottom", true, 0.1, 0.9}}, {{"back", "bottom"}}, true};
  const pattern::Pattern now = edited(was, hem);
  ASSERT_EQ(now.seams.size(), 3u);
  EXPECT_EQ(now.seams[2].a[0].from, 0.1);
  EXPECT_FALSE(edited(now, edit::ReverseSeam{"hem"}).seams[2].same_direction);
  EXPECT_EQ(edited(now, edit::RemoveSeam{"side"}).seams[1].id, "hem");
  EXPECT_EQ(refused(now, hem).code, "pattern.duplicate_id");
  EXPECT_EQ(refused(was, edit::AddSeam{"twice", {{"front", "right"}}, {{"back", "bottom"}}, true}).code,
            "pattern.edge_sewn_twice");
}

TEST(PatternEdit, TellsWhatIsNotThereAndWhere) {
  const pattern::Pattern was = two_sheets();
  EXPECT_EQ(refused(was, edit::MovePoint{"sleeve", "right", 0, {}}).code, "edit.unknown_piece");
  EXPECT_EQ(refused(was, edit::MovePoint{"sleeve", "right", 0, {}}).where, "piece sleeve");
  EXPECT_EQ(refused(was, edit::MovePoint{"front", "cap", 0, {}}).code, "edit.unknown_edge");
  EXPECT_EQ(refused(was, edit::MovePoint{"front", "cap", 0, {}}).where, "piece front, edge cap");
  EXPECT_EQ(refused(was, edit::MovePoint{"front", "right", 3, {}}).code, "edit.unknown_point");
  EXPECT_EQ(refused(was, edit::MovePoint{"front", "right", -1, {}}).code, "edit.unknown_point");
  EXPECT_EQ(refused(was, edit::MoveHandle{"front", "right", 2, 1, {}}).code, "edit.unknown_point");
  EXPECT_EQ(refused(was, edit::MoveHandle{"front", "right", 0, 3, {}}).code, "edit.unknown_point");
  EXPECT_EQ(refused(was, edit::DeletePoint{"front", "right", 2}).code, "edit.unknown_point");
  EXPECT_EQ(refused(was, edit::DeletePoint{"front", "top", 1}).code, "edit.unknown_point");
  EXPECT_EQ(refused(was, edit::InsertPoint{"front", "top", 1}).code, "edit.out_of_range");
  EXPECT_EQ(refused(was, edit::InsertPoint{"front", "top", std::nan("")}).code, "edit.out_of_range");
  EXPECT_EQ(refused(was, edit::SetEdgeLength{"front", "top", -4, "start"}).code, "edit.out_of_range");
  EXPECT_EQ(refused(was, edit::SetEdgeLength{"front", "top", 40, "left"}).code, "edit.out_of_range");
  EXPECT_EQ(refused(was, edit::ReverseSeam{"hem"}).code, "edit.unknown_seam");
  EXPECT_EQ(refused(was, edit::MovePoint{"front", "right", 1, {std::nan(""), 0}}).code, "pattern.not_finite");
}

TEST(PatternEdit, RefusesAnOutlineThatCrossesItself) {
  const Error error = refused(two_sheets(), edit::MovePoint{"front", "right", 1, {-50, 100}});
  EXPECT_EQ(error.code, "pattern.self_crossing");
  EXPECT_NE(error.where.find("piece front"), std::string::npos);
}

TEST(PatternEdit, TellsWhichNamesAreOthersNow) {
  const Result<edit::EditedPattern> split =
      edit::apply_edit(two_sheets(), edit::SplitEdge{"front", "right", 0.25, "above"});
  ASSERT_TRUE(split);
  ASSERT_EQ(split->effect.parts.size(), 1u);
  EXPECT_EQ(split->effect.parts[0].was, "right");
  EXPECT_EQ(split->effect.parts[0].now, (std::vector<std::string>{"right", "above"}));
  const Result<edit::EditedPattern> renamed =
      edit::apply_edit(two_sheets(), edit::RenamePiece{"front", "fore"});
  ASSERT_TRUE(renamed);
  EXPECT_EQ(renamed->effect.was, "front");
  EXPECT_EQ(renamed->effect.piece, "fore");
  EXPECT_FALSE(renamed->effect.reshaped);
}

}  // namespace
}  // namespace toile
