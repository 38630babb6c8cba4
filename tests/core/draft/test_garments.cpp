#include "core/draft/garments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/proportions.h"
#include "core/draft/circle_dress.h"
#include "core/draft/jacket.h"
#include "core/draft/lapel.h"
#include "core/draft/pencil_skirt.h"
#include "core/draft/trousers.h"
#include "core/draft/tshirt.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/dxf/write.h"
#include "core/pattern/validate.h"
#include "tests/core/draft/panel.h"

namespace toile {
namespace {

constexpr const char* kSizes[] = {"eu34", "eu38", "eu42",    "eu48",     "m44",
                                  "m50",  "m58",  "child92", "child116", "child152"};

/// Measured once for all tests: each takes a second.
const std::vector<draft::Wearer>& wearers() {
  static const std::vector<draft::Wearer> all = [] {
    std::vector<draft::Wearer> out;
    for (const char* size : kSizes) {
      const mannequin::BodyPreset* preset = mannequin::find_preset(size);
      const auto made = mannequin::make_mannequin(
          {.sex = preset->sex, .asked = preset->measures(), .triangle_count = 3300});
      out.push_back(draft::wearer_of(made.value().measures).value());
    }
    return out;
  }();
  return all;
}

/// mm of the piece that a level line through `y` covers.
double width_at(const pattern::Panel& p, double y) {
  const std::vector<Vec2> points = pattern::flatten(p.outline, 0.01);
  std::vector<double> at;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    if ((a.y < y) == (b.y < y)) continue;
    at.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
  std::sort(at.begin(), at.end());
  double sum = 0;
  for (size_t i = 0; i + 1 < at.size(); i += 2) sum += at[i + 1] - at[i];
  return sum;
}

double lowest(const pattern::Panel& p) {
  double y = HUGE_VAL;
  for (const Vec2 q : pattern::flatten(p.outline, 0.01)) y = std::min(y, q.y);
  return y;
}

/// Of all these pieces `above` mm over their hems.
double girth(const draft::Garment& g, const std::vector<std::string>& pieces, double above) {
  double sum = 0;
  for (const std::string& id : pieces) sum += width_at(panel(g, id), lowest(panel(g, id)) + above);
  return sum;
}

double length_of_side(const pattern::Pattern& p, const std::vector<pattern::SeamEdge>& side) {
  double sum = 0;
  for (const pattern::SeamEdge& e : side) sum += pattern::arc_length(p.panels[e.panel].outline.edges[e.edge]);
  return sum;
}

TEST(Garments, AreDraftedForChildrenMenAndWomenAsPatternsThatCanBeCut) {
  for (const draft::GarmentKind& kind : draft::garment_kinds()) {
    for (size_t i = 0; i < wearers().size(); ++i) {
      const draft::Garment g = kind.draft(wearers()[i]);
      EXPECT_EQ(g.name, kind.name);
      EXPECT_GE(g.cloths.size(), 2u) << g.name;
      const Status valid = pattern::validate(g.pattern);
      EXPECT_TRUE(valid) << g.name << ", " << kSizes[i] << ": " << to_string(valid.error());
    }
  }
}

TEST(Garments, SewEdgesOfOneLengthSaveWhereClothIsGatheredOrStretched) {
  const std::vector<std::string> eased{"neckband", "cuff_left", "cuff_right", "gathers"};
  for (const draft::GarmentKind& kind : draft::garment_kinds()) {
    for (size_t i = 0; i < wearers().size(); ++i) {
      const draft::Garment g = kind.draft(wearers()[i]);
      for (const pattern::Seam& seam : g.pattern.seams) {
        if (std::count(eased.begin(), eased.end(), seam.id) > 0) continue;
        const double a = length_of_side(g.pattern, seam.a), b = length_of_side(g.pattern, seam.b);
        const bool cap = seam.id.starts_with("armhole");  // a set-in sleeve's ease
        EXPECT_NEAR(a, b, std::max(2.5, (cap ? 0.05 : 0.01) * a))
            << g.name << ", " << kSizes[i] << ": " << seam.id;
      }
    }
  }
}

TEST(Garments, ComeBackFromTheirDxfEdgeForEdgeWithNotchesAndGrain) {
  for (const draft::GarmentKind& kind : draft::garment_kinds()) {
    const draft::Garment g = kind.draft({});
    const Result<std::string> text = dxf::write_dxf(g.pattern);
    ASSERT_TRUE(text) << to_string(text.error());
    const Result<dxf::DxfDrawing> read = dxf::read_dxf(*text);
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(read->pieces.size(), g.pattern.panels.size());
    for (size_t p = 0; p < read->pieces.size(); ++p) {
      const pattern::Panel& drafted = g.pattern.panels[p];
      const Result<pattern::Panel> back = dxf::panel_from_piece(read->pieces[p]);
      ASSERT_TRUE(back) << to_string(back.error());
      EXPECT_EQ(back->id, drafted.id);
      EXPECT_EQ(back->outline.edges.size(), drafted.outline.edges.size()) << g.name << " " << drafted.id;
      EXPECT_EQ(back->notches.size(), drafted.notches.size()) << g.name << " " << drafted.id;
      EXPECT_NEAR(std::abs(back->grain.y), 1, 1e-6);
    }
  }
}

TEST(Tshirt, IsAsWideAsItsConstructionSaysOnEveryBody) {
  for (const draft::Wearer& w : wearers()) {
    const draft::Garment g = draft::draft_tshirt(w);
    const pattern::Panel& front = panel(g, "front");
    const std::vector<std::string> body{"front", "back"};
    const double underarm = draft::edge_of(front, "armhole_left").curves.front().p0.y - lowest(front);
    EXPECT_NEAR(girth(g, body, underarm - 0.5) - w.bust, 0.13 * w.bust, 10) << w.bust;
    EXPECT_GE(girth(g, body, 1) - w.hip, 40 * w.height / 1680 - 10) << w.bust;
    EXPECT_EQ(g.girths.front().place, "bust");
    EXPECT_NEAR(g.girths.front().garment, girth(g, body, underarm - 0.5), 1);
  }
}

TEST(Slacks, AreAsWideAsTheirConstructionSaysOnEveryBody) {
  for (const draft::Wearer& w : wearers()) {
    const draft::Garment g = draft::draft_slacks(w);
    const std::vector<std::string> legs{"left front", "right front", "left back", "right back"};
    const double hips = w.hip_height - 70 * w.height / 1680, ease = 60 * w.height / 1680;
    EXPECT_NEAR(girth(g, legs, hips) - w.hip, ease, 10) << w.hip;
    const double band = pattern::arc_length(draft::edge_of(panel(g, "waistband"), "waist"));
    EXPECT_NEAR(band - w.waist, 10 * w.height / 1680, 10) << w.waist;
  }
}

TEST(PencilSkirt, IsAsWideAsItsConstructionSaysOnEveryBody) {
  for (const draft::Wearer& w : wearers()) {
    const draft::Garment g = draft::draft_pencil_skirt(w);
    const double hips = w.hip_height - 0.285 * w.height, ease = 50 * w.height / 1680;
    EXPECT_NEAR(girth(g, {"front", "left back", "right back"}, hips) - w.hip, ease, 10) << w.hip;
    const double band = pattern::arc_length(draft::edge_of(panel(g, "waistband"), "waist"));
    EXPECT_NEAR(band - w.waist, 10 * w.height / 1680, 10) << w.waist;
  }
}

TEST(CircleDress, HangsAFullCircleFromItsWaist) {
  const draft::Garment g = draft::draft_circle_dress({});
  double hem = 0, waist = 0;
  for (const char* id : {"skirt front", "skirt left back", "skirt right back"}) {
    hem += pattern::arc_length(draft::edge_of(panel(g, id), "hem"));
    waist += pattern::arc_length(draft::edge_of(panel(g, id), "waist"));
  }
  EXPECT_NEAR(waist, 760 + 25, 10);
  EXPECT_NEAR(hem - waist, 2 * 3.14159265 * 620, 1) << "a circle's circumference grows by 2 pi a length";
}

TEST(Jacket, IsAsWideAsItsConstructionSaysOnEveryBody) {
  const std::vector<std::string> sides{"left", "right"};
  for (const draft::Wearer& w : wearers()) {
    const draft::Garment g = draft::draft_jacket(w);
    const double scale = w.height / 1680, hem = w.waist_to_hip() + 30 * scale;
    EXPECT_GE(g.pattern.panels.size(), 10u);
    // Fronts are narrower than the quarter by what the lapels' fronts are cut away at the hem.
    double hip = 0;
    for (const std::string& side : sides)
      for (const std::string piece : {" front", " side front", " back", " side back"})
        hip += width_at(panel(g, side + piece), lowest(panel(g, side + piece)) + hem - w.waist_to_hip());
    EXPECT_NEAR(hip, g.girths[2].garment, 45 * scale) << w.hip;
    EXPECT_GE(g.girths[2].ease(), 75 * scale) << w.hip;
    EXPECT_GE(g.girths[1].ease(), -1) << w.waist;
    EXPECT_NEAR(g.girths[0].ease(), 110 * scale, 10) << w.bust;
  }
}

TEST(Jacket, RollsAlongOneLineFromLapelToCollar) {
  draft::LapelDraft d;
  d.neck = {77, 380};
  d.shoulder = {190, 330};
  d.break_point = {0, 40};
  const draft::Lapel lapel = draft::lapel_of(d);
  const pattern::InnerLine roll = draft::lapel_roll(d);
  EXPECT_EQ(roll.points.front(), d.break_point);
  EXPECT_EQ(roll.points.back(), lapel.roll_top);
  const pattern::Panel collar = draft::collar_of("collar", d);
  const Vec2 joint = draft::edge_of(collar, "gorge_inner_right").curves.back().p3;
  const std::vector<Vec2>& on_collar = collar.lines.front().points;
  EXPECT_LT(length(on_collar.front() - joint), 1e-9) << "the collar's line begins where the lapel's ends";
  EXPECT_NEAR(pattern::arc_length(draft::edge_of(collar, "neck")), 2 * d.back_neck, 1);
  EXPECT_NEAR(on_collar[on_collar.size() / 2].y, d.stand, 1e-6) << "as high as the stand behind";
  // Turned over, the tip lies on the body's side of the line, as far as the lapel is wide.
  const Vec2 up = normalized(lapel.roll_top - d.break_point), out = lapel.tip - lapel.roll_top;
  EXPECT_GT(cross(up, out), 0) << "unrolled it lies beyond the line";
  EXPECT_NEAR(length(out), d.width, 1e-6);
}

TEST(Wearer, RefusesABodyWithoutTheMeasuresThatItNeeds) {
  measure::BodyMeasures none;
  EXPECT_EQ(draft::wearer_of(none).error().code, "draft.measure");
  EXPECT_EQ(draft::wearer_of(none).error().where, "height");
}

}  // namespace
}  // namespace toile
