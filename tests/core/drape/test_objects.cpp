// Cloth over several objects at once.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

/// A closed box.
body::Body box(const std::string& id, Vec3 low, Vec3 high) {
  body::Body body;
  body.id = id;
  for (int i = 0; i < 8; ++i) {
    body.mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  body.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                         {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return body;
}

/// A ball in rings.
body::Body ball(const std::string& id, Vec3 middle, double radius) {
  constexpr int kRings = 12, kSides = 20;
  constexpr double kPi = 3.14159265358979;
  body::Body body;
  body.id = id;
  auto& x = body.mesh.vertices;
  x = {middle + Vec3{0, -radius, 0}, middle + Vec3{0, radius, 0}};
  for (int r = 1; r < kRings; ++r) {
    const double y = -std::cos(kPi * r / kRings), wide = std::sin(kPi * r / kRings);
    for (int s = 0; s < kSides; ++s) {
      const double a = 2 * kPi * s / kSides;
      x.push_back(middle + Vec3{wide * std::sin(a), y, wide * std::cos(a)} * radius);
    }
  }
  const auto at = [](int r, int s) { return static_cast<Index>(2 + (r - 1) * kSides + s % kSides); };
  for (int s = 0; s < kSides; ++s) {
    body.mesh.triangles.push_back({0, at(1, s + 1), at(1, s)});
    body.mesh.triangles.push_back({1, at(kRings - 1, s), at(kRings - 1, s + 1)});
    for (int r = 1; r + 1 < kRings; ++r) {
      body.mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
      body.mesh.triangles.push_back({at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
    }
  }
  return body;
}

/// A square of cloth over a table with a ball on it, which it touches first.
drape::DrapeInput table_and_ball() {
  drape::DrapeInput input = test::tablecloth();
  input.pattern.panels = {test::rectangle("sheet", 440, 440)};
  std::get<sewing::RigidPlacement>(input.placements[0]).translation = {0, 0.40, 0.22};
  input.bodies = {box("table", {-0.12, 0.20, -0.12}, {0.12, 0.22, 0.12}),
                  ball("ball", {0.03, 0.302, 0}, 0.08)};
  input.bodies[0].friction = 0.1;
  input.bodies[1].friction = 0.6;
  input.bodies[1].skin_offset = 3e-3;
  return input;
}

double least_distance(const std::vector<Vec3>& x, Vec3 middle) {
  double least = 1;
  for (const Vec3& p : x) least = std::min(least, length(p - middle));
  return least;
}

TEST(Objects, ASquareHangsOverATableAndABallAtOnce) {
  const drape::DrapeInput input = table_and_ball();
  const Result<drape::DrapeResult> result = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_TRUE(result->settled()) << drape::to_string(result->stop_reason);
  EXPECT_EQ(result->worst.cloth_body, 0);
  EXPECT_EQ(result->worst.cloth_cloth, 0);
  double lowest = 1, on_table = 0;
  for (const Vec3& p : result->positions) {
    lowest = std::min(lowest, p.y);
    on_table += std::abs(p.y - 0.221) < 2e-3 && std::abs(p.x) < 0.12 && std::abs(p.z) < 0.12;
  }
  EXPECT_LT(lowest, 0.20) << "the corners hang below the table's top";
  EXPECT_GT(on_table, 3) << "some of it lies on the table";
  EXPECT_GT(least_distance(result->positions, {0.03, 0.302, 0}), 0.08)
      << "a skin of 3 mm, faces within the ball";
}

TEST(Objects, EachKeepsItsOwnSkinOffset) {
  drape::DrapeInput input = table_and_ball();
  const auto top = [&](double offset) {
    input.bodies[1].skin_offset = offset;
    const Result<drape::DrapeResult> result = drape::drape(input, {}, nullptr);
    double high = 0;
    for (const Vec3& p : result->positions) high = std::max(high, p.y);
    return high;
  };
  const double near = top(1e-3), far = top(6e-3);
  EXPECT_NEAR(far - near, 4e-3, 2.5e-3) << "lifted to three quarters of the offset or more";
}

TEST(Objects, ThrowTheClothBackAsFarAsTheirRestitutionSays) {
  const auto rebound = [](double restitution) {
    drape::DrapeInput input = test::tablecloth();
    input.bodies = {box("floor", {-1, -0.1, -1}, {1, 0, 1})};
    input.bodies[0].restitution = restitution;
    std::get<sewing::RigidPlacement>(input.placements[0]).translation = {0, 0.08, 0.12};
    input.settings.mode = drape::DrapeMode::kDynamic;
    auto run = drape::DrapeRun::start(input, {}, nullptr);
    double high = 0;
    bool struck = false;
    for (int i = 0; i < 550; ++i) {  // 0.275 s
      (*run)->advance(1, {});
      const std::vector<Vec3> x = (*run)->session().positions();
      double mean = 0;
      for (const Vec3& p : x) mean += p.y / static_cast<double>(x.size());
      struck = struck || mean < 3e-3;
      if (struck) high = std::max(high, mean);
    }
    EXPECT_EQ((*run)->conclude().worst.cloth_body, 0);
    return high;
  };
  const double still = rebound(0), half = rebound(0.5), full = rebound(1);
  EXPECT_LT(still, 5e-3);
  EXPECT_NEAR(half, 0.25 * 0.08, 3e-3);
  EXPECT_NEAR(full, 0.08, 5e-3);
}

}  // namespace
}  // namespace toile
