#include "core/pattern/dxf_write.h"

#include <gtest/gtest.h>

#include "core/pattern/curve.h"
#include "core/pattern/dxf_read.h"

namespace toile {
namespace {

Loop box(Vec2 low, Vec2 high, bool clockwise) {
  const Vec2 b{high.x, low.y}, d{low.x, high.y};
  const Loop loop{{{"e0", {line_segment(low, b)}},
                   {"e1", {line_segment(b, high)}},
                   {"e2", {line_segment(high, d)}},
                   {"e3", {line_segment(d, low)}}}};
  return clockwise ? reversed(loop) : loop;
}

TEST(DxfWrite, IsReadBackAsItWas) {
  Pattern pattern;
  Panel sleeve;
  sleeve.id = "sleeve";
  sleeve.outline = box({0, 0}, {200, 300}, false);
  // A curved top: 40 mm of bulge.
  sleeve.outline.edges[2].curves = {{{200, 300}, {150, 360}, {50, 360}, {0, 300}}};
  sleeve.holes = {box({50, 50}, {80, 90}, true)};
  sleeve.grain = {0.6, 0.8};
  Panel cuff;
  cuff.id = "cuff 2";
  cuff.outline = box({300, 0}, {520, 60}, false);
  pattern.panels = {sleeve, cuff};

  const Result<std::string> text = write_dxf(pattern);
  ASSERT_TRUE(text) << to_string(text.error());
  const Result<DxfDrawing> drawing = read_dxf(*text);
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  ASSERT_EQ(drawing->pieces.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const Panel& drafted = pattern.panels[i];
    const Result<Panel> read = panel_from_piece(drawing->pieces[i]);
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->id, drafted.id);
    EXPECT_EQ(read->holes.size(), drafted.holes.size());
    EXPECT_NEAR(signed_area(read->outline), signed_area(drafted.outline), 20);
    EXPECT_NEAR(std::abs(dot(read->grain, drafted.grain)), 1, 1e-6);
    ASSERT_EQ(read->outline.edges.size(), 4u);
    for (size_t e = 0; e < 4; ++e) {
      EXPECT_NEAR(arc_length(read->outline.edges[e]), arc_length(drafted.outline.edges[e]), 0.1);
    }
  }
}

TEST(DxfWrite, RefusesPiecesWithoutNameOrOutline) {
  EXPECT_EQ(write_dxf({}).error().code, "dxf.nothing_to_write");
  Pattern pattern;
  pattern.panels.resize(1);
  EXPECT_EQ(write_dxf(pattern).error().code, "dxf.bad_name");
  pattern.panels[0].id = "two\nlines";
  EXPECT_EQ(write_dxf(pattern).error().code, "dxf.bad_name");
  pattern.panels[0].id = "empty";
  EXPECT_EQ(write_dxf(pattern).error().code, "dxf.nothing_to_write");
}

}  // namespace
}  // namespace toile
