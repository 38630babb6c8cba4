#include "core/body/mannequin.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "core/base/hash.h"
#include "core/base/units.h"
#include "core/body/tape.h"
#include "tests/core/body/mesh_checks.h"

namespace toile {
namespace {

void expect_proper(const TriangleMesh& mesh) {
  EXPECT_EQ(open_edges(mesh), 0);
  EXPECT_TRUE(fans_are_whole(mesh));
  EXPECT_EQ(self_crossings(mesh), 0);
  EXPECT_GT(volume(mesh), 0);
  // Euler's number of one closed surface without handles.
  EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2, 2);
}

TEST(Mannequin, IsClosedManifoldOutwardAndDoesNotCrossItself) {
  const Result<TriangleMesh> mesh = make_mannequin({});
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  expect_proper(*mesh);
  EXPECT_EQ(mesh->triangles.size(), 3300u);
  EXPECT_GT(degrees_from_radians(least_angle(*mesh)), 22);
  EXPECT_GT(volume(*mesh), 0.045);  // m³: a person of 1.70 m weighs 50 to 75 kg
  EXPECT_LT(volume(*mesh), 0.075);
}

TEST(Mannequin, StandsOnTheFloorAsTallAsAsked) {
  const Result<TriangleMesh> mesh =
      make_mannequin({.height = 1.62, .bust = 0.85, .waist = 0.66, .hip = 0.92});
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  double low = 1e9, high = -1e9, left = 0, right = 0, toes = 0, heels = 0;
  for (const Vec3& p : mesh->vertices) {
    low = std::min(low, p.y), high = std::max(high, p.y);
    left = std::max(left, p.x), right = std::max(right, -p.x);
    if (p.y < 0.05) toes = std::max(toes, p.z), heels = std::max(heels, -p.z);
  }
  EXPECT_NEAR(low, 0, 1e-12);
  EXPECT_NEAR(high, 1.62, 1e-9);
  EXPECT_NEAR(left, right, 0.01);
  EXPECT_GT(toes, heels) << "the feet point along +z";
}

TEST(Mannequin, MeetsTheGirthsThatWereAsked) {
  const MannequinSettings sizes[] = {
      {.height = 1.70, .bust = 0.90, .waist = 0.72, .hip = 0.96},
      {.height = 1.55, .bust = 0.76, .waist = 0.56, .hip = 0.80},
      {.height = 1.80, .bust = 1.10, .waist = 0.95, .hip = 1.15},
      {.height = 1.68, .bust = 0.88, .waist = 0.68, .hip = 0.94, .arm_angle = 0.62}};
  for (const MannequinSettings& s : sizes) {
    const Result<TriangleMesh> mesh = make_mannequin(s);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    const TrunkGirths g = trunk_girths(*mesh);
    EXPECT_NEAR(g.bust.girth, s.bust, 0.005);
    EXPECT_NEAR(g.waist.girth, s.waist, 0.005);
    EXPECT_NEAR(g.hip.girth, s.hip, 0.005);
    expect_proper(*mesh);
  }
}

TEST(Mannequin, HasAsManyTrianglesAsAsked) {
  for (Index count : {1000, 3301, 8000}) {
    MannequinSettings s;
    s.triangle_count = count;
    const Result<TriangleMesh> mesh = make_mannequin(s);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_NEAR(static_cast<double>(mesh->triangles.size()), count, 1);
    expect_proper(*mesh);
  }
}

TEST(Mannequin, GivesTheSameBytesEachTime) {
  const Result<TriangleMesh> a = make_mannequin({}), b = make_mannequin({});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->triangles, b->triangles);
  EXPECT_EQ(hash_of(a->vertices), hash_of(b->vertices));
}

TEST(Mannequin, RefusesMeasuresThatNoBodyHas) {
  for (double waist : {0.0, 5.0, -0.7, std::numeric_limits<double>::quiet_NaN()}) {
    const Result<TriangleMesh> mesh = make_mannequin({.waist = waist});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, "mannequin.setting");
    EXPECT_EQ(mesh.error().where, "waist");
  }
  EXPECT_EQ(make_mannequin({.triangle_count = 10}).error().where, "triangle_count");
  EXPECT_EQ(make_mannequin({.arm_angle = 0}).error().where, "arm_angle");
}

}  // namespace
}  // namespace toile
