#include "core/analysis/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/girth.h"
#include "core/base/units.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/measure/lines.h"

namespace toile {
namespace {

constexpr int kAround = 60, kUp = 12;

/// A garment of one piece after another.
struct Tubes {
  drape::DrapeInput input;
  drape::DrapeResult result;
  Tubes() {
    input.fabrics.resize(1);
    result.worn = drape::Worn::kYes;
  }

  /// A tube around a vertical axis: in space of girth `worn_low` at `low` and `worn_high` at `high` (m), flat
  /// `flat` m around. Sewn at one side unless it is left open.
  void add(Vec3 axis, double low, double high, double worn_low, double worn_high, double flat,
           bool sewn = true) {
    sewing::GarmentMesh& g = result.garment;
    const Index first = g.vertex_count(), panel = static_cast<Index>(input.pattern.panels.size());
    input.pattern.panels.emplace_back().id = "tube " + std::to_string(panel);
    input.pattern.panels.back().grain = {0, 1};
    input.fabric_of_panel.push_back(0);
    for (int j = 0; j <= kUp; ++j) {
      for (int i = 0; i <= kAround; ++i) {
        const double share = static_cast<double>(j) / kUp, angle = 2 * kPi * i / kAround;
        const double radius = (worn_low + (worn_high - worn_low) * share) / (2 * kPi);
        g.rest.push_back({flat * i / kAround, (high - low) * share});
        result.positions.push_back({axis.x + radius * std::sin(angle), low + (high - low) * share,
                                    axis.z + radius * std::cos(angle)});
        const Index v = g.vertex_count() - 1;
        g.weld.push_back(sewn && i == kAround ? v - kAround : v);
      }
    }
    for (int j = 0; j < kUp; ++j) {
      for (int i = 0; i < kAround; ++i) {
        const Index a = first + j * (kAround + 1) + i, b = a + kAround + 1;
        g.triangles.push_back({a, a + 1, b});
        g.triangles.push_back({a + 1, b + 1, b});
        g.panel_of_triangle.insert(g.panel_of_triangle.end(), {panel, panel});
      }
    }
  }
  std::optional<analysis::GarmentGirth> girth(const analysis::TapePlane& plane) const {
    return analysis::girth_around(input, result, plane);
  }
};

const Vec3 kUpright{0, 1, 0};

TEST(Girth, OfACylinderIsItsFlatWidthAndItsWornLength) {
  Tubes t;
  t.add({0.1, 0, -0.2}, 0.9, 1.1, 0.84, 0.84, 0.80);
  const auto girth = t.girth({{0.1, 1.003, -0.2}, kUpright});
  ASSERT_TRUE(girth);
  EXPECT_NEAR(girth->flat, 0.80, 1e-9);
  EXPECT_NEAR(girth->worn, 0.84, 0.84 * 1e-3) << "a polygon of 120 corners";
  EXPECT_EQ(girth->panels, std::vector<Index>{0});
  EXPECT_NEAR(girth->compliance, 1 / t.input.fabrics[0].stretch_weft, 1e-9);
}

TEST(Girth, OfACylinderCutAtASlantIsTheEllipses) {
  Tubes t;
  t.add({}, 0.5, 1.5, 2 * kPi * 0.1, 2 * kPi * 0.1, 2 * kPi * 0.1);
  const double tilt = 0.5;
  const auto girth = t.girth({{0, 1, 0}, {0, std::cos(tilt), std::sin(tilt)}});
  ASSERT_TRUE(girth);
  const double a = 0.1 / std::cos(tilt), b = 0.1, h = (a - b) * (a - b) / ((a + b) * (a + b));
  const double ramanujan = kPi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  EXPECT_NEAR(girth->flat, ramanujan, 1e-3);
}

TEST(Girth, OfAConeChangesWithItsHeight) {
  Tubes t;
  t.add({}, 0, 1, 1.2, 0.6, 0.9);
  EXPECT_NEAR(t.girth({{0, 0.25, 0}, kUpright})->worn, 1.05, 2e-3);
  EXPECT_NEAR(t.girth({{0, 0.75, 0}, kUpright})->worn, 0.75, 2e-3);
}

TEST(Girth, OfLayersIsTheTightest) {
  Tubes t;
  t.add({}, 0, 1, 0.9, 0.9, 0.9);
  t.add({}, 0, 1, 0.8, 0.8, 0.8);
  const auto girth = t.girth({{0, 0.503, 0}, kUpright});
  EXPECT_NEAR(girth->flat, 0.8, 1e-9);
  EXPECT_EQ(girth->panels, std::vector<Index>{1});
}

TEST(Girth, IsNoneWhereTheClothDoesNotCloseOrGoesAroundSomethingElse) {
  Tubes open;
  open.add({}, 0, 1, 0.9, 0.9, 0.9, false);
  EXPECT_FALSE(open.girth({{0, 0.5, 0}, kUpright}));
  Tubes t;
  t.add({}, 0, 1, 0.9, 0.9, 0.9);
  EXPECT_FALSE(t.girth({{0.5, 0.5, 0}, kUpright}));
  EXPECT_FALSE(t.girth({{0, 1.5, 0}, kUpright}));
}

TEST(Girth, OfALegIsNotThatOfTheSkirtAroundBoth) {
  Tubes t;
  const Vec3 left{0.1, 0.5, 0}, right{-0.1, 0.5, 0};
  t.add({}, 0, 1, 1.2, 1.2, 1.2);
  EXPECT_FALSE(t.girth({left, kUpright, right}));
  t.add({0.1, 0, 0}, 0, 1, 0.5, 0.5, 0.55);
  EXPECT_NEAR(t.girth({left, kUpright, right})->flat, 0.55, 1e-9);
}

class FitTable : public testing::Test {
 protected:
  FitTable() {
    mannequin::MannequinSettings settings;
    settings.triangle_count = 3300;
    const auto made = mannequin::make_mannequin(settings);
    body.mesh = made->mesh;
    figure = *measure::find_figure(body.mesh);
    figure.waist = made->measures.points.waist_height;
    waist = measure::length_of_loop(*measure::body_line(measure::PlaneCutter(body.mesh), figure, "waist"));
    // Wide enough in space to be clear of the body; flat as each test asks.
    tubes.input.bodies = tubes.result.bodies = {body};
  }
  /// The waist's line with a tube of that flat width around it, from 5 cm below to as much above.
  std::vector<analysis::FitLine> with_band(double flat) {
    tubes.add({figure.middle, 0, 0.01}, figure.waist - 0.05, figure.waist + 0.05, 1.1, 1.1, flat);
    return analysis::fit_table(tubes.input, tubes.result);
  }
  body::Body body;
  measure::BodyFigure figure;
  double waist = 0;
  Tubes tubes;
};

TEST_F(FitTable, SaysHowFarAWaistIsTooTight) {
  tubes.input.fabrics[0].stretch_weft = 2e4;
  const auto table = with_band(waist - 0.021);
  ASSERT_EQ(table.size(), 1u);
  EXPECT_EQ(table[0].place, "waist");
  EXPECT_EQ(table[0].fit, analysis::Fit::kTooTight);
  EXPECT_EQ(analysis::fit_text(table[0]), "waist 2.1 cm too tight");
  const preflight::Findings findings = analysis::find_too_tight(table);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(preflight::code_of(findings[0].kind), "fit.too_tight");
  EXPECT_EQ(findings[0].about, preflight::Concerns{preflight::piece_named("tube 0")});
}

TEST_F(FitTable, LetsStretchClothBeNarrowerThanTheBody) {
  tubes.input.fabrics[0].stretch_weft = 500;  // 1.5 kPa of pressure stretch it by a third
  const auto table = with_band(waist * 0.9);
  EXPECT_EQ(table[0].fit, analysis::Fit::kStretched);
  EXPECT_NE(analysis::fit_text(table[0]).find("the cloth stretches by 11 %"), std::string::npos);
  EXPECT_TRUE(analysis::find_too_tight(table).empty());
}

TEST_F(FitTable, TellsTheEaseOfWhatFits) {
  const auto table = with_band(waist + 0.08);
  EXPECT_NEAR(table[0].ease(), 0.08, 1e-9);
  EXPECT_EQ(table[0].shifted, 0);
  EXPECT_EQ(analysis::fit_text(table[0]), "waist 8.0 cm of ease");
}

TEST_F(FitTable, TakesTheNearestPlaceThatTheGarmentHas) {
  tubes.add({figure.middle, 0, 0.01}, figure.waist - 0.09, figure.waist - 0.018, 1.1, 1.1, 1.0);
  const auto table = analysis::fit_table(tubes.input, tubes.result);
  ASSERT_EQ(table.size(), 1u);
  EXPECT_NEAR(table[0].shifted, -0.02, 1e-9);
}

TEST_F(FitTable, IsEmptyWhereNobodyWearsIt) {
  tubes.result.worn = drape::Worn::kNobody;
  EXPECT_TRUE(with_band(1).empty());
}

}  // namespace
}  // namespace toile
