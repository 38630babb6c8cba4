#include "core/body/measure/tape.h"

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace toile {
namespace {

// An upright tube with `sides` sides around (x, z) = (centre, 0), from y = 0 to y = 2, radius r(y).
template <typename Radius>
void add_tube(geometry::TriangleMesh& mesh, double centre, int sides, Radius radius) {
  const auto base = static_cast<Index>(mesh.vertices.size());
  const int rings = 201;
  for (int j = 0; j < rings; ++j) {
    const double y = 0.01 * j;
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * kPi * i / sides;
      mesh.vertices.push_back({centre + radius(y) * std::cos(a), y, radius(y) * std::sin(a)});
    }
  }
  for (int j = 0; j + 1 < rings; ++j) {
    for (int i = 0; i < sides; ++i) {
      const Index a = base + j * sides + i, b = base + j * sides + (i + 1) % sides;
      mesh.triangles.push_back({a, a + sides, b});
      mesh.triangles.push_back({b, a + sides, b + sides});
    }
  }
}

TEST(Tape, MeasuresATube) {
  geometry::TriangleMesh mesh;
  add_tube(mesh, 0, 360, [](double) { return 0.12; });
  EXPECT_NEAR(measure::girth_at(mesh, 1.003), 2 * kPi * 0.12, 1e-4);
  EXPECT_NEAR(measure::girth_at(mesh, 1.0), 2 * kPi * 0.12, 1e-4) << "through a ring of vertices";
  EXPECT_EQ(measure::girth_at(mesh, 2.5), 0);
}

TEST(Tape, LeavesArmsOutAndTakesBothLegs) {
  geometry::TriangleMesh trunk_and_arms;
  for (double x : {0.0, 0.4, -0.4}) add_tube(trunk_and_arms, x, 90, [](double) { return 0.1; });
  EXPECT_NEAR(measure::girth_at(trunk_and_arms, 1), 2 * kPi * 0.1, 1e-3);
  geometry::TriangleMesh legs_and_hands;
  for (double x : {0.1, -0.1, 0.5, -0.5}) add_tube(legs_and_hands, x, 90, [](double) { return 0.05; });
  EXPECT_NEAR(measure::girth_at(legs_and_hands, 1), 2 * kPi * 0.05 + 4 * 0.1, 1e-3);
  EXPECT_NEAR(measure::half_breadth_at(legs_and_hands, 1), 0.15, 1e-3);
}

TEST(Tape, CutsOffWhatIsBroaderThanAllowed) {
  geometry::TriangleMesh mesh;
  add_tube(mesh, 0, 360, [](double) { return 0.2; });
  EXPECT_NEAR(measure::girth_at(mesh, 1, 0.3), 2 * kPi * 0.2, 1e-3);
  // Two arcs of 120° and two chords: a circle of 0.2 cut at ±0.2·cos 30°.
  EXPECT_NEAR(measure::girth_at(mesh, 1, 0.1 * std::sqrt(3.0)), 0.2 * (4 * kPi / 3) + 2 * 0.2, 1e-3);
}

TEST(Tape, FindsTheNarrowestAndTheWidestPlace) {
  geometry::TriangleMesh mesh;
  add_tube(mesh, 0, 180, [](double y) { return 0.1 + 0.1 * (y - 1) * (y - 1); });
  EXPECT_NEAR(measure::narrowest_girth(mesh, 0.8, 1.4).height, 1, 0.004);
  EXPECT_NEAR(measure::narrowest_girth(mesh, 0.8, 1.4).girth, 2 * kPi * 0.1, 1e-3);
  EXPECT_NEAR(measure::widest_girth(mesh, 0.8, 1.4).height, 1.4, 1e-9);
}

}  // namespace
}  // namespace toile
