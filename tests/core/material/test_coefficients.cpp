#include "core/material/coefficients.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Coefficients, OfBendingComeBackFromRealUnits) {
  for (const double mass : {0.02, 0.15, 0.5}) {
    for (const double b : {0.01, 0.2, 0.5, 1.0})
      EXPECT_NEAR(material::bending_coefficient(material::rigidity_of_bending(b, mass), mass), b, 1e-12);
  }
}

TEST(Coefficients, OfBendingAreTheBendingLengthOver50Mm) {
  EXPECT_NEAR(material::bending_coefficient(0.02 * 0.02 * 0.02 * 0.15 * 9.81, 0.15), 0.4, 1e-12);
  EXPECT_EQ(material::bending_coefficient(0, 0.15), 0) << "limp";
  EXPECT_EQ(material::bending_coefficient(1, 0.15), 1) << "nothing is stiffer than 1";
}

TEST(Coefficients, OfElasticityAreTheLargestStrain) {
  EXPECT_EQ(material::elasticity_of(2000, 0.04), 0.04);
  EXPECT_NEAR(material::elasticity_of(2000, 0), 0.245, 1e-12) << "at 490 N/m, without a limit";
  EXPECT_EQ(material::elasticity_of(10, 0), 1);
  const double e = 0.3;
  EXPECT_EQ(material::elasticity_of(material::stretch_of_elasticity(e), e), e);
}

}  // namespace
}  // namespace toile
