// Steps of the paper's method: cloth that hangs, is sewn, is held, and meets bodies and cloth.

#include <gtest/gtest.h>

#include "core/paper/paper_cloth.h"
#include "tests/core/paper/sheet.h"

namespace toile {
namespace {

constexpr paper::PaperSettings kSettings{.time_step = 1.0 / 250, .damping = 0.05, .passes = 15};

paper::PaperCloth cloth_of(const sewing::GarmentMesh& mesh, std::vector<Vec3> x, paper::Solids solids = {},
                           const material::Fabric& fabric = {},
                           const paper::PaperSettings& settings = kSettings) {
  return {test::particles_of(mesh, fabric, settings.load), std::move(solids), settings, std::move(x)};
}

void steps(paper::PaperCloth& cloth, int count, const paper::StepForces& forces) {
  for (int k = 0; k < count; ++k) cloth.step(forces);
}

TEST(PaperCloth, HangsFromItsUpperCornersAndKeepsToItsStrain) {
  const sewing::GarmentMesh mesh = test::sheet(8, 8);
  auto cloth = cloth_of(mesh, test::lifted(mesh));
  const Index left = 8 * 9, right = 8 * 9 + 8;
  cloth.set_held({{left, false, cloth.positions()[left]}, {right, false, cloth.positions()[right]}});
  steps(cloth, 1000, {9.81, 1});
  const std::vector<Vec3>& x = cloth.positions();
  EXPECT_EQ(x[left], (Vec3{0, 0.08, 0}));
  EXPECT_LT(x[8 * 9 + 4].y, 0.0799) << "the border between them sags";
  double stretched = 0;
  for (const paper::Link& link : cloth.particles().links)
    stretched += std::max(0.0, length(x[link.a] - x[link.b]) / link.rest - 1);
  EXPECT_LT(stretched / static_cast<double>(cloth.particles().links.size()), 0.03)
      << "in the mean; at the corners all of it hangs on two links";
}

/// m; how far a sheet's particles are apart in the mean from another's.
double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += length(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

/// Figure 8's trapezoid, held by its two upper corners a little nearer to each other than it is wide.
std::vector<Vec3> hung_trapezoid(const material::Fabric& fabric, double load) {
  sewing::GarmentMesh mesh = test::sheet(10, 10);
  for (Vec2& p : mesh.rest) p.x = 0.05 + (p.x - 0.05) * (1.5 - 5 * p.y);
  paper::PaperSettings settings = kSettings;
  settings.load = load;
  auto cloth = cloth_of(mesh, test::lifted(mesh), {}, fabric, settings);
  const Index left = 10 * 11, right = 10 * 11 + 10;
  const Vec3 a = cloth.positions()[left], b = cloth.positions()[right];
  cloth.set_held({{left, false, a + (b - a) * 0.1 + Vec3{0, 0, 0.001}}, {right, false, b - (b - a) * 0.1}});
  steps(cloth, 300, {9.81, 1});
  return cloth.positions();
}

TEST(PaperCloth, OneTrapezoidHangsDifferentlyForDifferentProperties) {
  material::Fabric limp, stiff;
  limp.bend_warp = limp.bend_weft = 0;
  stiff.bend_warp = stiff.bend_weft = 1e-3;
  const auto of_limp = hung_trapezoid(limp, 2), of_stiff = hung_trapezoid(stiff, 2);
  const auto of_elastic = hung_trapezoid(limp, 490);
  EXPECT_GT(difference(of_limp, of_stiff), 1e-5);
  EXPECT_GT(difference(of_limp, of_elastic), 1e-3);
  double lowest_limp = 1, lowest_elastic = 1;
  for (const Vec3& p : of_limp) lowest_limp = std::min(lowest_limp, p.y);
  for (const Vec3& p : of_elastic) lowest_elastic = std::min(lowest_elastic, p.y);
  EXPECT_LT(lowest_elastic, lowest_limp - 0.005) << "what may stretch by a quarter does";
}

TEST(PaperCloth, IsSewnAtTheMidpointOfItsPairs) {
  const sewing::GarmentMesh mesh = test::two_sheets(3, 3);
  std::vector<Vec3> x = test::lifted(mesh);
  for (std::size_t i = 16; i < x.size(); ++i) x[i].x += 0.13;
  auto cloth = cloth_of(mesh, x);
  for (int k = 0; k < 50; ++k) cloth.step({0, 1.0 / (50 - k)});
  double middle = 0;
  for (const auto& [a, b] : mesh.sewn) {
    EXPECT_EQ(cloth.positions()[a], cloth.positions()[b]);
    middle += cloth.positions()[a].x / static_cast<double>(mesh.sewn.size());
  }
  EXPECT_NEAR(middle, 0.08, 1e-3) << "both sides came half of the way";
}

TEST(PaperCloth, IsHeldInHeightAloneWhereThatIsAsked) {
  const sewing::GarmentMesh mesh = test::sheet(2, 2);
  auto cloth = cloth_of(mesh, test::lifted(mesh));
  cloth.set_held({{7, true, {0, 0.05, 0}}});
  steps(cloth, 100, {9.81, 1});
  EXPECT_EQ(cloth.positions()[7].y, 0.05);
}

TEST(PaperCloth, IsLedToItsGoalByAPointBetweenItsParticles) {
  const sewing::GarmentMesh mesh = test::sheet(2, 2);
  auto cloth = cloth_of(mesh, test::lifted(mesh));
  const std::vector<Vec3> goal{{0.1, 0.2, 0.3}};
  const sewing::ClothPoint point{{0, 1, 4}, {0.2, 0.3, 0.5}};
  cloth.set_led({{point, &goal}});
  for (int k = 0; k < 100; ++k) cloth.step({0, 1.0 / (100 - k)});
  steps(cloth, 100, {0, 1});
  EXPECT_LT(length(sewing::position_of(point, cloth.positions()) - goal[0]), 1e-3);
}

/// A box's top, 10 by 10 cm, its middle at the origin, and its sides.
paper::Solids table(double clearance) {
  const std::vector<Vec3> v{{-0.05, -0.1, -0.05}, {0.05, -0.1, -0.05}, {0.05, -0.1, 0.05},
                            {-0.05, -0.1, 0.05},  {-0.05, 0, -0.05},   {0.05, 0, -0.05},
                            {0.05, 0, 0.05},      {-0.05, 0, 0.05}};
  const std::vector<Tri> t{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {0, 5, 1}, {0, 4, 5},
                           {1, 6, 2}, {1, 5, 6}, {2, 7, 3}, {2, 6, 7}, {3, 4, 0}, {3, 7, 4}};
  paper::Solids solids;
  paper::add_solid(v, t, clearance, solids);
  return solids;
}

std::vector<Vec3> above_table(const sewing::GarmentMesh& mesh, double height) {
  const Vec2 middle = mesh.rest.back() * 0.5;
  std::vector<Vec3> x;
  for (const Vec2 p : mesh.rest) x.push_back({p.x - middle.x, height, middle.y - p.y});
  return x;
}

TEST(PaperCloth, NoParticleEntersABodyHoweverFastItFalls) {
  const sewing::GarmentMesh mesh = test::sheet(20, 20);
  auto cloth = cloth_of(mesh, above_table(mesh, 0.3), table(2e-3));
  for (int k = 0; k < 500; ++k) {
    cloth.step({9.81, 1});
    for (const Vec3& p : cloth.positions()) {
      const bool within = std::abs(p.x) < 0.05 && std::abs(p.z) < 0.05 && p.y < 0 && p.y > -0.1;
      ASSERT_FALSE(within) << k;
    }
  }
  EXPECT_NEAR(cloth.positions()[10 * 21 + 10].y, 2e-3, 1e-3) << "it lies on the table";
}

TEST(PaperCloth, WhatBeginsNearerThanItLiesComesOut) {
  const sewing::GarmentMesh mesh = test::sheet(4, 4);
  auto cloth = cloth_of(mesh, above_table(mesh, 0.5e-3), table(3e-3));
  cloth.come_out();
  for (const Vec3& p : cloth.positions()) EXPECT_GE(p.y, 3e-3);
  steps(cloth, 50, {9.81, 1});
  for (const Vec3& p : cloth.positions()) EXPECT_GE(p.y, 3e-3 - 1e-9);
}

TEST(PaperCloth, LeavesASurfaceByItsReflection) {
  paper::PaperSettings settings = kSettings;
  settings.damping = 0;
  settings.reflection = 0.9;
  const sewing::GarmentMesh mesh = test::sheet(1, 1);
  const auto highest_after = [&](double reflection) {
    settings.reflection = reflection;
    auto cloth = cloth_of(mesh, above_table(mesh, 0.05), table(0), {}, settings);
    steps(cloth, 26, {9.81, 1});  // it strikes after about 0.1 s
    double highest = 0;
    for (int k = 0; k < 26; ++k) {
      cloth.step({9.81, 1});
      highest = std::max(highest, cloth.positions()[0].y);
    }
    return highest;
  };
  EXPECT_LT(highest_after(0), 1e-3);
  EXPECT_GT(highest_after(1), 0.005);
}

TEST(PaperCloth, ParticlesDoNotPassThroughOtherPieces) {
  // A small piece falls on a large one that is held by its border.
  sewing::GarmentMesh mesh = test::two_sheets(12, 12);
  mesh.sewn.clear();
  for (Index i = 0; i < mesh.vertex_count(); ++i) mesh.weld[i] = i;
  std::vector<Vec3> x;
  std::vector<paper::Held> held;
  for (Index i = 0; i < mesh.vertex_count(); ++i) {
    const bool upper = i >= 169;
    const Vec2 p = mesh.rest[i];
    x.push_back(upper ? Vec3{0.03 + p.x / 2, 0.05, 0.0313 + p.y / 2} : Vec3{p.x, 0, p.y});
    const bool border = p.x < 1e-9 || p.y < 1e-9 || p.x > 0.1199 || p.y > 0.1199;
    if (!upper && border) held.push_back({i, false, x.back()});
  }
  auto cloth = cloth_of(mesh, x);
  cloth.set_held(held);
  steps(cloth, 150, {9.81, 1});
  int below = 0;
  for (Index i = 169; i < mesh.vertex_count(); ++i) below += cloth.positions()[i].y < -0.03;
  EXPECT_EQ(below, 0) << "the lower one hangs through by less";
}

TEST(PaperCloth, GoesOnFromItsStateInTheSameBytes) {
  const sewing::GarmentMesh mesh = test::sheet(10, 10);
  auto whole = cloth_of(mesh, above_table(mesh, 0.02), table(2e-3));
  steps(whole, 60, {9.81, 1});
  auto resumed = cloth_of(mesh, above_table(mesh, 0.02), table(2e-3));
  resumed.restore(whole.state());
  steps(whole, 60, {9.81, 1});
  steps(resumed, 60, {9.81, 1});
  EXPECT_EQ(whole.positions(), resumed.positions());
}

}  // namespace
}  // namespace toile
