#include "core/draft/skirt.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/pattern/curve.h"
#include "core/pattern/validate.h"

namespace toile {
namespace {

double edge_length(const pattern::Pattern& p, const pattern::SeamEdge& e) {
  return pattern::arc_length(p.panels[e.panel].outline.edges[e.edge]);
}

const pattern::PanelEdge& edge(const pattern::Pattern& p, const std::string& panel, const std::string& id) {
  for (const pattern::Panel& q : p.panels) {
    if (q.id != panel) continue;
    for (const pattern::PanelEdge& e : q.outline.edges)
      if (e.id == id) return e;
  }
  throw std::runtime_error("no edge " + panel + "." + id);
}

TEST(Skirt, IsAPatternThatCanBeCutAndSewn) {
  const Result<pattern::Pattern> p = draft::draft_skirt({});
  ASSERT_TRUE(p) << to_string(p.error());
  const Status s = pattern::validate(*p);
  EXPECT_TRUE(s) << to_string(s.error());
  EXPECT_EQ(p->panels.size(), 4u);
  EXPECT_EQ(p->seams.size(), 6u);
}

TEST(Skirt, HasTheGirthsAndTheLengthThatWereAsked) {
  const draft::SkirtMeasures m;
  const Result<pattern::Pattern> p = draft::draft_skirt(m);
  ASSERT_TRUE(p);
  EXPECT_NEAR(
      pattern::arc_length(edge(*p, "front", "waist")) + pattern::arc_length(edge(*p, "back", "waist")), 735,
      0.01);
  EXPECT_NEAR(
      pattern::arc_length(edge(*p, "band_front", "top")) + pattern::arc_length(edge(*p, "band_back", "top")),
      735, 1e-9);
  EXPECT_NEAR(pattern::arc_length(edge(*p, "front", "hem")) + pattern::arc_length(edge(*p, "back", "hem")),
              1600, 0.01);
  EXPECT_NEAR(pattern::arc_length(edge(*p, "front", "side_left")), 560, 0.01);
  EXPECT_LT(m.waist + m.waist_ease, m.hip) << "the band cannot slide over the hips";
}

TEST(Skirt, SewsSidesOfEqualLengthTheRightWayRound) {
  const draft::SkirtMeasures straight{
      .waist = 700, .hip = 1000, .waist_to_hip = 200, .length = 600, .hem = 1100};
  for (const draft::SkirtMeasures& m : {draft::SkirtMeasures{}, straight}) {
    const Result<pattern::Pattern> p = draft::draft_skirt(m);
    ASSERT_TRUE(p) << to_string(p.error());
    for (const pattern::Seam& s : p->seams)
      EXPECT_NEAR(edge_length(*p, s.a[0]), edge_length(*p, s.b[0]), 0.01) << s.id;
    for (const pattern::Panel& q : p->panels) {
      // Seen from outside, the wearer's left of the front is at +x, of the back at -x.
      const bool back = q.id == "back" || q.id == "band_back";
      for (const pattern::PanelEdge& e : q.outline.edges) {
        if (e.id != "side_left" && e.id != "end_left") continue;
        const double x = e.curves.front().p0.x - draft::skirt_middle(m, back);
        EXPECT_TRUE(back ? x < 0 : x > 0) << q.id;
      }
    }
  }
}

TEST(Skirt, SwellsToAHipCurveWhereTheFlareIsTooLittle) {
  const draft::SkirtMeasures m{.waist = 700, .hip = 1000, .waist_to_hip = 200, .length = 600, .hem = 1100};
  const Result<pattern::Pattern> p = draft::draft_skirt(m);
  ASSERT_TRUE(p) << to_string(p.error());
  const Status s = pattern::validate(*p);
  EXPECT_TRUE(s) << to_string(s.error());
  const pattern::PanelEdge& side = edge(*p, "front", "side_left");
  ASSERT_EQ(side.curves.size(), 2u);
  // At the hip: the arc of the cone and twice the swell make half of hip and ease.
  EXPECT_GT(side.curves[1].p0.x, side.curves[1].p3.x + 40);
  EXPECT_EQ(edge(*draft::draft_skirt({}), "front", "side_left").curves.size(), 1u)
      << "enough flare: a straight side";
}

TEST(Skirt, DraftsASkirtWithoutFlareAndAWideOne) {
  const draft::SkirtMeasures tube{.waist = 900, .hip = 860, .length = 500, .hem = 915};
  const Result<pattern::Pattern> p = draft::draft_skirt(tube);
  ASSERT_TRUE(p) << to_string(p.error());
  EXPECT_TRUE(pattern::validate(*p));
  const Result<pattern::Pattern> wide = draft::draft_skirt({.length = 500, .hem = 3500});
  ASSERT_TRUE(wide) << to_string(wide.error());
  const Status s = pattern::validate(*wide);
  EXPECT_TRUE(s) << to_string(s.error());
}

TEST(Skirt, RefusesMeasuresThatMakeNoSkirt) {
  EXPECT_EQ(draft::draft_skirt({.waist = -1}).error().where, "waist");
  EXPECT_EQ(draft::draft_skirt({.waist = std::numeric_limits<double>::quiet_NaN()}).error().where, "waist");
  EXPECT_EQ(draft::draft_skirt({.length = 100}).error().where, "length");
  EXPECT_EQ(draft::draft_skirt({.hem = 500}).error().where, "hem");
  EXPECT_EQ(draft::draft_skirt({.length = 300, .hem = 8000}).error().where, "hem");
  EXPECT_EQ(draft::draft_skirt({.band_height = 0}).error().code, "draft.measure");
}

}  // namespace
}  // namespace toile
