// The document's mannequin: what it asks for, and that documents of before mean the same body.

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/body/mannequin/proportions.h"
#include "core/project/bodies.h"
#include "core/project/editing/edits.h"
#include "tests/core/project/documents.h"

namespace toile {
namespace {

Result<project::Project> dressed(const std::string& mannequin) {
  return project::parse_project(R"({
    "toile": 1,
    "pieces": [{"id": "cloth", "outline": [{"id": "a", "points": [[0, 0], [100, 0]]},
      {"id": "b", "points": [[100, 0], [0, 100]]}, {"id": "c", "points": [[0, 100], [0, 0]]}],
      "fabric": "wool", "placement": {"rigid": {}}}],
    "fabrics": [{"id": "wool", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500,
      "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7,
      "thickness_mm": 0.4}],
    "seams": [],
    "bodies": [{"id": "form", "mannequin": )" +
                                mannequin + "}]}");
}

Result<mannequin::MannequinSettings> settings_of(const std::string& mannequin) {
  const project::Project project = TRY(dressed(mannequin));
  return project::mannequin_settings(*project.bodies[0].mannequin);
}

TEST(ProjectMannequin, OfBeforeIsTheSameWoman) {
  mannequin::MannequinSettings before;  // as documents were read before they knew presets
  constexpr double kMetres = 1e-2;
  before.asked[measure::Measure::kHeight] = 165.0 * kMetres;
  before.asked[measure::Measure::kBust] = 90.0 * kMetres;
  before.asked[measure::Measure::kWaist] = 72.0 * kMetres;
  before.asked[measure::Measure::kHip] = 96.0 * kMetres;
  before.triangle_count = 3300;
  const Result<mannequin::MannequinSettings> now = settings_of(R"({"height_cm": 165})");
  ASSERT_TRUE(now) << to_string(now.error());
  EXPECT_EQ(now->asked.values, before.asked.values);
  EXPECT_EQ(now->sex, mannequin::Sex::kFemale);
  EXPECT_EQ(now->arm_angle, before.arm_angle);
  EXPECT_EQ(now->triangle_count, before.triangle_count);
}

TEST(ProjectMannequin, HasThePresetsMeasuresWithItsOwnOverThem) {
  const Result<mannequin::MannequinSettings> made =
      settings_of(R"({"preset": "m50", "waist_cm": 95, "pose": "t"})");
  ASSERT_TRUE(made) << to_string(made.error());
  const measure::MeasureSet preset = mannequin::find_preset("m50")->measures();
  EXPECT_EQ(made->sex, mannequin::Sex::kMale);
  EXPECT_EQ(made->asked[measure::Measure::kBust], preset[measure::Measure::kBust]);
  EXPECT_DOUBLE_EQ(*made->asked[measure::Measure::kWaist], 0.95);
  EXPECT_EQ(made->arm_angle, mannequin::kQuarterTurn);
}

TEST(ProjectMannequin, OfASexAloneFollowsProportions) {
  const Result<mannequin::MannequinSettings> made =
      settings_of(R"({"sex": "child", "height_cm": 110, "arm_angle": 40})");
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_FALSE(made->asked[measure::Measure::kBust].has_value());
  EXPECT_DOUBLE_EQ(made->arm_angle, radians_from_degrees(40));
}

TEST(ProjectMannequin, NamesThePresetThatIsMeant) {
  const Result<mannequin::MannequinSettings> made = settings_of(R"({"preset": "eu39"})");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "project.unknown_preset");
  EXPECT_NE(made.error().message.find("eu3"), std::string::npos) << made.error().message;
}

TEST(ProjectMannequin, IsWrittenAsItWasRead) {
  const Result<project::Project> project = project::parse_project(kFullDocument);
  ASSERT_TRUE(project) << to_string(project.error());
  const Result<project::Project> again = project::parse_project(project::write_project(*project));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(project->bodies, again->bodies);
  EXPECT_EQ(project->bodies[1].mannequin->measures_cm[static_cast<std::size_t>(measure::Measure::kCalf)],
            36.0);
}

TEST(ProjectMannequin, IsGivenBackByUndo) {
  const Result<project::Project> project = dressed(R"({"triangles": 1000})");
  ASSERT_TRUE(project) << to_string(project.error());
  editing::RestoreLists other;
  project::ProjectBody body = project->bodies[0];
  body.mannequin->preset = "eu40";
  other.bodies = editing::ListSplice<project::ProjectBody>{0, 1, {body}};
  resolve::ProjectFiles files;
  std::vector<mannequin::MannequinSettings> asked;
  files.mannequin = [&](const mannequin::MannequinSettings& settings) -> Result<geometry::TriangleMesh> {
    asked.push_back(settings);
    return geometry::TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  };
  const std::vector<editing::ProjectEdit> edits{other};
  const Result<editing::EditedProject> edited = editing::apply_edits(*project, edits, files);
  ASSERT_TRUE(edited) << to_string(edited.error());
  EXPECT_EQ(edited->project.bodies[0].mannequin->preset, "eu40");
  ASSERT_EQ(asked.size(), 1u) << "another body is looked at before it is kept";
  EXPECT_DOUBLE_EQ(*asked[0].asked[measure::Measure::kBust], 0.92);
  const Result<editing::EditedProject> back = editing::apply_edits(edited->project, edited->inverse, files);
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(back->project, *project);
}

}  // namespace
}  // namespace toile
