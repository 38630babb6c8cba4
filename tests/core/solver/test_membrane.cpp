// The membrane where it is not plain: soft ways beside hard ones, limits, cloth that is pushed together.

#include <gtest/gtest.h>

#include "core/solver/lanes/passes.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

/// A strip of `height` metres hung by its upper edge, the warp upright, at rest shape.
struct Hung {
  test::Strip strip;
  solver::ClothSolver solver;
};

Hung hang(const material::Fabric& fabric, double width, double height, double h, double rate) {
  test::Strip strip = test::make_strip({0, 1e3 * width}, 1e3 * height, h, {0, 1}, fabric);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : strip.rest) {
    x.push_back({p.x, p.y - height, 0});
    if (p.y > height - 1e-4) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(strip.model, x, {}, 1 / rate);
  solver.set_holds(held);
  return {std::move(strip), std::move(solver)};
}

void run(solver::ClothSolver& solver, double seconds) {
  solver::StepForces forces;
  forces.damping = 20;
  for (int i = 0; i < seconds / solver.time_step(); ++i) solver.step(forces);
}

double largest_speed(const solver::ClothSolver& solver) {
  double most = 0;
  for (const Vec3& v : solver.velocities()) most = std::max(most, length(v));
  return most;
}

/// Least and most of one strain (0 weft, 1 warp, 2 shear) over the triangles.
struct Extent {
  double least = 1e9, most = -1e9;
};
Extent strains(const Hung& hung, int which) {
  Extent extent;
  for (const solver::constraints::MembraneTriangle& t :
       solver::constraints::make_membrane(hung.strip.model)) {
    const Vec3 strain = solver::constraints::membrane_strain(t, hung.solver.positions());
    const double s = which == 0 ? strain.x : which == 1 ? strain.y : strain.z;
    extent = {std::min(extent.least, s), std::max(extent.most, s)};
  }
  return extent;
}

TEST(Membrane, HangsSmoothHoweverMuchSofterItsShearIs) {
  material::Fabric fabric;  // of a real cotton but for the least shear that was measured
  fabric.stretch_coupling = 10;
  fabric.stretch_shear = 3;
  Hung hung = hang(fabric, 0.1, 0.15, 0.01, 3000);
  run(hung.solver, 0.5);
  EXPECT_LT(largest_speed(hung.solver), 0.002);
  EXPECT_LT(strains(hung, 1).most, 0.01);
  EXPECT_GT(strains(hung, 1).least, -0.01);
}

TEST(Membrane, HangsSmoothHoweverMuchSofterItsWeftIs) {
  material::Fabric fabric;
  fabric.stretch_weft = 5;
  fabric.stretch_coupling = 0;
  Hung hung = hang(fabric, 0.1, 0.15, 0.01, 3000);
  run(hung.solver, 0.5);
  EXPECT_LT(largest_speed(hung.solver), 0.002);
  EXPECT_LT(strains(hung, 1).most, 0.01);
  EXPECT_GT(strains(hung, 1).least, -0.01);
}

material::Fabric heavy_knit() {
  material::Fabric fabric;
  fabric.areal_mass = 4;
  fabric.stretch_warp = 40;
  fabric.stretch_weft = 25;
  fabric.stretch_coupling = 5;
  fabric.stretch_shear = 30;
  return fabric;
}

TEST(MembraneLimit, AStripLoadedBeyondItStretchesByHardlyMore) {
  material::Fabric fabric = heavy_knit();
  Hung without = hang(fabric, 0.05, 0.3, 0.01, 3000);
  run(without.solver, 0.6);
  EXPECT_GT(strains(without, 1).most, 0.25) << "the load asks for more than the limit";

  fabric.limit_warp = 0.10;
  Hung limited = hang(fabric, 0.05, 0.3, 0.01, 3000);
  run(limited.solver, 0.6);
  EXPECT_GT(strains(limited, 1).most, 0.099);
  EXPECT_LT(strains(limited, 1).most, 0.11);
  EXPECT_LT(largest_speed(limited.solver), 0.005) << "it rests";
}

/// A sheet torn out to `times` its size, let go without gravity: the fastest vertex while it springs back,
/// and what strain is left.
struct SprungBack {
  double fastest = 0, strain = 0;
};
SprungBack spring_back(Vec2 weft, Vec2 warp) {
  material::Fabric fabric;
  fabric.limit_warp = fabric.limit_weft = 0.04;
  fabric.limit_shear = 0.1;
  test::Strip strip = test::make_strip({0, 60}, 60, 0.01, {0, 1}, fabric);
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) {
    const Vec2 q = weft * (p.x - 0.03) + warp * (p.y - 0.03);
    x.push_back({q.x, q.y, 1e-4 * std::sin(300 * p.x)});
  }
  Hung sheet{strip, solver::ClothSolver(strip.model, x, {}, 1.0 / 3000)};
  solver::StepForces forces;
  forces.gravity = 0;
  forces.damping = 20;
  SprungBack result;
  for (int i = 0; i < 3000; ++i) {
    sheet.solver.step(forces);
    result.fastest = std::max(result.fastest, largest_speed(sheet.solver));
  }
  for (const int way : {0, 1, 2}) {
    const Extent left = strains(sheet, way);
    result.strain = std::max({result.strain, left.most, -left.least});
  }
  return result;
}

TEST(MembraneLimit, ClothTornOutFarBeyondItComesBack) {
  const std::pair<Vec2, Vec2> tears[] = {{{3, 0}, {0, 3}},     {{8, 0}, {0, 8}},      {{8, 0}, {0, 1}},
                                         {{3, 0}, {2.9, 0.3}}, {{4, 0}, {3.9, 0.05}}, {{1.5, 0}, {1.4, 0.2}}};
  for (const auto& [weft, warp] : tears) {
    const SprungBack back = spring_back(weft, warp);
    EXPECT_LT(back.fastest, 12) << weft.x << ' ' << warp.x
                                << ": no corner moves by more than its triangle's height";
    EXPECT_LT(back.strain, 1e-4) << weft.x << ' ' << warp.x;
  }
}

/// A sheet with its two ends held apart at `times` its length for three seconds. Cloth may give way where x
/// (m) is beyond `from`.
struct HeldApart {
  std::vector<Vec3> preloads, middles;  ///< of its triangles
};

HeldApart hold_apart(double times, double from) {
  material::Fabric fabric;
  fabric.limit_warp = fabric.limit_weft = 0.06;
  fabric.limit_shear = 0.1;
  const test::Strip strip = test::make_strip({0, 120}, 60, 0.01, {0, 1}, fabric);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : strip.rest) {
    x.push_back({p.x, times * p.y, 0});
    if (p.y < 1e-4 || p.y > 0.06 - 1e-4) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(strip.model, x, {}, 1.0 / 3000);
  solver.set_holds(held);
  solver::StepForces forces;
  forces.damping = 20;
  for (int i = 0; i < 9000; ++i) {
    solver.step(forces);
    if (i % 64 == 0) solver.give_way([&](Vec3 p) { return p.x > from; });
  }
  HeldApart apart{solver.preloads(), {}};
  for (const Tri& t : strip.model.triangles) {
    Vec3 sum;
    for (const Index v : t) sum += solver.positions()[v];
    apart.middles.push_back(sum * (1.0 / 3));
  }
  return apart;
}

TEST(MembraneLimit, ClothThatIsHeldFarBeyondItGivesWayToALittleBeyond) {
  for (const double times : {1.3, 1.8}) {
    double sum = 0;
    const HeldApart apart = hold_apart(times, -1);
    for (const Vec3& p : apart.preloads) sum += p.y;
    const double longer = -sum / static_cast<double>(apart.preloads.size());
    EXPECT_GT(longer, times - 1 - 0.09) << times;
    EXPECT_LT(longer, times - 1) << times;
  }
}

TEST(MembraneLimit, ClothGivesWayWhereItMayOnlyAndNotBelow) {
  const HeldApart apart = hold_apart(1.8, 0.06), little = hold_apart(1.02, -1), none = hold_apart(1.02, 1);
  int gave = 0;
  for (std::size_t i = 0; i < apart.middles.size(); ++i) {
    const double given = -apart.preloads[i].y;
    if (apart.middles[i].x > 0.07) gave += given > 0.6;
    if (apart.middles[i].x < 0.05) {
      EXPECT_LT(given, 0.6) << i << ": what is learnt is less";
    }
  }
  EXPECT_GT(gave, 30);
  EXPECT_TRUE(little.preloads == none.preloads);
}

TEST(MembraneLimit, DoesNothingBelowItself) {
  material::Fabric fabric = heavy_knit();
  Hung without = hang(fabric, 0.05, 0.1, 0.01, 3000);
  run(without.solver, 0.3);
  fabric.limit_warp = 0.5;
  fabric.limit_weft = 0.5;
  fabric.limit_shear = 0.5;
  Hung limited = hang(fabric, 0.05, 0.1, 0.01, 3000);
  run(limited.solver, 0.3);
  for (std::size_t i = 0; i < without.solver.positions().size(); ++i)
    EXPECT_EQ(length(without.solver.positions()[i] - limited.solver.positions()[i]), 0);
}

/// How far one pass moves a triangle's corners back along n (weft, warp; of length 1), when it has been drawn
/// out (or pushed together) by `strain` along n. It is so soft in so short a step that this is its force.
double answer_to(double strain, double limit, Vec2 n = {1, 0}) {
  material::Fabric fabric;
  fabric.stretch_coupling = 0;
  fabric.limit_weft = limit;
  solver::ClothModel model;
  model.fabrics = {fabric};
  model.triangles = {{0, 1, 2}};
  model.rest = {{Vec2{0, 0}, Vec2{0.01, 0}, Vec2{0, 0.01}}};
  model.fabric_of_triangle = {0};
  model.mass.assign(3, 1e-5);
  solver::lanes::MembranePass membrane(model);
  membrane.prepare(std::vector<double>(3, 1e5), 1e-6);
  std::vector<Vec3> x;
  for (const Vec2& p : model.rest[0]) {
    const Vec2 q = p + n * (strain * dot(n, p));
    x.push_back({q.x, q.y, 0});
  }
  const std::vector<Vec3> before = x;
  test::sweep(membrane, x);
  const Vec3 moved = (before[1] - x[1]) * n.x + (before[2] - x[2]) * n.y;
  return moved.x * n.x + moved.y * n.y;
}

/// Stiffness along n between two strains.
double stiffness(double from, double to, Vec2 n) {
  return (answer_to(to, 0, n) - answer_to(from, 0, n)) / (to - from);
}

TEST(Membrane, BuckledItIsSoftAlongEitherThreadAndOnTheBias) {
  const auto left = [](Vec2 n) { return stiffness(-0.003, -0.002, n) / stiffness(0, 0.001, n); };
  EXPECT_NEAR(left({1, 0}), 0.05, 5e-4);
  EXPECT_NEAR(left({0, 1}), 0.05, 5e-4);
  const double r = std::sqrt(0.5);
  for (const Vec2 bias : {Vec2{r, r}, Vec2{r, -r}}) {  // where both threads have buckled as well
    EXPECT_LT(left(bias), 0.05);
    EXPECT_GT(left(bias), 0.04);
  }
}

TEST(Membrane, BucklesUnderEulersLoadOfItsOwnSize) {
  const material::Fabric
      fabric;  // as in answer_to, of triangles of 0.5 cm²: as wide as equilateral ones of this edge
  const double edge2 = 4 * 0.5e-4 / std::sqrt(3.0), pi = std::acos(-1.0);
  const double strain = pi * pi * fabric.bend_warp / edge2 / fabric.stretch_weft;
  EXPECT_NEAR(answer_to(-0.9 * strain, 0) / answer_to(0.9 * strain, 0), -1, 0.01) << "stiff before";
  EXPECT_LT(stiffness(-1.2 * strain, -1.1 * strain, {1, 0}), 0.06 * stiffness(0, 0.9 * strain, {1, 0}));
}

TEST(Membrane, BucklingIsNoJumpOfTheForce) {
  for (double s = 0; s < 0.01; s += 1e-5) {
    EXPECT_LE(answer_to(-s, 0) - answer_to(-s - 1e-5, 0), 1.01 * answer_to(1e-5, 0)) << s;
  }
}

TEST(MembraneLimit, IsNoJumpOfTheForce) {
  const double below = answer_to(0.02 - 1e-7, 0.02), above = answer_to(0.02 + 1e-7, 0.02);
  EXPECT_NEAR(above / below, 1, 1e-3);
  EXPECT_GT(answer_to(0.03, 0.02), 20 * below) << "and much stiffer from there";
}

}  // namespace
}  // namespace toile
