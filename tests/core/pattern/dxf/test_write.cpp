#include "core/pattern/dxf/write.h"

#include <gtest/gtest.h>

#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"

namespace toile {
namespace {

pattern::Loop box(Vec2 low, Vec2 high, bool clockwise) {
  const Vec2 b{high.x, low.y}, d{low.x, high.y};
  const pattern::Loop loop{{{"e0", {pattern::line_segment(low, b)}},
                            {"e1", {pattern::line_segment(b, high)}},
                            {"e2", {pattern::line_segment(high, d)}},
                            {"e3", {pattern::line_segment(d, low)}}}};
  return clockwise ? pattern::reversed(loop) : loop;
}

TEST(DxfWrite, IsReadBackAsItWas) {
  pattern::Pattern pattern;
  pattern::Panel sleeve;
  sleeve.id = "sleeve";
  sleeve.outline = box({0, 0}, {200, 300}, false);
  // A curved top: 40 mm of bulge.
  sleeve.outline.edges[2].curves = {{{200, 300}, {150, 360}, {50, 360}, {0, 300}}};
  sleeve.holes = {box({50, 50}, {80, 90}, true)};
  sleeve.grain = {0.6, 0.8};
  pattern::Panel cuff;
  cuff.id = "cuff 2";
  cuff.outline = box({300, 0}, {520, 60}, false);
  pattern.panels = {sleeve, cuff};

  const Result<std::string> text = dxf::write_dxf(pattern);
  ASSERT_TRUE(text) << to_string(text.error());
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(*text);
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  ASSERT_EQ(drawing->pieces.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const pattern::Panel& drafted = pattern.panels[i];
    const Result<pattern::Panel> read = dxf::panel_from_piece(drawing->pieces[i]);
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->id, drafted.id);
    EXPECT_EQ(read->holes.size(), drafted.holes.size());
    EXPECT_NEAR(pattern::signed_area(read->outline), pattern::signed_area(drafted.outline), 20);
    EXPECT_NEAR(std::abs(dot(read->grain, drafted.grain)), 1, 1e-6);
    ASSERT_EQ(read->outline.edges.size(), 4u);
    for (size_t e = 0; e < 4; ++e) {
      EXPECT_NEAR(pattern::arc_length(read->outline.edges[e]), pattern::arc_length(drafted.outline.edges[e]),
                  0.1);
    }
  }
}

TEST(DxfWrite, EdgesInOneLineNotchesAndGrainComeBack) {
  pattern::Panel panel;
  panel.id = "side";
  const Vec2 a{0, 0}, b{120, 0}, c{400, 0}, d{400, 500}, e{0, 500};
  panel.outline.edges = {{"e0", {pattern::line_segment(a, b)}},
                         {"e1", {pattern::line_segment(b, c)}},  // straight on: only the file can tell
                         {"e2", {pattern::CubicBezier{c, {460, 150}, {460, 350}, d}}},
                         {"e3", {pattern::line_segment(d, e)}},
                         {"e4", {pattern::line_segment(e, a)}}};
  panel.grain = {1, 0};
  panel.notches = {{{200, 0}, 6, {0, 1}}, {pattern::point_at_length(panel.outline.edges[2], 200), 4, {}}};
  panel.lines = {{"dart", {{50, 100}, {90, 200}, {130, 100}}}};
  const Result<std::string> text = dxf::write_dxf({{panel}, {}});
  ASSERT_TRUE(text) << to_string(text.error());
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(*text);
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  ASSERT_EQ(drawing->pieces.size(), 1u);
  EXPECT_EQ(drawing->unit.name, "mm");
  EXPECT_TRUE(drawing->report.warnings.empty());
  ASSERT_EQ(drawing->pieces[0].internals.size(), 1u);
  EXPECT_EQ(drawing->pieces[0].internals[0], panel.lines[0].points);
  const Result<pattern::Panel> read = dxf::panel_from_piece(drawing->pieces[0]);
  ASSERT_TRUE(read) << to_string(read.error());
  ASSERT_EQ(read->outline.edges.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(read->outline.edges[i].id, panel.outline.edges[i].id);
    for (double s = 0; s <= 1; s += 0.125) {
      const Vec2 was =
          pattern::point_at_length(panel.outline.edges[i], s * pattern::arc_length(panel.outline.edges[i]));
      const Vec2 is =
          pattern::point_at_length(read->outline.edges[i], s * pattern::arc_length(read->outline.edges[i]));
      EXPECT_LT(length(is - was), 0.1) << panel.outline.edges[i].id << " at " << s;
    }
  }
  ASSERT_EQ(read->notches.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(length(read->notches[i].at - panel.notches[i].at), 0.1);
    EXPECT_NEAR(read->notches[i].depth, panel.notches[i].depth, 1e-4);
    EXPECT_LT(length(read->notches[i].inwards - panel.notches[i].inwards), 1e-4);
  }
  EXPECT_EQ(read->grain, panel.grain);
  ASSERT_EQ(read->lines.size(), 1u);
  EXPECT_TRUE(read->lines[0].drawn);
}

TEST(DxfWrite, LinesWithinAPieceComeBackAndGoOutAgain) {
  pattern::Panel panel;
  panel.id = "front";
  panel.outline = box({0, 0}, {300, 400}, false);
  panel.lines = {{"fold", {{10, 200}, {290, 200}}},
                 {"pocket", {{50, 50.05}, {110, 50}, {110, 120}, {50, 120}, {50, 50.05}}, true},
                 {"curve", {{200, 50}, {210, 61.5}, {222, 70.25}, {240.125, 75}}, true}};
  std::string text = dxf::write_dxf({{panel}, {}}).value();
  for (int round = 0; round < 2; ++round) {
    const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(text);
    ASSERT_TRUE(drawing) << to_string(drawing.error());
    const pattern::Panel read = dxf::panel_from_piece(drawing->pieces[0]).value();
    ASSERT_EQ(read.lines.size(), 3u);
    for (std::size_t l = 0; l < 3; ++l) {
      EXPECT_EQ(read.lines[l].id, "i" + std::to_string(l));
      ASSERT_EQ(read.lines[l].points.size(), panel.lines[l].points.size()) << l;
      for (std::size_t i = 0; i < read.lines[l].points.size(); ++i)
        EXPECT_LT(length(read.lines[l].points[i] - panel.lines[l].points[i]), 0.1) << l << ", " << i;
    }
    text = dxf::write_dxf({{read}, {}}).value();
  }
}

TEST(DxfWrite, RefusesPiecesWithoutNameOrOutline) {
  EXPECT_EQ(dxf::write_dxf({}).error().code, "dxf.nothing_to_write");
  pattern::Pattern pattern;
  pattern.panels.resize(1);
  EXPECT_EQ(dxf::write_dxf(pattern).error().code, "dxf.bad_name");
  pattern.panels[0].id = "two\nlines";
  EXPECT_EQ(dxf::write_dxf(pattern).error().code, "dxf.bad_name");
  pattern.panels[0].id = "empty";
  EXPECT_EQ(dxf::write_dxf(pattern).error().code, "dxf.nothing_to_write");
}

}  // namespace
}  // namespace toile
