#include "core/project/project.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/core/project/documents.h"

namespace toile {
namespace {

struct Broken {
  const char* from;
  const char* to;
  const char* code;
  const char* where;
};

void expect_refused(const Broken& broken) {
  const auto project = project::parse_project(changed(kFullDocument, broken.from, broken.to));
  ASSERT_FALSE(project) << broken.to;
  EXPECT_EQ(project.error().code, broken.code) << to_string(project.error());
  EXPECT_EQ(project.error().where, broken.where) << to_string(project.error());
}

TEST(Project, ReadsEveryField) {
  const auto project = project::parse_project(kFullDocument);
  ASSERT_TRUE(project) << to_string(project.error());
  EXPECT_EQ(project->name, "All of it");
  ASSERT_EQ(project->pieces.size(), 4u);
  EXPECT_EQ(project->pieces[0].from->corners[1], (Vec2{10.5, 20}));
  EXPECT_EQ(project->pieces[0].placement.wrapped->angle, -45);
  EXPECT_EQ(project->pieces[1].outline[1].curves[0][2], (Vec2{110, 60}));
  EXPECT_TRUE(project->pieces[1].placement.rigid->flipped);
  EXPECT_EQ(project->fabrics[0].bend_bias_un_m, 7);
  EXPECT_TRUE(project->seams[0].b[0].reversed);
  EXPECT_EQ(project->bodies[0].restitution, 0.2);
  EXPECT_EQ(project->bodies[1].mannequin->triangles, 3000);
  EXPECT_EQ(project->pieces[2].placement.on_box->part, "hips");
  EXPECT_EQ(project->pieces[2].placement.on_box->anchor, (Vec2{20, 10}));
  EXPECT_EQ(project->pieces[3].placement.around->slope, -0.1);
  EXPECT_EQ(project->bodies[0].landmarks[0].share, (std::array<double, 3>{0.5, 0.25, 0.25}));
  EXPECT_EQ(project->bodies[0].landmarks[1].near, "mole");
  EXPECT_EQ(project->attachments[0].hold, "place");
  EXPECT_EQ(project->attachments[1].to->line, "waist");
  EXPECT_EQ(project->attachments[1].points[0], (Vec2{50, 50}));
  EXPECT_EQ(project->attachments[2].to->landmark, "neck_back");
  EXPECT_EQ(project->attachments[3].to->place, (Vec3{0, 1, 0.2}));
  EXPECT_EQ(project->settings.frame_interval_steps, 25);
}

TEST(Project, ComesBackTheSameFromItsOwnText) {
  const auto project = project::parse_project(kFullDocument);
  ASSERT_TRUE(project) << to_string(project.error());
  const std::string text = project::write_project(*project);
  const auto again = project::parse_project(text);
  ASSERT_TRUE(again) << to_string(again.error()) << "\n" << text;
  EXPECT_EQ(*project, *again);
  EXPECT_EQ(project::write_project(*again), text);
}

TEST(Project, DefaultsComeBackTheSameToo) {
  project::Project project;
  project.pieces.push_back(
      {.id = "a",
       .from = project::ProjectDxf{.dxf = "a.dxf", .piece = "A", .corners = {}, .units = ""},
       .outline = {},
       .holes = {},
       .edge_names = {},
       .grain = {},
       .fabric = "f",
       .placement = {.rigid = project::ProjectRigid{}, .wrapped = {}}});
  project.fabrics.push_back({});
  project.fabrics[0].id = "f";
  project.fabrics[0].like = "felt";
  const auto again = project::parse_project(project::write_project(project));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(project, *again);
}

TEST(Project, RefusesAKeyItDoesNotKnowAndNamesTheNearest) {
  expect_refused({"\"seams\"", "\"saems\"", "project.unknown_key", "/saems"});
  expect_refused({"\"edge\": \"right\"", "\"egde\": \"right\"", "project.unknown_key", "/seams/0/a/0/egde"});
  const auto project =
      project::parse_project(changed(kFullDocument, "\"bend_bias_un_m\"", "\"bend_bais_un_m\""));
  ASSERT_FALSE(project);
  EXPECT_NE(project.error().message.find("did you mean \"bend_bias_un_m\"?"), std::string::npos)
      << project.error().message;
}

TEST(Project, RefusesAMissingKey) {
  expect_refused({"\"id\": \"front\",", "", "project.missing_key", "/pieces/0"});
  expect_refused({"\"piece\": \"FRONT\",", "", "project.missing_key", "/pieces/0/from"});
  expect_refused({"\"radius\": 0.25,", "", "project.missing_key", "/pieces/0/placement/wrapped"});
  expect_refused({"\"file\": \"people/ann.obj\",", "", "project.missing_key", "/bodies/0"});
}

TEST(Project, RefusesAFabricThatIsLikeNoneAndLacksFigures) {
  const std::string alone = changed(kFullDocument, "\"like\": \"wool-suiting\",", "");
  EXPECT_TRUE(project::parse_project(alone));
  const Result<project::Project> lacking =
      project::parse_project(changed(alone, "\"bend_warp_un_m\": 14.5, ", ""));
  ASSERT_FALSE(lacking);
  EXPECT_EQ(lacking.error().code, "project.missing_key");
  EXPECT_EQ(lacking.error().where, "/fabrics/0");
}

TEST(Project, RefusesTwoWaysToSayOneThing) {
  expect_refused(
      {"\"grain\": [1, 2]", "\"from\": {\"dxf\": \"a\", \"piece\": \"b\"}", "project.two_ways", "/pieces/1"});
  expect_refused(
      {"\"id\": \"form\",", "\"id\": \"form\", \"file\": \"a.obj\",", "project.two_ways", "/bodies/1"});
}

TEST(Project, RefusesAValueOfTheWrongKind) {
  expect_refused({"\"All of it\"", "7", "project.wrong_type", "/name"});
  expect_refused({"[0.1, -0.2]", "[0.1, 0, -0.2]", "project.wrong_type", "/pieces/0/placement/wrapped/axis"});
  expect_refused({"[50, -5]", "[50, \"-5\"]", "project.wrong_type", "/pieces/1/outline/0/points/1/1"});
  expect_refused({"\"triangles\": 3000", "\"triangles\": 3000.5", "project.wrong_type",
                  "/bodies/1/mannequin/triangles"});
  expect_refused(
      {"\"flipped\": true", "\"flipped\": 1", "project.wrong_type", "/pieces/1/placement/rigid/flipped"});
  expect_refused(
      {"{\"e0\": \"waist\", \"e1\": \"side\"}", "[\"waist\"]", "project.wrong_type", "/pieces/0/edge_names"});
  expect_refused({"{\"particle_distance_mm\"", "[], \"extra\": {\"particle_distance_mm\"",
                  "project.unknown_key", "/extra"});
}

TEST(Project, RefusesANumberOutOfItsRange) {
  expect_refused(
      {"\"thickness_mm\": 0.61", "\"thickness_mm\": 0", "project.out_of_range", "/fabrics/0/thickness_mm"});
  expect_refused({"\"gravity\": 9.8", "\"gravity\": -1", "project.out_of_range", "/settings/gravity"});
  expect_refused({"[50, -5]", "[50, 1e300]", "project.out_of_range", "/pieces/1/outline/0/points/1/1"});
  expect_refused({"[0.2, 0.3, 0.9]", "[0.2, 0.3, 90]", "project.out_of_range", "/fabrics/0/colour/2"});
  expect_refused({"\"frame_interval_steps\": 25", "\"frame_interval_steps\": 0", "project.out_of_range",
                  "/settings/frame_interval_steps"});
}

TEST(Project, RefusesAListThatIsTooShort) {
  expect_refused(
      {"[[100, 100], [0, 100]]", "[[100, 100]]", "project.out_of_range", "/pieces/1/outline/2/points"});
  expect_refused(
      {"[{\"piece\": \"back\", \"edge\": \"right\", \"reversed\": false, \"from\": 0.1, \"to\": 0.9}]", "[]",
       "project.out_of_range", "/seams/0/a"});
}

TEST(Project, RefusesAWordThatIsNoChoice) {
  expect_refused({"\"unit\": \"cm\"", "\"unit\": \"feet\"", "project.unknown_value", "/bodies/0/unit"});
  expect_refused(
      {"\"hold\": \"place\"", "\"hold\": \"plaec\"", "project.unknown_value", "/attachments/0/hold"});
}

TEST(Project, RefusesAnEmptyOrEndlessText) {
  expect_refused({"\"id\": \"front\"", "\"id\": \"\"", "project.out_of_range", "/pieces/0/id"});
  const std::string endless = "\"id\": \"" + std::string(201, 'x') + "\"";
  expect_refused({"\"id\": \"front\"", endless.c_str(), "project.out_of_range", "/pieces/0/id"});
}

TEST(Project, RefusesAnotherVersionAndAnotherDocument) {
  expect_refused({"\"toile\": 1", "\"toile\": 2", "project.version", "/toile"});
  expect_refused({"\"toile\": 1,", "", "project.version", ""});
  EXPECT_EQ(project::parse_project("[]").error().code, "project.wrong_type");
  EXPECT_EQ(project::parse_project("").error().code, "json.syntax");
}

TEST(WriteChecked, SaysWhatReadingTheTextWouldSay) {
  const project::Project whole = project::parse_project(kFullDocument).value();
  std::vector<project::Project> changed(6, whole);
  changed[1].pieces[0].layer = 101;
  changed[2].fabrics[0].thickness_mm = std::nan("");
  changed[3].settings.gravity = std::numeric_limits<double>::infinity();
  changed[4].pieces[0].id = "";
  changed[5].fabrics.clear();
  for (const project::Project& project : changed) {
    const Result<project::WrittenProject> written = project::write_checked(project);
    const Result<project::Project> read = project::parse_project(project::write_project_line(project));
    ASSERT_EQ(bool(written), bool(read));
    if (written) {
      EXPECT_EQ(written->line, project::write_project_line(project));
      EXPECT_EQ(written->read_back, *read);
    } else {
      EXPECT_EQ(to_string(written.error()), to_string(read.error()));
    }
  }
  EXPECT_TRUE(project::write_checked(changed[0]));
}

TEST(WriteChecked, RefusesWhatIsTooLargeToBeReadAgain) {
  project::Project project = project::parse_project(kFullDocument).value();
  const project::ProjectLine line{"l", std::vector<Vec2>(10000, {12345.678, 12345.678}), true};
  project.pieces[0].lines.assign(25, line);
  EXPECT_EQ(project::write_checked(project).error().code, "json.too_large");
}

}  // namespace
}  // namespace toile
