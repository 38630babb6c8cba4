#include "core/collision/contact_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "core/base/crew.h"
#include "core/collision/crossings.h"

namespace toile {
namespace {

/// A square sheet of n × n vertices, 1 cm apart, at height y.
struct Sheet {
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
};

void append_sheet(Sheet& sheet, int n, double y) {
  const auto first = static_cast<Index>(sheet.x.size());
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) sheet.x.push_back({0.01 * i, y, 0.01 * j});
  }
  for (int i = 0; i + 1 < n; ++i) {
    for (int j = 0; j + 1 < n; ++j) {
      const Index v = first + i * n + j;
      sheet.triangles.push_back({v, v + 1, v + n});
      sheet.triangles.push_back({v + 1, v + n + 1, v + n});
    }
  }
}

/// Moves every vertex as far as its bounds let it, towards random places near and beyond.
void move_at_random(const collision::Contacts& contacts, std::mt19937& random, double reach,
                    std::vector<Vec3>& x) {
  std::uniform_real_distribution<double> step(-reach, reach);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 to = x[i] + Vec3{step(random), step(random), step(random)};
    x[i] = contacts.reached(static_cast<Index>(i), x[i], to);
  }
}

TEST(Contacts, BoundsKeepTwoSheetsApartWhateverTheMoves) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    Sheet sheet;
    append_sheet(sheet, 6, 0);
    append_sheet(sheet, 6, 0.002);
    for (Vec3& p : sheet.x) p.x += p.y;  // no vertex above another
    const collision::Surface surface =
        collision::make_surface(sheet.triangles, static_cast<Index>(sheet.x.size()));
    collision::ContactFinder finder(surface, {}, collision::ContactSettings{});
    const std::vector<double> speeds(sheet.x.size(), 0.5);
    collision::Contacts contacts;
    for (int k = 0; k < 40; ++k) {
      finder.detect(sheet.x, speeds, contacts);
      for (int m = 0; m < 3; ++m) move_at_random(contacts, random, 0.004, sheet.x);
      ASSERT_TRUE(collision::self_crossings(surface, sheet.x).empty()) << "round " << round << ", move " << k;
    }
  }
}

TEST(Contacts, BoundsKeepASheetOutOfABodyWithEdgesAndPoints) {
  // A tetrahedron standing on its base, its tip under the sheet.
  const std::vector<Vec3> body{{0.02, 0.029, 0.024}, {0, 0, 0}, {0.05, 0, 0}, {0.02, 0, 0.05}};
  const std::vector<Tri> faces{{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
  const std::vector<collision::Obstacle> obstacles{collision::make_obstacle(body, faces, 0.4, 1e-3)};
  const collision::CrossingBody crossing_body = collision::make_crossing_body(body, faces);
  std::mt19937 random(5);
  Sheet sheet;
  append_sheet(sheet, 6, 0.03);
  const collision::Surface surface =
      collision::make_surface(sheet.triangles, static_cast<Index>(sheet.x.size()));
  collision::ContactFinder finder(surface, obstacles, collision::ContactSettings{});
  const std::vector<double> speeds(sheet.x.size(), 1.0);
  collision::Contacts contacts;
  for (int k = 0; k < 300; ++k) {
    finder.detect(sheet.x, speeds, contacts);
    move_at_random(contacts, random, 0.006, sheet.x);
    for (Vec3& p : sheet.x) {  // and a steady pull down
      const auto i = static_cast<Index>(&p - sheet.x.data());
      p = contacts.reached(i, p, p - Vec3{0, 0.001, 0});
    }
    ASSERT_TRUE(collision::body_crossings(surface, sheet.x, crossing_body).empty()) << "move " << k;
    ASSERT_TRUE(collision::self_crossings(surface, sheet.x).empty()) << "move " << k;
  }
}

/// Every third vertex or so, another choice each time.
std::vector<Index> some_of(std::size_t count, std::mt19937& random) {
  std::vector<Index> some;
  for (std::size_t v = 0; v < count; ++v) {
    if (random() % 3 == 0) some.push_back(static_cast<Index>(v));
  }
  return some;
}

TEST(Contacts, VerticesMeasuredAtDifferentTimesStillKeepSheetsAndABodyApart) {
  const std::vector<Vec3> body{{0.02, -0.001, 0.024}, {0, -0.03, 0}, {0.05, -0.03, 0}, {0.02, -0.03, 0.05}};
  const std::vector<Tri> faces{{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
  const std::vector<collision::Obstacle> obstacles{collision::make_obstacle(body, faces, 0.4, 1e-3)};
  const collision::CrossingBody crossing_body = collision::make_crossing_body(body, faces);
  std::mt19937 random(7);
  Sheet sheet;
  for (const double y : {0.0005, 0.002, 0.0035}) append_sheet(sheet, 6, y);
  for (Vec3& p : sheet.x) p.x += p.y;  // no vertex above another
  const std::size_t count = sheet.x.size();
  const collision::Surface surface = collision::make_surface(sheet.triangles, static_cast<Index>(count));
  collision::ContactFinder finder(surface, obstacles, collision::ContactSettings{});
  std::uniform_real_distribution<double> speed(0, 0.6);
  std::vector<double> speeds(count);
  collision::Contacts contacts;
  finder.detect(sheet.x, speeds, contacts);
  for (int k = 0; k < 400; ++k) {
    move_at_random(contacts, random, 0.004, sheet.x);
    for (double& v : speeds) v = speed(random);
    finder.detect_again(some_of(count, random), sheet.x, speeds, contacts);
    for (std::size_t v = 0; v < count; ++v)
      ASSERT_LE(length(sheet.x[v] - contacts.centre[v]), contacts.trust_radius[v] * (1 + 1e-9));
    ASSERT_TRUE(collision::self_crossings(surface, sheet.x).empty()) << "move " << k;
    ASSERT_TRUE(collision::body_crossings(surface, sheet.x, crossing_body).empty()) << "move " << k;
  }
}

void expect_same_lists(const collision::Contacts& a, const collision::Contacts& b) {
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t p = 0; p < a.pairs.size(); ++p) {
    ASSERT_EQ(a.pairs[p].v, b.pairs[p].v);
    ASSERT_EQ(a.pairs[p].gone, b.pairs[p].gone);
  }
  ASSERT_EQ(a.free_squared, b.free_squared);
  ASSERT_EQ(a.least_gap, b.least_gap);
  ASSERT_EQ(a.least_gap_vertex, b.least_gap_vertex);
  for (std::size_t v = 0; v < a.planes.size(); ++v) {
    ASSERT_EQ(a.planes[v].size(), b.planes[v].size());
    for (std::size_t k = 0; k < a.planes[v].size(); ++k) {
      ASSERT_EQ(a.planes[v][k].n, b.planes[v][k].n);
      ASSERT_EQ(a.planes[v][k].slack, b.planes[v][k].slack);
      ASSERT_EQ(a.planes[v][k].pair, b.planes[v][k].pair);
    }
  }
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    ASSERT_TRUE(std::equal(a.contacts[k].v, a.contacts[k].v + 4, b.contacts[k].v));
    ASSERT_EQ(a.contacts[k].n, b.contacts[k].n);
    ASSERT_EQ(a.contacts[k].c, b.contacts[k].c);
  }
}

TEST(Contacts, AreTheSameHoweverManyThreadsLook) {
  const std::vector<Vec3> body{{0.1, -0.001, 0.1}, {0, -0.03, 0}, {0.2, -0.03, 0}, {0.1, -0.03, 0.2}};
  const std::vector<Tri> faces{{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
  const std::vector<collision::Obstacle> obstacles{collision::make_obstacle(body, faces, 0.4, 1e-3)};
  Sheet sheet;
  for (const double y : {0.0005, 0.002, 0.0035}) append_sheet(sheet, 20, y);
  for (Vec3& p : sheet.x) p.x += p.y;
  const std::size_t count = sheet.x.size();
  const collision::Surface surface = collision::make_surface(sheet.triangles, static_cast<Index>(count));
  collision::ContactFinder one(surface, obstacles, {}), several(surface, obstacles, {});
  Crew alone, crew(3);
  collision::Contacts of_one, of_several;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> speed(0, 0.6);
  std::vector<double> speeds(count);
  for (int k = 0; k < 40; ++k) {
    for (double& v : speeds) v = speed(random);
    if (k % 10 == 0) {
      one.detect(sheet.x, speeds, of_one, alone);
      several.detect(sheet.x, speeds, of_several, crew);
    } else {
      const std::vector<Index> some = some_of(count, random);
      one.detect_again(some, sheet.x, speeds, of_one, alone);
      several.detect_again(some, sheet.x, speeds, of_several, crew);
    }
    ASSERT_FALSE(of_one.contacts.empty());
    expect_same_lists(of_one, of_several);
    move_at_random(of_one, random, 0.004, sheet.x);
  }
}

/// Slacks of each vertex's planes, from the least on.
std::vector<std::vector<double>> slacks_of(const collision::Contacts& contacts) {
  std::vector<std::vector<double>> all;
  for (const auto& planes : contacts.planes) {
    std::vector<double>& slacks = all.emplace_back();
    for (const collision::DivisionPlane& plane : planes) slacks.push_back(plane.slack);
    std::sort(slacks.begin(), slacks.end());
  }
  return all;
}

/// Which edge of a pair comes first is another's turn: the same but for rounding.
void expect_alike(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t v = 0; v < a.size(); ++v) {
    ASSERT_EQ(a[v].size(), b[v].size()) << "vertex " << v;
    for (std::size_t k = 0; k < a[v].size(); ++k) EXPECT_NEAR(a[v][k], b[v][k], 1e-12) << "vertex " << v;
  }
}

TEST(Contacts, AllMeasuredAgainListWhatAFirstMeasurementDoes) {
  std::mt19937 random(11);
  Sheet sheet;
  for (const double y : {0.0, 0.002}) append_sheet(sheet, 6, y);
  for (Vec3& p : sheet.x) p.x += p.y;
  const std::size_t count = sheet.x.size();
  const collision::Surface surface = collision::make_surface(sheet.triangles, static_cast<Index>(count));
  collision::ContactFinder finder(surface, {}, collision::ContactSettings{});
  const std::vector<double> speeds(count, 0.5);
  collision::Contacts again, anew;
  finder.detect(sheet.x, speeds, again);
  move_at_random(again, random, 0.004, sheet.x);
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), 0);
  finder.detect_again(all, sheet.x, speeds, again);
  finder.detect(sheet.x, speeds, anew);
  expect_alike(slacks_of(again), slacks_of(anew));
  EXPECT_FALSE(anew.contacts.empty());
  EXPECT_EQ(again.contacts.size(), anew.contacts.size());
  EXPECT_EQ(again.rims.size(), anew.rims.size());
}

TEST(Contacts, WhatIsMeasuredElsewhereStaysAsItWas) {
  Sheet sheet;
  for (const double y : {0.0, 0.002}) append_sheet(sheet, 20, y);
  for (Vec3& p : sheet.x) p.x += p.y;
  const std::size_t count = sheet.x.size();
  collision::ContactFinder finder(collision::make_surface(sheet.triangles, static_cast<Index>(count)), {},
                                  collision::ContactSettings{});
  const std::vector<double> speeds(count, 0.5);
  collision::Contacts contacts;
  finder.detect(sheet.x, speeds, contacts);
  const std::vector<std::vector<double>> before = slacks_of(contacts);
  sheet.x[0].y += 0.0004;  // a corner
  finder.detect_again({{0}}, sheet.x, speeds, contacts);
  EXPECT_NE(slacks_of(contacts)[0], before[0]);
  const Index far = 20 * 20 - 1;  // of the same sheet, the other corner
  EXPECT_EQ(slacks_of(contacts)[far], before[far]);
  EXPECT_FALSE(before[far].empty());
}

TEST(Contacts, AVertexAloneMayUseItsWholeBall) {
  Sheet sheet;
  append_sheet(sheet, 2, 0);
  collision::ContactFinder finder(collision::make_surface(sheet.triangles, 4), {},
                                  collision::ContactSettings{});
  collision::Contacts contacts;
  finder.detect(sheet.x, std::vector<double>(4, 0.0), contacts);
  const Vec3 start = sheet.x[0];
  EXPECT_NEAR(contacts.reached(0, start, start + Vec3{0, 0.002, 0}).y - start.y, 0.001, 4e-5);
  EXPECT_EQ(contacts.reached(0, start, start + Vec3{0, 0.0005, 0}).y, start.y + 0.0005);
}

TEST(Contacts, FasterVerticesGetLargerBalls) {
  Sheet sheet;
  append_sheet(sheet, 2, 0);
  collision::ContactFinder finder(collision::make_surface(sheet.triangles, 4), {},
                                  collision::ContactSettings{});
  collision::Contacts contacts;
  finder.detect(sheet.x, std::vector<double>{0, 0.3, 0.5, 100}, contacts);
  EXPECT_NEAR(contacts.trust_radius[0], 1e-3, 1e-4);
  EXPECT_NEAR(contacts.trust_radius[1], 1.5 * 0.3 * collision::ContactSettings{}.trust_radius_seconds, 1e-4);
  EXPECT_NEAR(contacts.trust_radius[3], 5e-3, 1e-4);
}

}  // namespace
}  // namespace toile
