// Darts are closed and edges joined before seams are sought.

#include <gtest/gtest.h>

#include "core/pattern/curve.h"
#include "core/pattern/seams/lines.h"
#include "core/pattern/validate.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using seams::SeamLines;

/// A piece with a dart of legs e2 and e3 in its upper edge, or, turned about, in its lower one.
pattern::Panel darted(const std::string& id, double width) {
  return garments::piece(
      id,
      {{0, 0}, {400, 0}, {400, 500}, {200 + width / 2, 500}, {200, 380}, {200 - width / 2, 500}, {0, 500}});
}

TEST(SeamLines, CloseADartAndJoinWhatItParted) {
  const pattern::Pattern pattern{{darted("front", 24)}, {}};
  const SeamLines lines = seams::lines_of(pattern);
  ASSERT_EQ(lines.darts.size(), 1u);
  EXPECT_EQ(lines.darts[0].first, 3);
  EXPECT_EQ(lines.darts[0].second, 4);
  EXPECT_FALSE(lines.darts[0].slit);
  ASSERT_EQ(lines.pattern.panels[0].outline.edges.size(), 4u);
  const std::vector<Index> waist{2, 5};
  EXPECT_EQ(lines.edges[0][2], waist);
  EXPECT_NEAR(pattern::arc_length(lines.pattern.panels[0].outline.edges[2]), 400 - 24, 1e-6);
}

TEST(SeamLines, LeaveAWideNotchForThePieceThatIsLetIn) {
  EXPECT_TRUE(seams::lines_of({{darted("front", 160)}, {}}).darts.empty());
}

/// A whole front with a V neck, so wide; or with the V off its middle.
pattern::Panel with_v_neck(double width, double off = 0) {
  return garments::piece("front", {{-200, 0},
                                   {200, 0},
                                   {200, 400},
                                   {width / 2 + off, 440},
                                   {off, 250},
                                   {-width / 2 + off, 440},
                                   {-200, 400}});
}

TEST(SeamLines, LeaveTheNeckOfAVOpen) {
  EXPECT_TRUE(seams::lines_of({{with_v_neck(160)}, {}}).darts.empty());
  EXPECT_EQ(seams::lines_of({{with_v_neck(60)}, {}}).darts.size(), 1u) << "no head goes through";
}

/// Programs cut waists straight: across such a wide dart the closed outline bends, the drawn one does not.
TEST(SeamLines, CloseAWideDartInAStraightWaist) {
  EXPECT_EQ(seams::lines_of({{darted("skirt_front", 64)}, {}}).darts.size(), 1u);
  EXPECT_TRUE(seams::lines_of({{darted("bodice_front", 64)}, {}}).darts.empty())
      << "it may be meant for another piece";
}

TEST(SeamLines, TakeWhatOpensInTheHemOfASkirtForASlit) {
  const auto hem_opening = [](const std::string& id) {
    pattern::Panel panel = garments::turned(darted(id, 24), 3.14159265358979);
    panel.grain = {0, 1};
    return seams::lines_of({{panel}, {}}).darts.at(0).slit;
  };
  EXPECT_TRUE(hem_opening("skirt_front"));
  EXPECT_FALSE(hem_opening("bodice_front")) << "a dart at the waist";
}

TEST(SeamLines, NameTheDrawnEdgesOfAPartOfALine) {
  const pattern::Pattern pattern{{darted("front", 24)}, {}};
  const SeamLines lines = seams::lines_of(pattern);
  const std::vector<pattern::SeamEdge> whole = seams::edges_of_line(lines, pattern, {0, 2});
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].edge, 2);
  EXPECT_EQ(whole[1].edge, 5);
  const std::vector<pattern::SeamEdge> half = seams::edges_of_line(lines, pattern, {0, 2, false, 0, 0.5});
  ASSERT_EQ(half.size(), 1u) << "the dart is in the middle";
  EXPECT_EQ(half[0].edge, 2);
  EXPECT_EQ(half[0].to, 1);
  const std::vector<pattern::SeamEdge> back = seams::edges_of_line(lines, pattern, {0, 2, true, 0.25, 1});
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].edge, 5) << "run the other way, the last edge comes first";
  EXPECT_NEAR(back[1].from, 0.5, 1e-9);
}

TEST(SeamLines, LeaveEdgesAloneThatAreSewnAlready) {
  pattern::Pattern pattern{{darted("front", 24)}, {}};
  pattern.seams = {{"dart", {{0, 3}}, {{0, 4}}}};
  const SeamLines lines = seams::lines_of(pattern);
  EXPECT_TRUE(lines.darts.empty());
  EXPECT_EQ(lines.pattern.panels[0].outline.edges.size(), 7u);
  EXPECT_EQ(lines.pattern.seams[0].a[0].edge, 3);
}

TEST(SeamLines, JoinEdgesOfABodiceThatAreOneLine) {
  const std::vector<garments::Node> nodes{{0, 0}, {300, 0}, {300, 100}, {300, 400}, {0, 400}};
  const SeamLines bodice = seams::lines_of({{garments::piece("bodice_front", nodes)}, {}});
  EXPECT_EQ(bodice.pattern.panels[0].outline.edges.size(), 4u);
  const std::vector<garments::Node> halves{{0, 0}, {300, 0}, {300, 400}, {150, 400}, {0, 400}};
  const SeamLines marked = seams::lines_of({{garments::piece("bodice_front", halves)}, {}});
  EXPECT_EQ(marked.pattern.panels[0].outline.edges.size(), 5u) << "a marked middle is a corner";
  const SeamLines nameless = seams::lines_of({{garments::piece("p1", nodes)}, {}});
  EXPECT_EQ(nameless.pattern.panels[0].outline.edges.size(), 5u);
}

}  // namespace
}  // namespace toile
