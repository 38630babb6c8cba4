// What a document tells by the body: placements on its boxes, landmarks, goals of attachments.

#include "core/project/resolve/body_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arrange/box_places.h"
#include "core/body/measure/lines.h"
#include "core/body/mesh_import/load.h"
#include "core/project/create/places.h"
#include "core/project/resolve/resolve.h"
#include "tests/core/project/documents.h"

namespace toile {
namespace {

constexpr const char* kDressed = R"({
  "toile": 1,
  "pieces": [
    {"id": "front", "outline": [
      {"id": "hem", "points": [[0, 0], [300, 0]]}, {"id": "right", "points": [[300, 0], [300, 400]]},
      {"id": "top", "points": [[300, 400], [0, 400]]}, {"id": "left", "points": [[0, 400], [0, 0]]}],
     "fabric": "wool", "placement": {"on_box": {"part": "hips", "side": "back", "at": [0.02, 0.05]}}},
    {"id": "sleeve", "outline": [
      {"id": "a", "points": [[0, 0], [300, 0]]}, {"id": "b", "points": [[300, 0], [0, 200]]},
      {"id": "c", "points": [[0, 200], [0, 0]]}],
     "fabric": "wool", "placement": {"around": {"part": "left_arm", "side": "left", "away": 0.015}}}],
  "fabrics": [{"id": "wool", "areal_mass_g_m2": 210, "stretch_warp_n_m": 1500, "stretch_weft_n_m": 900,
    "stretch_coupling_n_m": 200, "stretch_shear_n_m": 120, "bend_warp_un_m": 14.5, "bend_weft_un_m": 9,
    "bend_bias_un_m": 7, "thickness_mm": 0.6}],
  "bodies": [{"id": "table", "file": "table.obj"},
             {"id": "ann", "file": "ann.obj", "skin_offset_mm": 1.5,
              "landmarks": [{"name": "mole", "triangle": 40},
                            {"name": "pocket", "near": "hip_front", "offset_mm": [80, 0, 0]}]}],
  "attachments": [{"id": "waist", "piece": "front", "edges": ["top"], "to": {"line": "waist", "up_mm": -20}},
                  {"id": "pin", "piece": "front", "points": [[150, 200]], "to": {"landmark": "pocket"}},
                  {"id": "mark", "piece": "front", "edges": ["hem"], "to": {"landmark": "mole"}},
                  {"id": "hook", "piece": "sleeve", "to": {"place": [0.5, 1.5, 0.25]}, "release_after_s": -1}]
})";

const geometry::TriangleMesh& ann() {
  static const geometry::TriangleMesh mesh =
      mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  return mesh;
}

Result<drape::DrapeInput> resolved(const std::string& text) {
  const project::Project project = TRY(project::parse_project(text));
  const geometry::TriangleMesh table{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  const resolve::ProjectFiles files{
      .dxf_text = {},
      .body_mesh = [&](const std::string& name,
                       const mesh_import::MeshSettings&) -> Result<mesh_import::RepairedMesh> {
        return mesh_import::RepairedMesh{name == "table.obj" ? table : ann(), {}};
      }};
  return resolve::resolve_project(project, files);
}

drape::DrapeInput dressed() { return resolved(kDressed).value(); }

void expect_refused(const std::string& from, const std::string& to, const char* code,
                    const std::string& where) {
  const Result<drape::DrapeInput> input = resolved(changed(kDressed, from, to));
  ASSERT_FALSE(input) << to;
  EXPECT_EQ(input.error().code, code) << to_string(input.error());
  EXPECT_TRUE(input.error().where.starts_with(where)) << to_string(input.error());
}

measure::PartBox box_of(measure::BodyPart part) {
  return measure::part_boxes(ann(), measure::find_figure(ann()).value())[static_cast<std::size_t>(part)];
}

TEST(BodyPlaces, APieceWithoutAPlaceIsNamed) {
  const project::Project none;
  const pattern::Panel panel{.id = "cuff", .outline = {}, .holes = {}, .fabric = {}};
  resolve::BodyPlaces places(none, {});
  const Result<sewing::Placement> nowhere =
      places.placement(project::ProjectPlacement{}, panel, "/pieces/3/placement");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, "project.no_placement");
  EXPECT_EQ(nowhere.error().where, "/pieces/3/placement");
  EXPECT_NE(nowhere.error().message.find("cuff"), std::string::npos);
}

TEST(ProjectBodyPlaces, APieceStandsWithItsMiddleBeforeTheSideThatIsNamed) {
  const drape::DrapeInput input = dressed();
  const measure::PartBox box = box_of(measure::BodyPart::kHips);
  const std::vector<Vec3> p = sewing::place({{0.15, 0.2}, {0.3, 0.2}, {0.15, 0.4}}, input.placements[0]);
  EXPECT_NEAR(dot(p[0] - box.centre, box.axis[2]), -(box.half.z + 0.03), 1e-9) << "3 cm behind the hips";
  EXPECT_NEAR(dot(p[0] - box.centre, box.axis[0]), -0.02, 1e-9) << "right as one looks at the back";
  EXPECT_NEAR(dot(p[0] - box.centre, box.axis[1]), 0.05, 1e-9);
  EXPECT_LT(cross(p[1] - p[0], p[2] - p[0]).z, 0) << "the right side outwards";
  EXPECT_GT(p[2].y, p[0].y + 0.19);
}

TEST(ProjectBodyPlaces, APieceGoesAroundAnArmClearOfIt) {
  const drape::DrapeInput input = dressed();
  const measure::PartBox box = box_of(measure::BodyPart::kLeftArm);
  const auto& wrapped = std::get<sewing::WrappedPlacement>(input.placements[1]);
  EXPECT_EQ(wrapped.anchor, (Vec2{0.15, 0.1}));
  EXPECT_NEAR(length(wrapped.up - box.axis[1]), 0, 1e-12);
  const double stands_out =
      arrange::radius_of_part(ann(), measure::find_figure(ann()).value(), box, -0.1, 0.1);
  EXPECT_NEAR(wrapped.radius, stands_out + 0.015, 1e-12) << "as the piece is 20 cm tall";
}

TEST(ProjectBodyPlaces, ASheetToldByABoxIsTheSameSheet) {
  const auto boxes = measure::part_boxes(ann(), measure::find_figure(ann()).value());
  for (const bool flipped : {false, true}) {
    const sewing::RigidPlacement sheet{{0.02, 0.8, -0.21}, {0, 3.14159265358979, 0.3}, flipped};
    const auto told = create::project_on_box(sheet, {0.1, 0.05}, boxes);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->side, "back");
    Result<project::Project> project = project::parse_project(kDressed);
    project->pieces[0].placement = {.on_box = told};
    const auto input = resolved(project::write_project(*project));
    ASSERT_TRUE(input) << to_string(input.error());
    const std::vector<Vec2> flat{{0, 0}, {0.3, 0}, {0.3, 0.4}};
    const std::vector<Vec3> p = sewing::place(flat, sheet), q = sewing::place(flat, input->placements[0]);
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_LT(length(p[i] - q[i]), 5e-5) << i << flipped;
  }
  EXPECT_FALSE(create::project_on_box({{0, 1, 0.3}, {0.5, 0, 0}, false}, {}, boxes)) << "parallel to no side";
}

TEST(ProjectBodyPlaces, PlacesFollowTheBodyWhereItStands) {
  const auto moved = resolved(changed(kDressed, "\"skin_offset_mm\": 1.5", "\"translation\": [1, 0, 2]"));
  ASSERT_TRUE(moved) << to_string(moved.error());
  const Vec3 by = std::get<sewing::RigidPlacement>(moved->placements[0]).translation -
                  std::get<sewing::RigidPlacement>(dressed().placements[0]).translation;
  EXPECT_NEAR(length(by - Vec3{1, 0, 2}), 0, 1e-9);
}

TEST(ProjectBodyPlaces, FlippedAPieceTurnsItsRightSideToTheBodyAndKeepsItsMiddle) {
  const auto flipped =
      resolved(changed(kDressed, "\"at\": [0.02, 0.05]", "\"at\": [0.02, 0.05], \"flipped\": true"));
  ASSERT_TRUE(flipped) << to_string(flipped.error());
  const std::vector<Vec2> flat{{0.15, 0.2}, {0.3, 0.2}, {0.15, 0.4}};
  const std::vector<Vec3> p = sewing::place(flat, flipped->placements[0]),
                          q = sewing::place(flat, dressed().placements[0]);
  EXPECT_NEAR(length(p[0] - q[0]), 0, 1e-9);
  EXPECT_NEAR(length(p[2] - q[2]), 0, 1e-9);
  EXPECT_NEAR(length(p[1] - p[0] + (q[1] - q[0])), 0, 1e-9) << "left and right swap";
}

TEST(ProjectBodyPlaces, AttachmentsLeadToLinesLandmarksAndPlaces) {
  const drape::DrapeInput input = dressed();
  const measure::BodyFigure figure = measure::find_figure(ann()).value();
  const std::vector<Vec3>& line = input.attachments[0].goal;
  ASSERT_GT(line.size(), 8u);
  for (const Vec3& p : line) EXPECT_NEAR(p.y, figure.waist - 0.02, 1e-7);
  // 1.5 mm of skin offset, and half a millimetre beyond it.
  EXPECT_NEAR(
      measure::length_of_loop(line),
      measure::trunk_girth(measure::PlaneCutter(ann()), figure, figure.waist - 0.02) + 2 * 3.14159265 * 2e-3,
      2e-3);
  ASSERT_EQ(input.attachments[1].goal.size(), 1u);
  const auto marks = measure::find_landmarks(ann(), figure);
  const Vec3 told = measure::landmark_named(marks, "hip_front")->place + Vec3{0.08, 0, 0};
  EXPECT_LT(length(input.attachments[1].goal[0] - told), 0.06) << "on the skin near there";
  EXPECT_GT(input.attachments[1].goal[0].x, 0.04);
  const Tri& t = ann().triangles[40];
  const Vec3 middle = (ann().vertices[t[0]] + ann().vertices[t[1]] + ann().vertices[t[2]]) * (1.0 / 3);
  EXPECT_NEAR(length(input.attachments[2].goal[0] - middle), 2e-3, 1e-6) << "before the skin";
  EXPECT_EQ(input.attachments[3].goal, (std::vector<Vec3>{{0.5, 1.5, 0.25}}));
  EXPECT_EQ(input.attachments[3].hold, sewing::Attachment::Hold::kGoal);
}

TEST(ProjectBodyPlaces, RefuseWhatTheBodyHasNotAndSayWhatThereIs) {
  expect_refused("\"line\": \"waist\"", "\"line\": \"wiast\"", "project.unknown_line",
                 "/attachments/0/to/line");
  expect_refused("\"landmark\": \"pocket\"", "\"landmark\": \"pokcet\"", "project.unknown_landmark",
                 "/attachments/1/to/landmark");
  expect_refused("\"line\": \"waist\", \"up_mm\": -20", "\"line\": \"waist\", \"up_mm\": 950", "body.no_line",
                 "/attachments/0/to/line");
  expect_refused("{\"line\": \"waist\"", "{\"body\": \"bob\", \"line\": \"waist\"", "project.unknown_body",
                 "/attachments/0/to/body");
  expect_refused("{\"line\": \"waist\"", "{\"body\": \"table\", \"line\": \"waist\"", "body.not_standing",
                 "/attachments/0/to");
  expect_refused("\"part\": \"hips\"", "\"body\": \"table\", \"part\": \"hips\"", "body.not_standing",
                 "/pieces/0/placement/on_box");
  expect_refused("\"part\": \"hips\"", "\"part\": \"tail\"", "project.unknown_value",
                 "/pieces/0/placement/on_box/part");
  expect_refused("\"triangle\": 40", "\"triangle\": 4000000", "landmark.no_triangle", "/bodies/1/landmarks");
  expect_refused("\"near\": \"hip_front\"", "\"near\": \"hip_frnot\"", "landmark.unknown",
                 "/bodies/1/landmarks");
  const auto slip = resolved(changed(kDressed, "\"line\": \"waist\"", "\"line\": \"wiast\""));
  EXPECT_NE(slip.error().message.find("did you mean \"waist\"?"), std::string::npos) << slip.error().message;
}

TEST(ProjectBodyPlaces, RefuseAttachmentsThatSayTwoThings) {
  expect_refused("\"edges\": [\"top\"], \"to\"", "\"edges\": [\"top\"], \"hold\": \"place\", \"to\"",
                 "project.two_ways", "/attachments/0/hold");
  expect_refused("\"edges\": [\"top\"], \"to\"", "\"to\"", "project.attached_whole", "/attachments/0");
  expect_refused("{\"line\": \"waist\", \"up_mm\": -20}", "{\"landmark\": \"crotch\", \"up_mm\": -20}",
                 "project.two_ways", "/attachments/0/to/up_mm");
  expect_refused("{\"line\": \"waist\", \"up_mm\": -20}", "{\"landmark\": \"crotch\", \"line\": \"waist\"}",
                 "project.two_ways", "/attachments/0/to");
  expect_refused("{\"line\": \"waist\", \"up_mm\": -20}", "{\"up_mm\": -20}", "project.missing_key",
                 "/attachments/0/to");
}

TEST(ProjectBodyPlaces, ALandmarkOnAMannequinMustBeToldFromAnother) {
  const auto input =
      resolved(changed(kDressed, "\"file\": \"ann.obj\"", "\"mannequin\": {\"triangles\": 2000}"));
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, "landmark.of_mannequin");
  EXPECT_EQ(input.error().where, "/bodies/1/landmarks/0/triangle");
}

}  // namespace
}  // namespace toile
