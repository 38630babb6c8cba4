#include "core/body/measure/landmarks.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/proportions.h"
#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

const geometry::TriangleMesh& mannequin() {
  static const geometry::TriangleMesh mesh =
      mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  return mesh;
}

/// What is true of everyone who stands.
void expect_a_person(const geometry::TriangleMesh& mesh, const std::string& who) {
  const auto figure = measure::find_figure(mesh);
  ASSERT_TRUE(figure.ok()) << who << ": " << to_string(figure.error());
  const auto marks = measure::find_landmarks(mesh, *figure);
  const double h = figure->height();
  const auto at = [&](const char* name) {
    const measure::Landmark* mark = measure::landmark_named(marks, name);
    EXPECT_NE(mark, nullptr) << who << ": " << name;
    return mark == nullptr ? Vec3{} : mark->place;
  };
  const auto share = [&](const char* name) { return (at(name).y - figure->floor) / h; };
  const char* rising[] = {"ankle_left", "knee_left",  "crotch",    "hip_front", "waist_front",
                          "bust_front", "neck_front", "neck_back", "head_top"};
  for (std::size_t i = 1; i < std::size(rising); ++i) {
    EXPECT_GT(at(rising[i]).y, at(rising[i - 1]).y - 0.002 * h) << who << ": " << rising[i];
  }
  // Proportions of adults (ANSUR II): wide enough for any of them.
  EXPECT_NEAR(share("crotch"), 0.46, 0.035) << who;
  EXPECT_NEAR(share("waist_front"), 0.63, 0.035) << who;
  EXPECT_NEAR(share("bust_point_left"), 0.72, 0.03) << who;
  EXPECT_NEAR(share("armpit_left"), 0.745, 0.03) << who;
  EXPECT_NEAR(share("shoulder_left"), 0.815, 0.025) << who;
  EXPECT_NEAR(share("neck_left"), 0.855, 0.02) << who;
  EXPECT_NEAR(share("knee_left"), 0.285, 0.03) << who;
  EXPECT_GT(at("waist_front").z, at("waist_back").z + 0.08 * h) << who;
  EXPECT_GT(at("waist_left").x, at("waist_right").x + 0.12 * h) << who;
  for (const char* name :
       {"shoulder", "armpit", "elbow", "wrist", "hand_tip", "knee", "ankle", "bust_point", "neck"}) {
    const Vec3 left = at((std::string(name) + "_left").c_str());
    const Vec3 right = at((std::string(name) + "_right").c_str());
    EXPECT_GT(left.x, figure->middle) << who << ": " << name << " is on the wearer's left";
    EXPECT_NEAR(left.x - figure->middle, figure->middle - right.x, 0.02 * h) << who << ": " << name;
    EXPECT_NEAR(left.y, right.y, 0.02 * h) << who << ": " << name;
  }
  EXPECT_GT(at("elbow_left").x, at("shoulder_left").x) << who;
  EXPECT_GT(at("wrist_left").x, at("elbow_left").x) << who;
  EXPECT_GT(at("hand_tip_left").x, at("wrist_left").x) << who;
}

TEST(Landmarks, AreFoundOnTheMannequin) { expect_a_person(mannequin(), "mannequin"); }

TEST(Landmarks, AreAtLeastThirtyWithNamesOfTheirOwnOnTheSkin) {
  const measure::BodyFigure figure = measure::find_figure(mannequin()).value();
  const auto marks = measure::find_landmarks(mannequin(), figure);
  EXPECT_GE(marks.size(), 30u);
  std::set<std::string> names;
  for (const measure::Landmark& mark : marks) {
    EXPECT_TRUE(names.insert(mark.name).second) << mark.name;
    EXPECT_NEAR(mark.at.share[0] + mark.at.share[1] + mark.at.share[2], 1, 1e-12);
    EXPECT_EQ(measure::position_of(mark.at, mannequin()), mark.place);
  }
}

TEST(Landmarks, AreOnTheSkinOfTheCoarsestFigures) {
  for (const char* size : {"eu34", "m50", "child92"}) {
    mannequin::MannequinSettings settings;
    settings.sex = mannequin::find_preset(size)->sex;
    settings.asked = mannequin::find_preset(size)->measures();
    settings.triangle_count = 1000;
    if (settings.sex == mannequin::Sex::kMale)
      settings.asked[measure::Measure::kWaist] = 0.92;  // no waist to speak of
    const Result<mannequin::Mannequin> made = mannequin::make_mannequin(settings);
    ASSERT_TRUE(made) << size << ": " << to_string(made.error());
    const Result<measure::BodyFigure> figure = measure::find_figure(made->mesh);
    ASSERT_TRUE(figure) << size << ": " << to_string(figure.error());
    const double h = figure->height();
    EXPECT_NEAR((figure->waist - figure->crotch) / h, 0.155, 0.06) << size;
    for (const measure::Landmark& mark : measure::find_landmarks(made->mesh, *figure)) {
      ASSERT_NE(mark.at.triangle, kNone) << size << ": " << mark.name;
      EXPECT_GE(mark.place.y, -1e-9) << size << ": " << mark.name;
      EXPECT_LE(mark.place.y, h + 1e-9) << size << ": " << mark.name;
    }
    EXPECT_GT(figure->bust_point[0].z, 0) << size;
    EXPECT_GT(figure->bust_point[1].z, 0) << size;
  }
}

TEST(Landmarks, TheNecksFrontIsBeforeItsBackHoweverCoarseTheMeshIsThere) {
  // A mesh may have no corner near the middle in front, while there is one behind.
  for (const char* preset : {"eu40", "eu46", "m46"}) {
    for (const Index triangles : {2200, 4562}) {
      mannequin::MannequinSettings settings;
      settings.sex = mannequin::find_preset(preset)->sex;
      settings.asked = mannequin::find_preset(preset)->measures();
      settings.triangle_count = triangles;
      const auto made = mannequin::make_mannequin(settings);
      ASSERT_TRUE(made.ok());
      const auto figure = measure::find_figure(made->mesh);
      ASSERT_TRUE(figure.ok());
      EXPECT_GT(figure->neck_front.z, figure->neck_back.z + 0.03) << preset << ' ' << triangles;
      const auto marks = measure::find_landmarks(made->mesh, *figure);
      for (const std::string name : {"waist", "hip", "bust"}) {
        const auto* front = measure::landmark_named(marks, name + "_front");
        const auto* back = measure::landmark_named(marks, name + "_back");
        ASSERT_TRUE(front != nullptr && back != nullptr);
        EXPECT_GT(front->place.z, back->place.z + 0.1) << preset << ' ' << triangles << ' ' << name;
      }
    }
  }
}

TEST(Landmarks, StayOnTheSkinWhenTheMeshIsReshaped) {
  geometry::TriangleMesh mesh = mannequin();
  const measure::SkinPoint point = measure::nearest_on_skin(mesh, {0, 1.1, 0.3});
  const Vec3 before = measure::position_of(point, mesh);
  for (Vec3& p : mesh.vertices) p = {p.x * 1.1, p.y, p.z * 1.2};
  const Vec3 after = measure::position_of(point, mesh);
  EXPECT_NEAR(after.x, before.x * 1.1, 1e-12);
  EXPECT_NEAR(after.z, before.z * 1.2, 1e-12);
}

TEST(Landmarks, StandWhereTheBodyStandsAndInItsSize) {
  geometry::TriangleMesh moved = mannequin();
  for (Vec3& p : moved.vertices) p = p * 0.7 + Vec3{0.4, 0.25, -0.3};
  const measure::BodyFigure a = measure::find_figure(mannequin()).value(),
                            b = measure::find_figure(moved).value();
  EXPECT_NEAR(b.waist, a.waist * 0.7 + 0.25, 2e-3);
  EXPECT_NEAR(b.middle, a.middle * 0.7 + 0.4, 1e-6);
  EXPECT_LT(length(b.arm[0].wrist - (a.arm[0].wrist * 0.7 + Vec3{0.4, 0.25, -0.3})), 0.01);
}

TEST(Landmarks, AThingWithoutLegsIsRefusedWithWords) {
  const geometry::TriangleMesh box{{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 2, 0}},
                                   {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  const auto figure = measure::find_figure(box);
  ASSERT_FALSE(figure.ok());
  EXPECT_EQ(figure.error().code, "body.not_standing");
  EXPECT_FALSE(measure::find_figure({}).ok());
}

TEST(Landmarks, AreFoundOnBodiesThatOthersMade) {
  const char* shared = std::getenv("TOILE_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: NO OTHER BODY WAS LOOKED AT";
  for (const char* name : {"garmentcode-mean_all", "makehuman-female-average", "makehuman-male-average"}) {
    const auto mesh =
        mesh_import::load_mesh(std::filesystem::path(shared) / "data/bodies" / (std::string(name) + ".obj"));
    ASSERT_TRUE(mesh.ok()) << to_string(mesh.error());
    expect_a_person(*mesh, name);
  }
}

}  // namespace
}  // namespace toile
