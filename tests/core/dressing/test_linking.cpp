#include "core/dressing/linking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// A circle about `middle`, square to `axis`, from corner to corner.
std::vector<Vec3> circle(Vec3 middle, Vec3 axis, double radius, int corners = 40) {
  const Vec3 u = normalized(cross(axis, std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(normalized(axis), u);
  std::vector<Vec3> line;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * std::numbers::pi * i / corners;
    line.push_back(middle + u * (radius * std::cos(a)) + v * (radius * std::sin(a)));
  }
  return line;
}

TEST(Linking, TwoRingsOfAChainAreLinkedOnce) {
  const auto a = circle({0, 0, 0}, {0, 0, 1}, 1), b = circle({1, 0, 0}, {0, 1, 0}, 1);
  EXPECT_EQ(std::abs(dressing::linking_number(a, b)), 1);
}

TEST(Linking, RingsBesideEachOtherAreNotLinked) {
  const auto a = circle({0, 0, 0}, {0, 0, 1}, 1);
  EXPECT_EQ(dressing::linking_number(a, circle({3, 0, 0}, {0, 1, 0}, 1)), 0);
  EXPECT_EQ(dressing::linking_number(a, circle({0, 0, 0.2}, {0, 0, 1}, 0.5)), 0) << "one inside the other";
}

TEST(Linking, AThreadWoundThreeTimesThroughARingIsLinkedThreeTimes) {
  std::vector<Vec3> thread;  // around the ring's body: a torus knot of one turn the long way
  for (int i = 0; i < 400; ++i) {
    const double a = 2 * std::numbers::pi * i / 400;
    const double r = 1 + 0.3 * std::cos(3 * a);
    thread.push_back({r * std::cos(a), r * std::sin(a), 0.3 * std::sin(3 * a)});
  }
  EXPECT_EQ(std::abs(dressing::linking_number(circle({0, 0, 0}, {0, 0, 1}, 1, 401), thread)), 3);
}

TEST(Linking, TheWhiteheadLinksNumberIsNoughtAlthoughItCannotBeParted) {
  // Through the ring one way and back, clasped with itself: the number alone does not see it.
  const auto ring = circle({0, 0, 0}, {0, 0, 1}, 1);
  const std::vector<Vec3> clasp{{0.3, 0, -2}, {0.3, 0, 2}, {-0.3, 0.4, 2}, {-0.3, 0.4, -2}};
  EXPECT_EQ(dressing::linking_number(ring, clasp), 0);
}

TEST(Linking, RingsTellTheLimbsThatTheyGoAround) {
  const measure::BodyFigure& f = test::person().figure;
  const dressing::Skeleton skeleton = dressing::skeleton_of(f);
  const auto around = [&](Vec3 middle, Vec3 axis, double radius) {
    return dressing::enclosed_by(circle(middle, axis, radius), skeleton).value().times;
  };
  using Times = std::array<int, dressing::kLimbCount>;
  EXPECT_EQ(around({f.middle, f.waist, 0}, {0, 1, 0}, 0.3), (Times{0, 0, 0, 1, 1})) << "a waistband";
  EXPECT_EQ(around((f.neck_front + f.neck_back) * 0.5, {0, 1, 0}, 0.12), (Times{1, 0, 0, 0, 0}))
      << "a neckline";
  const Vec3 face{f.middle, f.chin + 0.25 * (f.top - f.chin), f.neck_front.z + 0.15};
  EXPECT_EQ(around(face, {0, 0, 1}, 0.05), (Times{1, 0, 0, 0, 0})) << "a hood's edge, below the brow";
  EXPECT_EQ(around(f.arm[0].elbow, f.arm[0].along(), 0.1), (Times{0, 1, 0, 0, 0})) << "a left cuff";
  EXPECT_EQ(around(f.arm[1].elbow, f.arm[1].along(), 0.1), (Times{0, 0, 1, 0, 0})) << "a right cuff";
  EXPECT_EQ(around(f.leg[1].knee, {0, 1, 0}, 0.09), (Times{0, 0, 0, 0, 1})) << "a right leg";
  EXPECT_EQ(around(f.arm[0].elbow + Vec3{0, 0, 0.3}, f.arm[0].along(), 0.1), Times{}) << "before the arm";
}

}  // namespace
}  // namespace toile
