#include "core/analysis/strain.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// One triangle whose warp runs along `grain`, stretched to x' = 1.1 x, y' = 0.98 y + 0.05 x in the plane.
analysis::GarmentStrain strain_of_known_map(Vec2 grain) {
  drape::DrapeInput input;
  input.pattern.panels.resize(1);
  input.pattern.panels[0].grain = grain;
  drape::DrapeResult result;
  result.garment.rest = {{0, 0}, {0.01, 0.002}, {0.001, 0.012}};
  result.garment.triangles = {{0, 1, 2}};
  result.garment.panel_of_triangle = {0};
  for (const Vec2& p : result.garment.rest)
    result.positions.push_back({1.1 * p.x, 0.98 * p.y + 0.05 * p.x, 0.3});
  return analysis::garment_strain(input, result);
}

TEST(Strain, WarpWeftAndShearComeFromTheThreads) {
  const analysis::GarmentStrain s = strain_of_known_map({0, 1});
  EXPECT_NEAR(s.warp[0], -0.02, 1e-9);
  EXPECT_NEAR(s.weft[0], std::hypot(1.1, 0.05) - 1, 1e-9);
  EXPECT_NEAR(s.shear[0], 0.05 / std::hypot(1.1, 0.05), 1e-9);
}

TEST(Strain, TurningTheGrainSwapsWarpAndWeft) {
  const analysis::GarmentStrain s = strain_of_known_map({1, 0});
  EXPECT_NEAR(s.weft[0], -0.02, 1e-9);
  EXPECT_NEAR(s.warp[0], std::hypot(1.1, 0.05) - 1, 1e-9);
}

TEST(Strain, StretchAndSqueezeAreToldApart) {
  std::vector<double> values(100, 0);
  values[3] = 0.04;
  values[4] = 0.02;
  values[5] = -0.2;
  values[6] = -0.1;
  const analysis::StretchFigures f = analysis::stretch_figures_of(values);
  EXPECT_EQ(f.max, 0.2) << "of magnitudes";
  EXPECT_EQ(f.tension.max, 0.04);
  EXPECT_NEAR(f.tension.mean, 0.06 / 100, 1e-12);
  EXPECT_EQ(f.compression.max, 0.2);
  EXPECT_NEAR(f.compression.mean, 0.3 / 100, 1e-12);
  EXPECT_EQ(analysis::stretch_figures_of({0.01, -0.5}).tension.p99, 0.01)
      << "squeezed cloth is not overstretched";
}

TEST(Strain, FiguresAreOfMagnitudes) {
  std::vector<double> values(100, -0.01);
  values[0] = 0.5;
  const analysis::StrainFigures f = analysis::figures_of(values);
  EXPECT_NEAR(f.mean, (99 * 0.01 + 0.5) / 100, 1e-12);
  EXPECT_EQ(f.max, 0.5);
  EXPECT_EQ(f.p99, 0.5);
  EXPECT_EQ(analysis::figures_of({}).max, 0);
}

}  // namespace
}  // namespace toile
