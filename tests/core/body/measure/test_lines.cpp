#include "core/body/measure/lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/body/measure/tape.h"
#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

struct Person {
  geometry::TriangleMesh mesh = mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  measure::BodyFigure figure = measure::find_figure(mesh).value();
};

const Person& person() {
  static const Person one;
  return one;
}

std::vector<Vec3> line(const std::string& name, double up = 0, double away = 0) {
  Result<std::vector<Vec3>> found =
      measure::body_line(measure::PlaneCutter(person().mesh), person().figure, name, up, away);
  EXPECT_TRUE(found.ok()) << name << ": " << to_string(found.error());
  return found ? *found : std::vector<Vec3>{{}, {}, {}};
}

Vec3 middle(const std::vector<Vec3>& loop) {
  Vec3 sum;
  for (const Vec3& p : loop) sum += p;
  return sum * (1.0 / static_cast<double>(loop.size()));
}

TEST(BodyLines, OfTheTrunkAreAsLongAsTheTapeSays) {
  for (const auto& [name, height] :
       {std::pair{"waist", person().figure.waist}, {"hip", person().figure.hip}}) {
    const std::vector<Vec3> loop = line(name);
    for (const Vec3& p : loop) EXPECT_NEAR(p.y, height, 1e-9) << name;
    EXPECT_NEAR(measure::length_of_loop(loop),
                measure::trunk_girth(measure::PlaneCutter(person().mesh), person().figure, height), 2e-3)
        << name;
  }
}

TEST(BodyLines, AllGoAroundWhatTheyAreNamedAfter) {
  const measure::BodyFigure& f = person().figure;
  for (const std::string& name : measure::body_line_names()) {
    const std::vector<Vec3> loop = line(name);
    EXPECT_GE(loop.size(), 4u) << name;
    const double around = measure::length_of_loop(loop);
    EXPECT_GT(around, 0.12) << name;
    EXPECT_LT(around, 1.2) << name;
    if (name.ends_with("_left")) {
      EXPECT_GT(middle(loop).x, f.middle) << name;
    }
    if (name.ends_with("_right")) {
      EXPECT_LT(middle(loop).x, f.middle) << name;
    }
  }
  EXPECT_NEAR(length(middle(line("wrist_left")) - f.arm[0].wrist), 0, 0.02);
  EXPECT_NEAR(length(middle(line("knee_right")) - f.leg[1].knee), 0, 0.03);
  const std::vector<Vec3> neckline = line("neckline");
  const auto gap = [&](Vec3 p) {
    double least = HUGE_VAL;
    for (const Vec3& q : neckline) least = std::min(least, length(p - q));
    return least;
  };
  EXPECT_LT(gap(f.neck_front), 0.02);
  EXPECT_LT(gap(f.neck_back), 0.02);
}

TEST(BodyLines, AreShiftedUpAndOutwards) {
  const std::vector<Vec3> lower = line("waist", -0.05), out = line("waist", 0, 0.01);
  EXPECT_NEAR(lower[0].y, person().figure.waist - 0.05, 1e-9);
  EXPECT_GT(measure::length_of_loop(lower), measure::length_of_loop(line("waist")))
      << "a body widens below its waist";
  // A closed convex line that is moved outwards by d grows by 2πd.
  EXPECT_NEAR(measure::length_of_loop(out) - measure::length_of_loop(line("waist")), 2 * 3.14159265 * 0.01,
              1e-3);
  const measure::BodyFigure& f = person().figure;
  EXPECT_LT(length(middle(line("wrist_left", 0.04)) - f.arm[0].root), length(f.arm[0].wrist - f.arm[0].root))
      << "up an arm is towards the trunk";
}

TEST(BodyLines, RunCounterClockwiseSeenFromAbove) {
  for (const char* name : {"waist", "neckline", "thigh_left"}) {
    const std::vector<Vec3> loop = line(name);
    Vec3 turning;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      turning += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
    EXPECT_GT(turning.y, 0) << name;
  }
}

TEST(BodyLines, RefuseNamesAndPlacesThatABodyHasNot) {
  EXPECT_EQ(measure::body_line(measure::PlaneCutter(person().mesh), person().figure, "wiast").error().code,
            "body.unknown_line");
  EXPECT_EQ(measure::body_line(measure::PlaneCutter(person().mesh), person().figure, "waist", 3).error().code,
            "body.no_line");
}

}  // namespace
}  // namespace toile
