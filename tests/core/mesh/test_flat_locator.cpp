#include "core/mesh/flat_locator.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// A grid of n by n squares of one metre, each cut into two triangles.
struct Sheet {
  std::vector<Vec2> rest;
  std::vector<Tri> triangles;
  explicit Sheet(Index n) {
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i) rest.push_back({static_cast<double>(i), static_cast<double>(j)});
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < n; ++i) {
        const Index a = j * (n + 1) + i;
        triangles.push_back({a, a + 1, a + n + 2});
        triangles.push_back({a, a + n + 2, a + n + 1});
      }
    }
  }
};

Vec2 place_of(const Sheet& sheet, const mesh::FlatPlace& at) {
  Vec2 p;
  for (std::size_t k = 0; k < 3; ++k) p = p + sheet.rest[sheet.triangles[at.triangle][k]] * at.share[k];
  return p;
}

TEST(FlatLocator, FindsTheTriangleOfEveryPointWithItsShares) {
  const Sheet sheet(9);
  const mesh::FlatLocator locator(sheet.rest, sheet.triangles);
  for (int k = 0; k < 500; ++k) {
    const Vec2 p{9 * std::fmod(0.618034 * k, 1.0), 9 * std::fmod(0.754878 * k, 1.0)};
    const mesh::FlatPlace at = locator.at(p);
    EXPECT_LT(at.outside, 1e-12);
    EXPECT_LT(length(place_of(sheet, at) - p), 1e-12);
  }
}

TEST(FlatLocator, GivesTheNearestTriangleOfAPointOutsideAndTellsHowFarOutsideItIs) {
  const Sheet sheet(4);
  const mesh::FlatLocator locator(sheet.rest, sheet.triangles);
  for (const Vec2 p : {Vec2{-0.5, 2.2}, Vec2{4.25, 0.5}, Vec2{100, 100}}) {
    const mesh::FlatPlace at = locator.at(p);
    EXPECT_GT(at.outside, 0.2);
    EXPECT_LT(length(place_of(sheet, at) - p), 1e-9) << "its shares carry on in the triangle's plane";
  }
  EXPECT_NEAR(locator.at({-0.5, 2.2}).outside, 0.5, 1e-12);
}

TEST(FlatLocator, TakesSliversAcrossAllOfItWithLittleMemory) {
  Sheet sheet(60);
  const auto corner = static_cast<Index>(sheet.rest.size());
  for (const Vec2 p : {Vec2{0, 0}, Vec2{1e6, 1e-3}, Vec2{1e6, 1}}) sheet.rest.push_back(p);
  for (int k = 0; k < 20000; ++k) sheet.triangles.push_back({corner, corner + 1, corner + 2});
  const mesh::FlatLocator locator(sheet.rest, sheet.triangles);
  EXPECT_LT(length(place_of(sheet, locator.at({30.25, 40.5})) - Vec2{30.25, 40.5}), 1e-9);
}

TEST(FlatLocator, HasNoPlaceWhereThereIsNoCloth) {
  EXPECT_EQ(mesh::FlatLocator({}, {}).at({1, 1}).triangle, kNone);
}

}  // namespace
}  // namespace toile
