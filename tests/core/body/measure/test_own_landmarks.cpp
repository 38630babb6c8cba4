#include "core/body/measure/own_landmarks.h"

#include <gtest/gtest.h>

#include "core/body/mannequin/mannequin.h"

namespace toile {
namespace {

struct MarkedMesh {
  geometry::TriangleMesh mesh;
  std::vector<measure::Landmark> landmarks;
};

MarkedMesh with_waist(double waist) {
  mannequin::MannequinSettings settings;
  settings.asked[measure::Measure::kHeight] = 1.68;
  settings.asked[measure::Measure::kWaist] = waist;
  settings.triangle_count = 3300;
  MarkedMesh person{mannequin::make_mannequin(settings).value().mesh, {}};
  person.landmarks = measure::find_landmarks(person.mesh, measure::find_figure(person.mesh).value());
  return person;
}

/// The trunk's triangle that looks most to the wearer's left front at a height.
measure::SkinPoint spot_on(const MarkedMesh& person, double height) {
  return measure::nearest_on_skin(person.mesh, {0.1, height, 0.2});
}

TEST(OwnLandmarks, AreKeptThroughAChangeOfMeasures) {
  const MarkedMesh slim = with_waist(0.70), stout = with_waist(0.92);
  ASSERT_NE(slim.mesh.triangles, stout.mesh.triangles)
      << "their triangles have nothing to do with each other";
  const measure::SkinPoint spot =
      spot_on(slim, measure::landmark_named(slim.landmarks, "waist_front")->place.y + 0.03);
  const measure::OwnLandmark told = measure::told_from_nearest("pocket", spot, slim.mesh, slim.landmarks);

  std::vector<measure::Landmark> again = slim.landmarks, carried = stout.landmarks;
  ASSERT_TRUE(measure::add_own_landmarks(slim.mesh, {&told, 1}, again));
  ASSERT_TRUE(measure::add_own_landmarks(stout.mesh, {&told, 1}, carried));
  EXPECT_LT(length(again.back().place - measure::position_of(spot, slim.mesh)), 1e-6);

  const measure::Landmark& pocket = carried.back();
  EXPECT_LT(length(measure::position_of(pocket.at, stout.mesh) - pocket.place), 1e-12)
      << "it lies on the skin";
  const measure::Landmark* before = measure::landmark_named(slim.landmarks, told.near);
  const measure::Landmark* after = measure::landmark_named(stout.landmarks, told.near);
  const Vec3 moved = pocket.place - again.back().place, expected = after->place - before->place;
  EXPECT_GT(length(expected), 0.005) << "22 cm more waist must move it";
  EXPECT_LT(length(moved - expected), 0.03) << "it goes along with the landmark that it was told from";
}

TEST(OwnLandmarks, OnAMeshAreAPointOfATriangle) {
  const MarkedMesh person = with_waist(0.74);
  const measure::OwnLandmark own{"mole", {17, {0.2, 0.3, 0.5}}, "", {}};
  std::vector<measure::Landmark> marks = person.landmarks;
  ASSERT_TRUE(measure::add_own_landmarks(person.mesh, {&own, 1}, marks));
  EXPECT_EQ(measure::landmark_named(marks, "mole")->place, measure::position_of(own.at, person.mesh));
}

TEST(OwnLandmarks, MayBeToldFromEachOtherInTheirOrder) {
  const MarkedMesh person = with_waist(0.74);
  const measure::OwnLandmark own[] = {{"first", {}, "hip_front", {0.02, 0, 0}},
                                      {"second", {}, "first", {0, 0.02, 0}}};
  std::vector<measure::Landmark> marks = person.landmarks;
  ASSERT_TRUE(measure::add_own_landmarks(person.mesh, own, marks));
  EXPECT_GT(measure::landmark_named(marks, "second")->place.y,
            measure::landmark_named(marks, "first")->place.y + 0.01);
}

TEST(OwnLandmarks, RefuseWhatIsNotOnTheBody) {
  const MarkedMesh person = with_waist(0.74);
  const auto code_of = [&](const measure::OwnLandmark& own) {
    std::vector<measure::Landmark> marks = person.landmarks;
    return measure::add_own_landmarks(person.mesh, {&own, 1}, marks).error().code;
  };
  EXPECT_EQ(code_of({"x", {1 << 20, {1, 0, 0}}, "", {}}), "landmark.no_triangle");
  EXPECT_EQ(code_of({"x", {-1, {1, 0, 0}}, "", {}}), "landmark.no_triangle");
  EXPECT_EQ(code_of({"x", {3, {0.5, 0.5, 0.5}}, "", {}}), "landmark.no_triangle");
  EXPECT_EQ(code_of({"x", {3, {1.5, -0.5, 0}}, "", {}}), "landmark.no_triangle");
  EXPECT_EQ(code_of({"x", {}, "navel", {}}), "landmark.unknown");
  std::vector<measure::Landmark> marks = person.landmarks;
  const measure::OwnLandmark twice[] = {{"mole", {3, {1, 0, 0}}, "", {}}, {"mole", {4, {1, 0, 0}}, "", {}}};
  EXPECT_EQ(measure::add_own_landmarks(person.mesh, twice, marks).error().code, "landmark.duplicate");
}

TEST(OwnLandmarks, MoveTheNamedOnesAndAreToldFromTheirFirstPlaces) {
  const MarkedMesh person = with_waist(0.74);
  std::vector<measure::Landmark> marks = person.landmarks;
  const Vec3 before = measure::landmark_named(marks, "hip_front")->place;
  const measure::OwnLandmark moved{"hip_front", {}, "hip_front", {0.04, 0.02, 0}};
  ASSERT_TRUE(measure::add_own_landmarks(person.mesh, {&moved, 1}, marks));
  EXPECT_EQ(marks.size(), person.landmarks.size());
  const Vec3 after = measure::landmark_named(marks, "hip_front")->place;
  EXPECT_NEAR(after.x - before.x, 0.04, 0.015);
  EXPECT_NEAR(after.y - before.y, 0.02, 0.015);
}

}  // namespace
}  // namespace toile
