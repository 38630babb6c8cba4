#include "core/project/resolve/resolve.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/units.h"
#include "core/body/measure/measures.h"
#include "core/fabric/library.h"
#include "tests/core/project/documents.h"

namespace toile {
namespace {

/// A square of 100 drawing units with its lower left corner at the origin, as a DXF polyline on layer FRONT.
std::string square_dxf() {
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nFRONT\n90\n4\n70\n1\n";
  for (const char* corner : {"0\n20\n0", "100\n20\n0", "100\n20\n100", "0\n20\n100"}) {
    text += std::string("10\n") + corner + "\n";
  }
  return text + "0\nTEXT\n8\nFRONT\n10\n50\n20\n50\n40\n5\n1\nFRONT\n0\nENDSEC\n0\nEOF\n";
}

/// Files that stand in this test; counts how often each kind is asked for.
struct Shelf {
  std::string dxf = square_dxf();
  geometry::TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  int dxf_reads = 0;
  mesh_import::MeshRepairs repairs{.holes = 1, .hole_triangles = 2};
  mesh_import::MeshSettings asked;

  resolve::ProjectFiles files() {
    return {
        .dxf_text = [this](const std::string&) -> Result<std::string> { return ++dxf_reads, dxf; },
        .body_mesh = [this](const std::string&,
                            const mesh_import::MeshSettings& settings) -> Result<mesh_import::RepairedMesh> {
          asked = settings;
          return mesh_import::RepairedMesh{mesh, repairs};
        }};
  }
};

constexpr const char* kSmall = R"({
  "toile": 1,
  "name": "Small",
  "pieces": [
    {"id": "front", "from": {"dxf": "cut.dxf", "piece": "FRONT"}, "edge_names": {"e0": "hem", "e2": "waist"},
     "fabric": "wool", "placement": {"wrapped": {"axis": [0.1, 0.2], "radius": 0.25, "angle": 90, "height": 1.1,
     "anchor": [50, 100], "slope": 0.2}}},
    {"id": "back", "outline": [
      {"id": "hem", "points": [[0, 0], [100, 0]]},
      {"id": "right", "curves": [[[100, 0], [110, 30], [110, 60], [100, 100]]]},
      {"id": "top", "points": [[100, 100], [0, 100]]},
      {"id": "left", "points": [[0, 100], [0, 0]]}],
     "holes": [[{"id": "eye", "points": [[40, 40], [60, 40], [60, 60], [40, 60], [40, 40]]}]],
     "grain": [3, 4], "fabric": "wool",
     "placement": {"rigid": {"translation": [0, 1, -0.3], "rotation": [0, 180, 0], "flipped": true}}}
  ],
  "fabrics": [{"id": "silk", "areal_mass_g_m2": 60, "stretch_warp_n_m": 500, "stretch_weft_n_m": 500,
      "stretch_coupling_n_m": 100, "stretch_shear_n_m": 50, "bend_warp_un_m": 1, "bend_weft_un_m": 1,
      "bend_bias_un_m": 1, "thickness_mm": 0.1},
    {"id": "wool", "areal_mass_g_m2": 210, "stretch_warp_n_m": 1500, "stretch_weft_n_m": 900,
      "stretch_coupling_n_m": 200, "stretch_shear_n_m": 120, "limit_warp_percent": 12.5,
      "limit_weft_percent": 20, "limit_shear_rad": 0.4, "bend_warp_un_m": 14.5, "bend_weft_un_m": 9,
      "bend_bias_un_m": 7, "thickness_mm": 0.6, "friction": 0.25, "colour": [0.2, 0.3, 0.9]}],
  "seams": [{"id": "top", "a": [{"piece": "front", "edge": "waist"}],
             "b": [{"piece": "back", "edge": "top", "reversed": true}], "same_direction": true}],
  "bodies": [{"id": "person", "file": "people/ann.obj", "unit": "cm", "skin_offset_mm": 2, "restitution": 0.3,
              "translation": [0, 0, 5], "rotation": [0, 90, 0], "scale": 2}],
  "attachments": [{"piece": "back", "edges": ["eye", "top"], "hold": "place", "release_after_s": 0.5}],
  "settings": {"particle_distance_mm": 20, "settle_speed_mm_s": 3}
})";

Result<drape::DrapeInput> resolved(const std::string& text, Shelf& shelf) {
  const project::Project project = TRY(project::parse_project(text));
  return resolve::resolve_project(project, shelf.files());
}

drape::DrapeInput small_input() {
  Shelf shelf;
  Result<drape::DrapeInput> input = resolved(kSmall, shelf);
  EXPECT_TRUE(input) << to_string(input.error());
  return input ? *std::move(input) : drape::DrapeInput{};
}

void expect_refused(const std::string& from, const std::string& to, const char* code,
                    const std::string& where) {
  Shelf shelf;
  const Result<drape::DrapeInput> input = resolved(changed(kSmall, from, to), shelf);
  ASSERT_FALSE(input) << to;
  EXPECT_EQ(input.error().code, code) << to_string(input.error());
  EXPECT_TRUE(input.error().where.starts_with(where)) << to_string(input.error());
}

TEST(ProjectResolve, TakesPiecesFromAFileAndFromTheDocument) {
  const drape::DrapeInput input = small_input();
  ASSERT_EQ(input.pattern.panels.size(), 2u);
  const pattern::Panel& front = input.pattern.panels[0];
  EXPECT_EQ(front.id, "front");
  ASSERT_EQ(front.outline.edges.size(), 4u);
  EXPECT_EQ(front.outline.edges[0].id, "hem");
  EXPECT_EQ(front.outline.edges[1].id, "e1");
  EXPECT_EQ(front.grain, (Vec2{0, 1}));
  const pattern::Panel& back = input.pattern.panels[1];
  EXPECT_EQ(back.outline.edges[1].curves[0].p1, (Vec2{110, 30}));
  EXPECT_NEAR(back.grain.x, 0.6, 1e-15);
  ASSERT_EQ(back.holes.size(), 1u);
}

TEST(ProjectResolve, TurnsUnitsIntoTheCores) {
  const drape::DrapeInput input = small_input();
  const material::Fabric& wool = input.fabrics[1];
  EXPECT_DOUBLE_EQ(wool.areal_mass, 0.21);
  EXPECT_DOUBLE_EQ(wool.limit_warp, 0.125);
  EXPECT_DOUBLE_EQ(wool.limit_weft, 0.2);
  EXPECT_DOUBLE_EQ(wool.limit_shear, 0.4);
  EXPECT_DOUBLE_EQ(wool.bend_warp, 14.5e-6);
  EXPECT_DOUBLE_EQ(wool.thickness, 0.6e-3);
  EXPECT_DOUBLE_EQ(wool.colour[2], 0.9);
  EXPECT_EQ(input.fabric_of_panel, (std::vector<Index>{1, 1}));
  EXPECT_DOUBLE_EQ(input.settings.particle_distance, 0.02);
  EXPECT_DOUBLE_EQ(input.settings.settle_speed, 0.003);
  const auto& wrapped = std::get<sewing::WrappedPlacement>(input.placements[0]);
  EXPECT_EQ(wrapped.axis, (Vec3{0.1, 0, 0.2}));
  EXPECT_DOUBLE_EQ(wrapped.angle, kPi / 2);
  EXPECT_DOUBLE_EQ(wrapped.anchor.y, 0.1);
  const auto& rigid = std::get<sewing::RigidPlacement>(input.placements[1]);
  EXPECT_DOUBLE_EQ(rigid.rotation.y, kPi);
  EXPECT_TRUE(rigid.flipped);
}

TEST(ProjectResolve, DefaultsOfTheDocumentAreThoseOfTheCore) {
  Shelf shelf;
  const auto input =
      resolved(changed(kSmall, R"("settings": {"particle_distance_mm": 20, "settle_speed_mm_s": 3})",
                       R"("settings": {})"),
               shelf);
  ASSERT_TRUE(input) << to_string(input.error());
  const drape::DrapeSettings core;
  EXPECT_DOUBLE_EQ(input->settings.particle_distance, core.particle_distance);
  EXPECT_DOUBLE_EQ(input->settings.time_step, core.time_step);
  EXPECT_DOUBLE_EQ(input->settings.gravity, core.gravity);
  EXPECT_DOUBLE_EQ(input->settings.sew_time, core.sew_time);
  EXPECT_DOUBLE_EQ(input->settings.settle_speed, core.settle_speed);
  EXPECT_DOUBLE_EQ(input->settings.max_time, core.max_time);
  EXPECT_EQ(input->settings.frame_interval, core.frame_interval);
  EXPECT_DOUBLE_EQ(input->fabrics[0].friction, material::Fabric{}.friction);
  EXPECT_DOUBLE_EQ(input->bodies[0].friction, body::Body{}.friction);
}

TEST(ProjectResolve, ThePapersMethodTakesItsSettingsFromTheDocument) {
  Shelf shelf;
  const auto with = [&](const std::string& settings) {
    const auto input =
        resolved(changed(kSmall, R"("settings": {"particle_distance_mm": 20, "settle_speed_mm_s": 3})",
                         R"("settings": )" + settings),
                 shelf);
    EXPECT_TRUE(input) << to_string(input.error());
    return input->settings;
  };
  EXPECT_EQ(with("{}").method, drape::DrapeMethod::kToile);
  const drape::DrapeSettings plain = with(R"({"solver": "paper"})");
  EXPECT_EQ(plain.method, drape::DrapeMethod::kPaper);
  EXPECT_EQ(plain.paper.passes, paper::PaperSettings{}.passes);
  const drape::DrapeSettings own = with(R"({"solver": "paper", "paper": {"time_step_s": 0.01, "damping": 0.2,
      "passes": 7, "reflection": 0.5, "load_n_m": 490, "clearance_mm": 2}})");
  EXPECT_DOUBLE_EQ(own.paper.time_step, 0.01);
  EXPECT_DOUBLE_EQ(own.paper.damping, 0.2);
  EXPECT_EQ(own.paper.passes, 7);
  EXPECT_DOUBLE_EQ(own.paper.reflection, 0.5);
  EXPECT_DOUBLE_EQ(own.paper.load, 490);
  EXPECT_DOUBLE_EQ(own.paper.clearance, 2e-3);
}

TEST(ProjectResolve, FindsSeamsAndAttachmentsByName) {
  const drape::DrapeInput input = small_input();
  ASSERT_EQ(input.pattern.seams.size(), 1u);
  const pattern::Seam& seam = input.pattern.seams[0];
  EXPECT_EQ(seam.a[0].panel, 0);
  EXPECT_EQ(seam.a[0].edge, 2);
  EXPECT_EQ(seam.b[0].edge, 2);
  EXPECT_TRUE(seam.b[0].reversed);
  EXPECT_TRUE(seam.same_direction);
  ASSERT_EQ(input.attachments.size(), 1u);
  EXPECT_EQ(input.attachments[0].edges,
            (std::vector<Index>{4, 2}));  // the hole's edge counts after the outline
  EXPECT_EQ(input.attachments[0].hold, sewing::Attachment::Hold::kPlace);
}

TEST(ProjectResolve, ScalesThenTurnsThenMovesABody) {
  Shelf shelf;
  const auto input = resolved(kSmall, shelf);
  ASSERT_TRUE(input) << to_string(input.error());
  EXPECT_DOUBLE_EQ(shelf.asked.unit_in_m, 0.01);
  EXPECT_FALSE(shelf.asked.z_up);
  const Vec3 p =
      input->bodies[0].mesh.vertices[1];  // (1, 0, 0), twice as far, a quarter turn about y, 5 m on
  EXPECT_NEAR(p.x, 0, 1e-12);
  EXPECT_NEAR(p.z, -2 + 5, 1e-12);
  EXPECT_DOUBLE_EQ(input->bodies[0].skin_offset, 2e-3);
  EXPECT_EQ(input->bodies[0].restitution, 0.3);
  EXPECT_EQ(input->bodies[0].notes, std::vector<std::string>{"1 small hole was filled with 2 triangles."});
}

TEST(ProjectResolve, MakesAMannequinOfTheAskedSize) {
  Shelf shelf;
  const auto input = resolved(changed(kSmall, R"("file": "people/ann.obj", "unit": "cm")",
                                      R"("mannequin": {"height_cm": 165, "triangles": 2000})"),
                              shelf);
  ASSERT_TRUE(input) << to_string(input.error());
  EXPECT_EQ(input->bodies[0].mesh.triangles.size(), 2000u);
}

std::string mannequin_that_moves(const std::string& keyframes) {
  return changed(kSmall, R"("file": "people/ann.obj", "unit": "cm")",
                 R"("mannequin": {"height_cm": 165, "triangles": 2000}, "motion": [)" + keyframes + "]");
}

TEST(ProjectResolve, AMannequinMovesToOthersByShapesOnTheWay) {
  Shelf shelf;
  const auto input = resolved(mannequin_that_moves(
                                  R"({"after_s": 2, "mannequin": {"height_cm": 165, "pose": "t"}},
                                     {"after_s": 3, "mannequin": {"height_cm": 165, "pose": "t", "hip_cm": 104}})"),
                              shelf);
  ASSERT_TRUE(input) << to_string(input.error());
  const body::Body& body = input->bodies[0];
  ASSERT_GT(body.motion.size(), 4u);
  double since = 0;
  for (const body::Keyframe& k : body.motion) {
    EXPECT_GT(k.at, since);
    EXPECT_EQ(k.vertices.size(), body.mesh.vertices.size());
    since = k.at;
  }
  EXPECT_EQ(since, 3);
  // It is turned by 90° and twice as large: hands reach along z, and hips are measured back to its size.
  const auto reach = [](const std::vector<Vec3>& x) {
    double most = 0;
    for (const Vec3& p : x) most = std::max(most, std::abs(p.z - 5));
    return most;
  };
  EXPECT_GT(reach(body.motion.back().vertices), 1.1 * reach(body.mesh.vertices)) << "arms are out";
  geometry::TriangleMesh end{body.motion.back().vertices, body.mesh.triangles};
  for (Vec3& p : end.vertices) p = Vec3{-(p.z - 5), p.y, p.x} * 0.5;
  const auto measures = measure::measure_body(end);
  ASSERT_TRUE(measures);
  EXPECT_NEAR((*measures)[measure::Measure::kHip]->value, 1.04, 0.01);
}

TEST(ProjectResolve, RefusesKeyframesOfAnotherMeshOrOutOfOrder) {
  const auto refused = [](const std::string& keyframes, const char* code, const std::string& where) {
    Shelf shelf;
    const auto input = resolved(mannequin_that_moves(keyframes), shelf);
    ASSERT_FALSE(input) << keyframes;
    EXPECT_EQ(input.error().code, code) << to_string(input.error());
    EXPECT_TRUE(input.error().where.starts_with(where)) << to_string(input.error());
  };
  refused(R"({"mannequin": {"height_cm": 166}}, {"mannequin": {"height_cm": 167}})", "project.keyframe_order",
          "/bodies/0/motion/1/after_s");
  refused(R"({"mannequin": {"sex": "male"}})", "project.keyframe_mesh", "/bodies/0/motion/0");
  refused(R"({"file": "people/ann.obj"})", "project.keyframe_mesh", "/bodies/0/motion/0");
  refused(R"({"mannequin": {"preset": "none"}})", "project.unknown_preset", "/bodies/0/motion/0");
}

TEST(ProjectResolve, OpensAFileOnceForAllItsPieces) {
  Shelf shelf;
  const std::string twice =
      changed(kSmall, "{\"id\": \"back\"",
              R"({"id": "other", "from": {"dxf": "cut.dxf", "piece": "FRONT"}, "fabric": "wool",
          "placement": {"rigid": {}}}, {"id": "back")");
  ASSERT_TRUE(resolved(twice, shelf));
  EXPECT_EQ(shelf.dxf_reads, 1);
}

TEST(ProjectResolve, LetsTheDocumentSayTheFilesUnit) {
  Shelf shelf;
  const auto input =
      resolved(changed(kSmall, R"("piece": "FRONT"})", R"("piece": "FRONT", "units": "cm"})"), shelf);
  ASSERT_TRUE(input) << to_string(input.error());
  EXPECT_DOUBLE_EQ(input->pattern.panels[0].outline.edges[0].curves.back().p3.x, 1000);
}

TEST(ProjectResolve, SwapsEdgeNamesWithoutLosingOne) {
  Shelf shelf;
  const auto input = resolved(
      changed(kSmall, R"({"e0": "hem", "e2": "waist"})", R"({"e0": "e1", "e1": "e0", "e2": "waist"})"),
      shelf);
  ASSERT_TRUE(input) << to_string(input.error());
  EXPECT_EQ(input->pattern.panels[0].outline.edges[0].id, "e1");
  EXPECT_EQ(input->pattern.panels[0].outline.edges[1].id, "e0");
}

drape::DrapeInput changed_input(const std::string& from, const std::string& to) {
  Shelf shelf;
  Result<drape::DrapeInput> input = resolved(changed(kSmall, from, to), shelf);
  EXPECT_TRUE(input) << to_string(input.error());
  return input ? *std::move(input) : drape::DrapeInput{};
}

const material::Fabric& fabric_of(const drape::DrapeInput& input, std::size_t piece) {
  return input.fabrics[static_cast<std::size_t>(input.fabric_of_panel[piece])];
}

TEST(ProjectResolve, PiecesMayNameAFabricOfTheLibrary) {
  const drape::DrapeInput input =
      changed_input("\"grain\": [3, 4], \"fabric\": \"wool\"", "\"fabric\": \"single-jersey\"");
  EXPECT_EQ(fabric_of(input, 0).id, "wool");
  EXPECT_EQ(fabric_of(input, 1).id, "single-jersey");
  EXPECT_DOUBLE_EQ(fabric_of(input, 1).areal_mass, 0.16);
}

/// From the second piece's fabric to the fabrics' list; and the same with the fabric said for the garment.
const std::string kTail = [] {
  const std::string text = kSmall;
  const std::size_t from = text.find("\"grain\": [3, 4]"), to = text.find("\"fabrics\": [");
  return text.substr(from, to + std::string_view("\"fabrics\": [").size() - from);
}();
const std::string kTailOf =
    changed(changed(kTail, ", \"fabric\": \"wool\"", ""), "\"fabrics\": [", "\"fabric\": ");

TEST(ProjectResolve, PiecesThatNameNoFabricAreOfTheGarments) {
  const drape::DrapeInput input = changed_input(kTail, kTailOf + "\"twill\", \"fabrics\": [");
  EXPECT_EQ(fabric_of(input, 0).id, "wool");
  EXPECT_EQ(fabric_of(input, 1).id, "twill");
}

TEST(ProjectResolve, AFabricLikeAnotherHasItsOwnFiguresFirst) {
  const drape::DrapeInput input = changed_input(
      "{\"id\": \"wool\", \"areal_mass_g_m2\": 210,",
      "{\"id\": \"old\", \"like\": \"denim-14oz\", \"areal_mass_g_m2\": 450}, {\"id\": \"wool\", "
      "\"areal_mass_g_m2\": 210,");
  const material::Fabric denim = fabric::fabric_of(*fabric::find("denim-14oz"));
  const material::Fabric& old = input.fabrics[1];
  EXPECT_EQ(old.id, "old");
  EXPECT_DOUBLE_EQ(old.areal_mass, 0.45);
  EXPECT_EQ(old.bend_warp, denim.bend_warp);
  EXPECT_EQ(old.limit_weft, denim.limit_weft);
}

TEST(ProjectResolve, CoefficientsStandForFigures) {
  const drape::DrapeInput input = changed_input(
      "{\"id\": \"wool\", \"areal_mass_g_m2\": 210,",
      "{\"id\": \"view\", \"like\": \"twill\", \"areal_mass_g_m2\": 100, \"coefficients\": "
      "{\"elasticity_warp\": 0.1, "
      "\"bending_warp\": 0.4, \"bending_weft\": 0.4}}, {\"id\": \"wool\", \"areal_mass_g_m2\": 210,");
  const material::Fabric& view = input.fabrics[1];
  const material::Fabric twill = fabric::fabric_of(*fabric::find("twill"));
  EXPECT_DOUBLE_EQ(view.limit_warp, 0.1);
  EXPECT_DOUBLE_EQ(view.stretch_warp, 600);
  EXPECT_EQ(view.limit_weft, twill.limit_weft) << "what is not told stays";
  EXPECT_NEAR(fabric::bending_length(view.bend_warp, 0.1), 0.02, 1e-12) << "by its own mass";
  EXPECT_NEAR(view.bend_bias, view.bend_warp, 1e-18) << "a circle is the same everywhere";
}

TEST(ProjectResolve, AnInterliningStiffensThePieceThatItIsOn) {
  const drape::DrapeInput input =
      changed_input("\"grain\": [3, 4], \"fabric\": \"wool\"",
                    "\"physical\": {\"interlining\": \"interlining\", \"friction\": 0.5}, "
                    "\"fabric\": \"wool\"");
  const material::Fabric wool = fabric_of(input, 0), stiff = fabric_of(input, 1);
  const material::Fabric lining = fabric::fabric_of(*fabric::find("interlining"));
  EXPECT_DOUBLE_EQ(stiff.areal_mass, wool.areal_mass + lining.areal_mass);
  EXPECT_DOUBLE_EQ(stiff.thickness, wool.thickness + lining.thickness);
  EXPECT_GT(stiff.bend_warp, 2 * (wool.bend_warp + lining.bend_warp)) << "a laminate";
  EXPECT_DOUBLE_EQ(stiff.limit_warp, std::min(wool.limit_warp, lining.limit_warp));
  EXPECT_DOUBLE_EQ(stiff.friction, 0.5);
}

TEST(ProjectResolve, RefusesAPieceOfNoFabric) {
  expect_refused("\"grain\": [3, 4], \"fabric\": \"wool\"", "\"grain\": [3, 4]", "project.missing_key",
                 "/pieces/1");
  expect_refused(kTail, kTailOf + "\"twil\", \"fabrics\": [", "project.unknown_fabric", "/fabric");
  expect_refused("{\"id\": \"wool\",", "{\"id\": \"wool\", \"like\": \"wol\",", "project.unknown_fabric",
                 "/fabrics/1/like");
}

TEST(ProjectResolve, RefusesNamesThatNothingBears) {
  expect_refused("\"piece\": \"front\", \"edge\": \"waist\"", "\"piece\": \"frnot\", \"edge\": \"waist\"",
                 "project.unknown_piece", "/seams/0/a/0/piece");
  expect_refused("\"edge\": \"top\"", "\"edge\": \"tpo\"", "project.unknown_edge", "/seams/0/b/0/edge");
  expect_refused("\"edges\": [\"eye\", \"top\"]", "\"edges\": [\"eye\", \"ear\"]", "project.unknown_edge",
                 "/attachments/0/edges/1");
  expect_refused("\"piece\": \"FRONT\"", "\"piece\": \"BACK\"", "project.unknown_piece",
                 "/pieces/0/from/piece");
  expect_refused("\"e2\": \"waist\"", "\"e9\": \"waist\"", "project.unknown_edge", "/pieces/0/edge_names/e9");
  expect_refused("\"grain\": [3, 4], \"fabric\": \"wool\"", "\"fabric\": \"lead\"", "project.unknown_fabric",
                 "/pieces/1/fabric");
}

TEST(ProjectResolve, SaysWhichNamesThereAre) {
  Shelf shelf;
  const auto input = resolved(changed(kSmall, "\"piece\": \"FRONT\"", "\"piece\": \"FRNOT\""), shelf);
  ASSERT_FALSE(input);
  EXPECT_NE(input.error().message.find("did you mean \"FRONT\"?"), std::string::npos)
      << input.error().message;
}

TEST(ProjectResolve, RefusesTheSameIdTwice) {
  expect_refused("\"id\": \"back\"", "\"id\": \"front\"", "project.duplicate_id", "/pieces/1/id");
  expect_refused("\"id\": \"silk\"", "\"id\": \"wool\"", "project.duplicate_id", "/fabrics/1/id");
  expect_refused("\"id\": \"left\"", "\"id\": \"hem\"", "pattern.duplicate_id", "/pieces/1/outline");
}

TEST(ProjectResolve, RefusesAnOutlineThatCannotBeCut) {
  expect_refused("[[0, 100], [0, 0]]", "[[0, 100], [0, 1]]", "pattern.open_outline", "/pieces/1/outline");
  expect_refused("[[40, 40], [60, 40], [60, 60], [40, 60], [40, 40]]", "[[40, 40], [60, 40], [40, 40]]",
                 "pattern.zero_area", "/pieces/1/holes/0");
  expect_refused("[40, 60], [40, 40]]", "[40, 600], [40, 40]]", "pattern.self_crossing", "/pieces/1");
  expect_refused("\"grain\": [3, 4]", "\"grain\": [0, 0]", "project.out_of_range", "/pieces/1/grain");
}

TEST(ProjectResolve, RefusesACrossingOutline) {
  expect_refused("[[100, 100], [0, 100]]", "[[100, 100], [50, -50], [0, 100]]", "pattern.self_crossing",
                 "/pieces/1");
}

TEST(ProjectResolve, RefusesAnEdgeSewnTwice) {
  expect_refused("\"seams\": [", R"("seams": [{"id": "again", "a": [{"piece": "front", "edge": "waist"}],
                 "b": [{"piece": "front", "edge": "e1"}]}, )",
                 "pattern.edge_sewn_twice", "/seams");
}

TEST(ProjectResolve, RefusesAFabricThatWouldGainEnergy) {
  expect_refused("\"stretch_coupling_n_m\": 200", "\"stretch_coupling_n_m\": 1200", "project.unstable_fabric",
                 "/fabrics/1/stretch_coupling_n_m");
}

TEST(ProjectResolve, RefusesPathsOutOfItsFolder) {
  for (const char* name : {"/etc/passwd", "../cut.dxf", "a/../../b.dxf", "..", "C:\\\\a.dxf", "a\\\\b.dxf"}) {
    expect_refused("\"dxf\": \"cut.dxf\"", std::string("\"dxf\": \"") + name + "\"", "project.path",
                   "/pieces/0/from/dxf");
    expect_refused("\"file\": \"people/ann.obj\"", std::string("\"file\": \"") + name + "\"", "project.path",
                   "/bodies/0/file");
  }
  EXPECT_TRUE(resolve::check_file_name("a/b..c/...dxf"));
  EXPECT_FALSE(resolve::check_file_name(std::string("a\0b", 3)));
}

TEST(ProjectResolve, PutsThePlaceOfADxfErrorBehindTheDocuments) {
  Shelf shelf;
  shelf.dxf = "this is no drawing\n";
  const auto input = resolved(kSmall, shelf);
  ASSERT_FALSE(input);
  EXPECT_TRUE(input.error().code.starts_with("dxf.")) << to_string(input.error());
  EXPECT_TRUE(input.error().where.starts_with("/pieces/0/from/dxf: cut.dxf")) << to_string(input.error());
}

class ProjectFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder =
        std::filesystem::path(testing::TempDir()) / ("toile_project_folder_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "people");
    write("project.json", kSmall);
    write("cut.dxf", square_dxf());
    write("people/ann.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\n");
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; }

  std::filesystem::path folder;
};

TEST_F(ProjectFolder, IsReadWithTheFilesBesideTheDocument) {
  const auto read = resolve::read_project(folder / "project.json");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->input.bodies[0].mesh.triangles.size(), 1u);
}

TEST_F(ProjectFolder, IsNotReadAgainForItsPictures) {
  const auto read = resolve::read_project(folder / "project.json");
  ASSERT_TRUE(read) << to_string(read.error());
  std::filesystem::remove_all(folder);
  const Result<image::Textures> textures = resolve::read_textures(*read);
  ASSERT_TRUE(textures) << to_string(textures.error());
  EXPECT_EQ(textures->of_panel.size(), read->project.pieces.size());
}

TEST_F(ProjectFolder, NamesTheFileThatIsMissing) {
  std::filesystem::remove(folder / "cut.dxf");
  const auto input = resolve::read_project(folder / "project.json");
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, "project.file");
  EXPECT_NE(input.error().where.find("/pieces/0/from/dxf"), std::string::npos) << input.error().where;
  EXPECT_EQ(resolve::read_project(folder / "none.json").error().code, "project.file");
  EXPECT_EQ(resolve::read_project(folder).error().code, "project.file");
  EXPECT_EQ(resolve::read_project("/dev/zero").error().code, "project.file");
}

TEST_F(ProjectFolder, RefusesADocumentThatIsTooLargeToBeOne) {
  write("project.json", std::string(std::size_t{5} << 20, ' '));
  EXPECT_EQ(resolve::read_project(folder / "project.json").error().code, "json.too_large");
}

}  // namespace
}  // namespace toile
