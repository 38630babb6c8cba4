// Laboratory tests of cloth with answers that are known beforehand, for fabrics of the library.

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/fabric/library.h"
#include "core/trials/cantilever.h"
#include "core/trials/cusick.h"
#include "core/trials/shear.h"
#include "core/trials/slide.h"
#include "core/trials/tension.h"
#include "core/trials/tube.h"

namespace toile {
namespace {

material::Fabric cloth(const char* name) { return fabric::fabric_of(*fabric::find(name)); }

TEST(Cantilever, PeircesLengthIsHalfAnOverhangThatFallsByTheStandardsAngle) {
  EXPECT_NEAR(trials::peirce_length(0.1, 41.5), 0.05, 1e-3) << "his formula is 2 % off there";
}

void expect_own_length(const char* name) {
  const material::Fabric fabric = cloth(name);
  const trials::CantileverResult warp = trials::cantilever(fabric, {0, 1}, fabric.bend_warp);
  const trials::CantileverResult weft = trials::cantilever(fabric, {1, 0}, fabric.bend_weft);
  EXPECT_NEAR(warp.measured / warp.known, 1, 0.03) << name << ", warp: " << warp.angle;
  EXPECT_NEAR(weft.measured / weft.known, 1, 0.03) << name << ", weft: " << weft.angle;
}

TEST(Cantilever, ALimpAndAStiffFabricBendByTheirOwnLengths) {
  expect_own_length("silk-habotai");
  expect_own_length("denim-14oz");
}

TEST(Tension, AKnitAndAWovenFabricResistAsTheirFiguresSay) {
  for (const char* name : {"single-jersey", "twill"}) {
    for (const bool warp : {true, false}) {
      const trials::TensionResult result = trials::tension(cloth(name), warp);
      EXPECT_NEAR(result.measured / result.known, 1, 0.03) << name << (warp ? ", warp" : ", weft");
    }
  }
}

TEST(Shear, AKnitAndAWovenFabricResistAsTheirFiguresSay) {
  for (const char* name : {"single-jersey", "twill"}) {
    const trials::ShearResult result = trials::shear(cloth(name));
    EXPECT_NEAR(result.measured / result.known, 1, 0.03) << name;
  }
}

TEST(Tube, IsStretchedByItsPressureAsItsFiguresSay) {
  for (const char* name : {"single-jersey", "twill"}) {
    for (const bool warp : {true, false}) {
      const trials::TubeResult result = trials::tube(cloth(name), warp);
      EXPECT_NEAR(result.measured / result.known, 1, 0.05) << name << (warp ? ", warp" : ", weft");
    }
  }
}

TEST(Slide, TellsTheCoefficientOfFriction) {
  for (const char* name : {"silk-habotai", "denim-14oz"}) {
    const trials::SlideResult result = trials::slide(cloth(name));
    EXPECT_NEAR(result.measured, result.known, 0.01) << name;
  }
}

/// A fan of triangles around the middle, its rim `radius_at(angle)` metres away.
template <typename RadiusAt>
trials::Shadow shadow_of_fan(RadiusAt radius_at) {
  constexpr int kSpokes = 720;
  std::vector<Vec3> x{{0, 0, 0}};
  std::vector<Tri> triangles;
  for (int i = 0; i < kSpokes; ++i) {
    const double a = 2 * kPi * i / kSpokes, r = radius_at(a);
    x.push_back({r * std::cos(a), -0.05, r * std::sin(a)});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % kSpokes});
  }
  return trials::shadow_of(x, triangles);
}

TEST(Shadow, OfAFlatPieceIsOneAndOfTheDiscAloneNothing) {
  EXPECT_NEAR(shadow_of_fan([](double) { return trials::kSpecimenRadius; }).coefficient, 1, 0.003);
  EXPECT_NEAR(shadow_of_fan([](double) { return 0.05; }).coefficient, 0, 0.003);
}

TEST(Shadow, CountsItsFolds) {
  const auto wavy = [](int folds) {
    return shadow_of_fan([=](double a) { return 0.12 + 0.015 * std::cos(folds * a); });
  };
  EXPECT_EQ(wavy(6).nodes, 6);
  EXPECT_EQ(wavy(7).nodes, 7);
  EXPECT_EQ(shadow_of_fan([](double) { return 0.12; }).nodes, 0);
  // Mean of r² over the turn is 0.12² + 0.015²/2.
  const double ring =
      trials::kSpecimenRadius * trials::kSpecimenRadius - trials::kDiscRadius * trials::kDiscRadius;
  const double known = (0.12 * 0.12 + 0.015 * 0.015 / 2 - trials::kDiscRadius * trials::kDiscRadius) / ring;
  EXPECT_NEAR(wavy(6).coefficient, known, 0.005);
}

TEST(CusickDrape, ALimpFabricFallsDeeperThanAStiffOneAndNothingGoesThrough) {
  const RunContext context;
  const Result<trials::CusickDrape> limp = trials::cusick_drape(cloth("single-jersey"), 0, 0.015, context);
  const Result<trials::CusickDrape> stiff = trials::cusick_drape(cloth("canvas"), 0, 0.015, context);
  ASSERT_TRUE(limp && stiff);
  EXPECT_LT(limp->shadow.coefficient + 0.2, stiff->shadow.coefficient);
  for (const trials::CusickDrape& drape : {*limp, *stiff}) {
    EXPECT_EQ(drape.worst.cloth_body, 0);
    EXPECT_EQ(drape.worst.cloth_cloth, 0);
  }
}

}  // namespace
}  // namespace toile
