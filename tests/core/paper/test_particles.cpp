// What the paper's method makes of a garment's mesh.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/units.h"
#include "core/material/coefficients.h"
#include "core/paper/paper_cloth.h"
#include "core/paper/particles.h"
#include "tests/core/paper/sheet.h"

namespace toile {
namespace {

TEST(PaperParticles, WeighTogetherWhatTheClothWeighs) {
  const auto particles = test::particles_of(test::sheet(6, 4), material::Fabric{});
  double mass = 0;
  for (const double w : particles.weight) mass += 1 / w;
  EXPECT_NEAR(mass, 0.2 * 0.06 * 0.04, 1e-12) << "kg/m² of a sheet of 6 by 4 cm";
}

TEST(PaperParticles, HaveALinkForEachEdgeWithItsFlatLength) {
  const auto particles = test::particles_of(test::sheet(3, 3), material::Fabric{});
  EXPECT_EQ(particles.links.size(), 3u * 4 * 2 + 9);
  for (const paper::Link& link : particles.links)
    EXPECT_TRUE(std::abs(link.rest - 0.01) < 1e-12 || std::abs(link.rest - 0.01 * std::sqrt(2)) < 1e-12);
}

TEST(PaperElasticity, GoesByTheLinksOwnDirection) {
  material::Fabric fabric;
  fabric.stretch_warp = 1000;
  fabric.stretch_weft = 200;
  EXPECT_NEAR(paper::elasticity_along(fabric, 0, 20), 0.02, 1e-15);
  EXPECT_NEAR(paper::elasticity_along(fabric, kPi / 2, 20), 0.1, 1e-12);
  EXPECT_NEAR(paper::elasticity_along(fabric, kPi / 4, 20), 0.02 * 0.1 / std::hypot(0.02, 0.1) * std::sqrt(2),
              1e-12);
  fabric.limit_weft = 0.05;
  EXPECT_NEAR(paper::elasticity_along(fabric, kPi / 2, 20), 0.05, 1e-12) << "its limit at most";
  EXPECT_NEAR(paper::elasticity_along(fabric, 0, material::kLargestLoad),
              material::elasticity_of(fabric.stretch_warp, 0), 1e-15)
      << "under the KES load it is the fabric's coefficient";
}

TEST(PaperBending, GoesByTheDirectionAcrossTheLink) {
  material::Fabric fabric;
  fabric.bend_warp = 8e-5;
  fabric.bend_weft = 1e-5;
  EXPECT_NEAR(paper::bending_across(fabric, 0), material::bending_coefficient(1e-5, fabric.areal_mass), 1e-12)
      << "about a link along the warp the weft is bent";
  EXPECT_NEAR(paper::bending_across(fabric, kPi / 2), material::bending_coefficient(8e-5, fabric.areal_mass),
              1e-12);
}

TEST(PaperFans, SumToAFullTurnWithinToHalfOnABorderAndToItsAngleAtACorner) {
  const sewing::GarmentMesh sheet = test::sheet(2, 2);
  const auto fans = test::particles_of(sheet, material::Fabric{}).fans;
  const auto flat_at = [&](Index v) { return fans.flat[fans.of[v]]; };
  EXPECT_NEAR(flat_at(4), 2 * kPi, 1e-6);
  EXPECT_NEAR(flat_at(1), kPi, 1e-6);
  EXPECT_NEAR(flat_at(0), kPi / 2, 1e-6);
}

TEST(PaperFans, AreOneWhereParticlesAreSewn) {
  sewing::GarmentMesh two = test::two_sheets(2, 2);
  const auto fans = test::particles_of(two, material::Fabric{}).fans;
  EXPECT_EQ(fans.of[5], fans.of[9 + 3]) << "the right border's middle and the left one's";
  EXPECT_NEAR(fans.flat[fans.of[5]], 2 * kPi, 1e-6) << "half a turn of each";
}

TEST(PaperFans, AreNotDeformedWhileFlatNorByAFoldAlongALine) {
  const sewing::GarmentMesh sheet = test::sheet(4, 4);
  const auto fans = test::particles_of(sheet, material::Fabric{}).fans;
  std::vector<Vec3> flat = test::lifted(sheet), folded = flat, pointed = flat;
  for (Vec3& p : folded)
    if (p.x > 0.02) p = {0.02, p.y, p.x - 0.02};
  const Index middle = 12;
  pointed[middle].z = 0.005;
  for (std::size_t f = 0; f < fans.flat.size(); ++f) {
    EXPECT_NEAR(paper::deformation(fans, static_cast<Index>(f), flat), 0, 1e-7);
    EXPECT_NEAR(paper::deformation(fans, static_cast<Index>(f), folded), 0, 1e-7) << "the method's limit";
  }
  EXPECT_GT(paper::deformation(fans, fans.of[middle], pointed), 0.01);
}

TEST(PaperFans, AreNotFeltWhereBendingIsLimp) {
  material::Fabric limp;
  limp.bend_warp = limp.bend_weft = 0;
  const sewing::GarmentMesh sheet = test::sheet(4, 4);
  const auto fans = test::particles_of(sheet, limp).fans;
  std::vector<Vec3> pointed = test::lifted(sheet);
  pointed[12].z = 0.005;
  EXPECT_EQ(paper::deformation(fans, fans.of[12], pointed), 0);
}

}  // namespace
}  // namespace toile
