// Figures of a fabric found from others, most of them with a stand-in for the drape whose answer is known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/card.h"
#include "core/fabric/library.h"
#include "core/trials/calibrate.h"

namespace toile {
namespace {

/// A drape that grows with the bending length, and a little with shear; counts how often it is asked.
trials::DrapeTest stand_in(int& asked) {
  return [&asked](const material::Fabric& f) -> Result<double> {
    ++asked;
    const double c = fabric::bending_length((f.bend_warp + f.bend_weft) / 2, f.areal_mass);
    return 1 / (1 + std::exp(-(c - 0.018) / 0.005)) * (1 - 0.1 / (1 + f.stretch_shear / 50));
  };
}

TEST(CalibrateUnits, AreThoseOfTheInstruments) {
  EXPECT_NEAR(trials::rigidity_of_length(0.021, 0.115), 10.4e-6, 0.1e-6) << "poplin along its warp";
  EXPECT_NEAR(trials::rigidity_of_kes(0.1), 9.807e-6, 1e-9);
  EXPECT_NEAR(trials::shear_of_fast(4.1), 30, 1e-12) << "FAST: G = 123 / EB5";
  EXPECT_NEAR(trials::shear_of_kes(1), 56.19, 0.01);
}

TEST(Calibrate, TakesWhatWasMeasuredAsItIs) {
  trials::Measured m;
  m.areal_mass = 0.15;
  m.length_warp = 0.021;
  m.kes_bend_weft = 0.08;
  m.kes_emt_warp = 4;
  m.fast_e100_weft = 2;
  m.kes_shear = 0.8;
  m.thickness = 0.4e-3;
  const material::Fabric f = trials::fabric_from(m).value();
  EXPECT_DOUBLE_EQ(f.bend_warp, trials::rigidity_of_length(0.021, 0.15));
  EXPECT_DOUBLE_EQ(f.bend_weft, trials::rigidity_of_kes(0.08));
  EXPECT_DOUBLE_EQ(f.stretch_warp, 490 / 0.04);
  EXPECT_DOUBLE_EQ(f.stretch_weft, 98.1 / 0.02);
  EXPECT_DOUBLE_EQ(f.stretch_shear, trials::shear_of_kes(0.8));
  EXPECT_DOUBLE_EQ(f.thickness, 0.4e-3);
  EXPECT_TRUE(trials::missing(m).empty());
}

TEST(Calibrate, RefusesFiguresOutOfRangeOrToldTwice) {
  trials::Measured m;
  EXPECT_EQ(trials::fabric_from(m).error().where, "mass");
  m.areal_mass = 150;
  EXPECT_EQ(trials::fabric_from(m).error().code, "calibrate.figure") << "that was meant in g/m²";
  m.areal_mass = 0.15;
  m.length_warp = 0.02;
  m.kes_bend_warp = 0.1;
  EXPECT_EQ(trials::fabric_from(m).error().code, "calibrate.figure");
  m.kes_bend_warp.reset();
  m.fast_eb5 = 3;
  m.kes_shear = 1;
  EXPECT_EQ(trials::fabric_from(m).error().where, "fast-eb5, kes-g");
}

TEST(Calibrate, FindsBendingFromTheDrapeWithinAPointAndItsTests) {
  for (const double wanted : {0.15, 0.35, 0.62, 0.85}) {
    trials::Measured m;
    m.areal_mass = 0.15;
    m.drape = wanted;
    int asked = 0;
    const trials::Calibration c = trials::calibrate(m, stand_in(asked), 10).value();
    EXPECT_TRUE(c.within) << wanted;
    EXPECT_NEAR(c.drape, wanted, 0.01);
    EXPECT_EQ(c.fitted, trials::Unknown::kBending);
    EXPECT_EQ(c.tests, asked);
    EXPECT_LE(asked, 10);
  }
}

TEST(Calibrate, SaysWhatTheDrapeCouldNotTell) {
  trials::Measured m;
  m.areal_mass = 0.15;
  m.drape = 0.62;
  int asked = 0;
  const trials::Calibration c = trials::calibrate(m, stand_in(asked), 10).value();
  const auto told = [&](const std::string& words) {
    return std::any_of(c.open.begin(), c.open.end(),
                       [&](const std::string& s) { return s.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(told("which bending could make as well")) << "shear counts in this drape";
  EXPECT_TRUE(told("the drape does not tell it")) << "stretch does not";
  EXPECT_TRUE(told("warp and weft are taken to be alike"));
  EXPECT_TRUE(told("bias was not measured"));
}

TEST(Calibrate, FindsShearWhereBendingWasMeasured) {
  trials::Measured m;
  m.areal_mass = 0.15;
  m.length_warp = m.length_weft = 0.021;
  int asked = 0;
  const trials::DrapeTest test = stand_in(asked);
  material::Fabric truth = trials::fabric_from(m).value();
  truth.stretch_shear = 20;
  m.drape = test(truth).value();
  const trials::Calibration c = trials::calibrate(m, test, 10).value();
  EXPECT_EQ(c.fitted, trials::Unknown::kShear);
  EXPECT_TRUE(c.within);
  EXPECT_DOUBLE_EQ(c.fabric.bend_warp, truth.bend_warp) << "what was measured stays";
}

TEST(Calibrate, SaysWhenTheMeasuredFiguresDoNotFitTheDrape) {
  trials::Measured m;
  m.areal_mass = 0.15;
  m.length_warp = m.length_weft = 0.03;
  m.kes_shear = 1;
  m.drape = 0.3;
  int asked = 0;
  const trials::Calibration c = trials::calibrate(m, stand_in(asked), 10).value();
  EXPECT_FALSE(c.fitted);
  EXPECT_FALSE(c.within);
  EXPECT_GT(c.off, 0.3);
}

TEST(Calibrate, WithoutADrapeNothingIsDraped) {
  trials::Measured m;
  m.areal_mass = 0.15;
  m.length_warp = 0.02;
  int asked = 0;
  const trials::Calibration c = trials::calibrate(m, stand_in(asked), 10).value();
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(c.fabric.bend_weft, c.fabric.bend_warp);
}

TEST(Calibrate, FindsAFabricAgainFromItsOwnDrape) {
  // Coarse triangles and one drape a test: that it is found again matters here, not how it compares outside.
  const trials::DrapeTest test = trials::cusick_test(1, 0.014, {});
  const material::Fabric poplin = fabric::fabric_of(*fabric::find("poplin"));
  trials::Measured m;
  m.areal_mass = poplin.areal_mass;
  m.kes_shear = poplin.stretch_shear / trials::shear_of_kes(1);
  m.drape = test(poplin).value();
  const trials::Calibration c = trials::calibrate(m, test, 12).value();
  EXPECT_TRUE(c.within) << c.drape << " for " << *m.drape;
  EXPECT_LE(c.tests, 12);
  const auto length_of = [](const material::Fabric& f) {
    return fabric::bending_length((f.bend_warp + f.bend_weft) / 2, f.areal_mass);
  };
  EXPECT_NEAR(length_of(c.fabric) / length_of(poplin), 1, 0.15);
}

}  // namespace
}  // namespace toile
