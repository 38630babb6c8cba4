#include "core/project/editing/edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/pattern/curve.h"
#include "core/sewing/placement.h"
#include "tests/core/project/editing/edited_document.h"

namespace toile {
namespace {

using test::kEditedDocument;
using test::square_files;

project::Project base() { return project::parse_project(kEditedDocument).value(); }

Result<editing::EditedProject> edited(const project::Project& project, const std::string& edits) {
  const json::JsonValue list = TRY(json::parse_json(edits));
  const std::vector<editing::ProjectEdit> read = TRY(editing::read_edits(list, "/edits"));
  return editing::apply_edits(project, read, square_files());
}

/// The project after the edits; undoing them has given the same bytes again.
project::Project after(const project::Project& project, const std::string& edits) {
  const Result<editing::EditedProject> out = edited(project, edits);
  EXPECT_TRUE(out) << to_string(out.error());
  if (!out) return project;
  EXPECT_EQ(out->document, project::write_project_line(out->project));
  const Result<editing::EditedProject> back =
      editing::apply_edits(out->project, out->inverse, square_files());
  EXPECT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(back ? back->document : "", project::write_project_line(project));
  return out->project;
}

Error refused(const project::Project& project, const std::string& edits) {
  const Result<editing::EditedProject> out = edited(project, edits);
  EXPECT_FALSE(out) << "the edits were carried out";
  return out ? Error{} : out.error();
}

template <typename T>
const T& named(const std::vector<T>& list, const std::string& id) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const T& one) { return one.id == id; });
  EXPECT_NE(found, list.end()) << id;
  return *found;
}

std::vector<Vec3> stands(const project::Project& project, const std::string& piece,
                         const std::vector<Vec2>& at_mm) {
  project::Project cloth = project;
  cloth.bodies.clear();
  const drape::DrapeInput input = resolve::resolve_project(cloth, square_files()).value();
  for (std::size_t i = 0; i < input.pattern.panels.size(); ++i) {
    if (input.pattern.panels[i].id != piece) continue;
    std::vector<Vec2> flat;
    for (const Vec2 p : at_mm) flat.push_back(p * 1e-3);
    return sewing::place(flat, input.placements[i]);
  }
  return {};
}

TEST(ProjectEdit, MakesAnOutlineOfAPieceFromAFileWhenItsShapeChanges) {
  const project::Project now =
      after(base(), R"([{"edit": "move_point", "piece": "front", "edge": "right", "point": 1,
                                        "to": [120, 110]}])");
  const project::ProjectPiece& front = named(now.pieces, "front");
  EXPECT_FALSE(front.from);
  EXPECT_TRUE(front.edge_names.empty());
  ASSERT_EQ(front.outline.size(), 4u);
  EXPECT_EQ(front.outline[1].id, "right");
  EXPECT_EQ(front.outline[1].curves.back()[3], (Vec2{120, 110}));
  EXPECT_EQ(now.pieces[1], base().pieces[1]) << "the others stay as they were written";
}

TEST(ProjectEdit, LeavesAPieceInItsFileWhenOnlyItsLinesGrainOrClothChange) {
  const project::Project now =
      after(base(), R"([{"edit": "add_line", "piece": "front", "id": "l2", "points": [[20, 20], [80, 20]]},
    {"edit": "rotate_grain", "piece": "front", "angle": 45},
    {"edit": "set_fabric", "piece": "front", "fabric": "silk"},
    {"edit": "set_texture", "piece": "front", "texture": {"image": "a.png", "scale_mm": 50}},
    {"edit": "set_physical", "piece": "front", "physical": {"thickness_mm": 2, "particle_distance_mm": 4}}])");
  const project::ProjectPiece& front = now.pieces[0];
  ASSERT_TRUE(front.from);
  EXPECT_EQ(front.lines.size(), 2u);
  EXPECT_NEAR(front.grain->x, -std::sqrt(0.5), 1e-12);
  EXPECT_EQ(front.fabric, "silk");
  EXPECT_EQ(front.texture->scale_mm, 50);
  EXPECT_EQ(front.physical->thickness_mm, 2);
  EXPECT_EQ(front.physical->particle_distance_mm, 4);
  EXPECT_FALSE(after(now, R"([{"edit": "set_texture", "piece": "front"}])").pieces[0].texture);
}

TEST(ProjectEdit, ChoosesTheSolverAndIsUndoneByTheOneOfBefore) {
  const project::Project before = base();
  const project::Project now = after(before, R"([{"edit": "set_solver", "solver": "paper"}])");
  EXPECT_EQ(now.settings.solver, "paper");
  EXPECT_EQ(now.pieces, before.pieces);
  EXPECT_EQ(after(now, R"([{"edit": "set_solver", "solver": "toile"}])"), before);
  const project::Project both = after(before, R"([{"edit": "set_solver", "solver": "paper"},
    {"edit": "set_fabric", "piece": "front", "fabric": "silk"}])");
  EXPECT_EQ(both.settings.solver, "paper");
  EXPECT_EQ(named(both.pieces, "front").fabric, "silk");
}

TEST(ProjectEdit, GivesTheDrapeMoreTimeAndIsUndoneByTheTimeOfBefore) {
  const project::Project before = base();
  const project::Project now = after(before, R"([{"edit": "set_max_time", "max_time_s": 24}])");
  EXPECT_EQ(now.settings.max_time_s, 24);
  EXPECT_EQ(now.pieces, before.pieces);
  const std::string back = std::to_string(before.settings.max_time_s);
  EXPECT_EQ(after(now, R"([{"edit": "set_max_time", "max_time_s": )" + back + "}]"), before);
}

TEST(ProjectEdit, LinesOfTheFileComeAlongWhenAPieceLeavesIt) {
  const project::Project project = base();
  project::Project cloth = project;
  cloth.bodies.clear();
  const pattern::Panel drawn = resolve::resolve_project(cloth, square_files()).value().pattern.panels[0];
  ASSERT_EQ(drawn.lines.size(), 2u);
  EXPECT_EQ(drawn.lines[0].id, "i0");
  EXPECT_TRUE(drawn.lines[0].drawn);
  EXPECT_FALSE(drawn.lines[1].drawn) << "the document's own line is followed";
  const auto lines = [](const project::Project& p) { return named(p.pieces, "front").lines; };
  const project::Project reshaped = after(project, R"([{"edit": "mirror_piece", "piece": "front"}])");
  ASSERT_EQ(lines(reshaped).size(), 2u);
  EXPECT_TRUE(lines(reshaped)[0].drawn);
  EXPECT_EQ(lines(reshaped)[0].points, (std::vector<Vec2>{{70, 30}, {30, 30}}));
  const project::Project rubbed =
      after(project, R"([{"edit": "remove_line", "piece": "front", "line": "i0"}])");
  EXPECT_FALSE(named(rubbed.pieces, "front").from) << "the file would draw it again";
  ASSERT_EQ(lines(rubbed).size(), 1u);
  EXPECT_EQ(lines(rubbed)[0].id, "pleat");
}

TEST(ProjectEdit, ALineOfTheFileGivesWayToTheDocumentsIds) {
  project::Project project = base();
  project.bodies.clear();
  project.pieces[0].lines[0].id = "i0";
  project.folds[0].lines[0] = "i0";
  const pattern::Panel panel = resolve::resolve_project(project, square_files()).value().pattern.panels[0];
  ASSERT_EQ(panel.lines.size(), 2u);
  EXPECT_EQ(panel.lines[0].id, "i0_2");
  EXPECT_EQ(panel.lines[1].id, "i0");
}

TEST(ProjectEdit, MarksMovesAndUnmarksANotch) {
  const project::Project marked =
      after(base(), R"([{"edit": "add_notch", "piece": "band", "edge": "low", "at": 0.25, "depth_mm": 4}])");
  const std::vector<project::ProjectNotch>& one = named(marked.pieces, "band").notches;
  ASSERT_EQ(one.size(), 1u);
  EXPECT_LT(length(one[0].at - Vec2{50, 0}), 1e-9);
  EXPECT_EQ(one[0].depth_mm, 4);
  EXPECT_EQ(*one[0].inwards, (Vec2{0, 1}));
  const project::Project moved =
      after(marked, R"([{"edit": "move_notch", "piece": "band", "notch": 0, "edge": "high",
                                          "at": 0.25}])");
  EXPECT_LT(length(named(moved.pieces, "band").notches[0].at - Vec2{150, 30}), 1e-9);
  EXPECT_EQ(named(moved.pieces, "band").notches[0].depth_mm, 4);
  const project::Project bare = after(moved, R"([{"edit": "remove_notch", "piece": "band", "notch": 0}])");
  EXPECT_TRUE(named(bare.pieces, "band").notches.empty());
  EXPECT_EQ(refused(bare, R"([{"edit": "remove_notch", "piece": "band", "notch": 0}])").code,
            "edit.unknown_notch");
}

TEST(ProjectEdit, LeavesAPictureWhereItLiesOnTheCloth) {
  const project::Project project = after(base(), R"([{"edit": "set_texture", "piece": "front",
      "texture": {"image": "a.png", "scale_mm": 50, "offset": [10, 20], "angle": 5}}])");
  const auto offset = [](const project::Project& p, const char* piece) {
    return named(p.pieces, piece).texture->offset;
  };
  EXPECT_EQ(offset(after(project, R"([{"edit": "move_piece", "piece": "front", "by": [7, -3]}])"), "front"),
            (Vec2{17, 17}));
  const project::Project copied =
      after(project, R"([{"edit": "duplicate_piece", "piece": "front", "id": "copy", "by": [300, 0]}])");
  EXPECT_EQ(offset(copied, "front"), (Vec2{10, 20}));
  EXPECT_EQ(offset(copied, "copy"), (Vec2{310, 20}));
  const project::Project turned = after(project, R"([{"edit": "mirror_piece", "piece": "front"}])");
  EXPECT_EQ(offset(turned, "front"), (Vec2{90, 20})) << "the piece is 100 mm wide";
  EXPECT_EQ(named(turned.pieces, "front").texture->angle, 5);
}

TEST(ProjectEdit, GivesAPieceItsOwnCloth) {
  const project::Project now =
      after(base(), R"([{"edit": "set_physical", "piece": "back", "physical": {"areal_mass_g_m2": 500}}])");
  project::Project cloth = now;
  cloth.bodies.clear();
  const drape::DrapeInput input = resolve::resolve_project(cloth, square_files()).value();
  const auto fabric = [&](std::size_t panel) {
    return input.fabrics[static_cast<std::size_t>(input.fabric_of_panel[panel])];
  };
  EXPECT_NEAR(fabric(1).areal_mass, 0.5, 1e-12);
  EXPECT_NEAR(fabric(1).thickness, fabric(0).thickness, 1e-12);
  EXPECT_NEAR(fabric(0).areal_mass, 0.21, 1e-12);
}

TEST(ProjectEdit, RefusesClothThatWouldGainEnergy) {
  const Error error = refused(
      base(), R"([{"edit": "set_physical", "piece": "back", "physical": {"stretch_coupling_n_m": 9000}}])");
  EXPECT_EQ(error.code, "project.unstable_fabric");
  EXPECT_EQ(error.where, "/edits: /pieces/1/physical/stretch_coupling_n_m");
}

TEST(ProjectEdit, SeamsAndHoldsFollowASplitEdge) {
  const project::Project now = after(
      base(), R"([{"edit": "split_edge", "piece": "front", "edge": "waist", "at": 0.3, "id": "more"}])");
  ASSERT_EQ(named(now.seams, "waist").a.size(), 3u);
  EXPECT_EQ(named(now.seams, "waist").a[1].edge, "more");
  EXPECT_EQ(now.attachments[0].edges, (std::vector<std::string>{"waist", "more"}));
  const project::Project joined =
      after(now, R"([{"edit": "join_edges", "piece": "front", "edge": "waist", "next": "more"}])");
  EXPECT_EQ(joined.attachments[0].edges, (std::vector<std::string>{"waist"}));
  EXPECT_EQ(joined.seams, base().seams);
}

TEST(ProjectEdit, RefusesToJoinAHeldEdgeWithOneThatIsNot) {
  const Error error =
      refused(base(), R"([{"edit": "join_edges", "piece": "front", "edge": "right", "next": "waist"}])");
  EXPECT_EQ(error.code, "edit.in_use");
  EXPECT_EQ(error.where, "/edits/0: attachment hold");
}

TEST(ProjectEdit, EverythingFollowsARenamedPiece) {
  const project::Project now = after(base(), R"([{"edit": "rename_piece", "piece": "front", "to": "fore"},
                                        {"edit": "rename_piece", "piece": "band", "to": "belt"}])");
  EXPECT_TRUE(now.pieces[0].from) << "its shape is the same";
  EXPECT_EQ(now.seams[0].a[0].piece, "fore");
  EXPECT_EQ(now.attachments[0].piece, "fore");
  EXPECT_EQ(now.attachments[1].piece, "belt");
  EXPECT_EQ(now.buttons[0].b.piece, "belt");
  EXPECT_EQ(now.elastics[0].piece, "belt");
  EXPECT_EQ(now.folds[0].piece, "fore");
  EXPECT_EQ(now.cushions[0].pieces, (std::vector<std::string>{"fore", "back"}));
}

TEST(ProjectEdit, WhatIsOnADeletedPieceGoesWithIt) {
  const project::Project now = after(base(), R"([{"edit": "delete_piece", "piece": "front"}])");
  EXPECT_EQ(now.pieces.size(), 2u);
  ASSERT_EQ(now.seams.size(), 1u);
  EXPECT_EQ(now.seams[0].a.size(), 1u);
  ASSERT_EQ(now.attachments.size(), 1u);
  EXPECT_EQ(now.attachments[0].id, "all");
  EXPECT_TRUE(now.folds.empty());
  EXPECT_TRUE(now.cushions.empty());
  EXPECT_EQ(now.buttons.size(), 1u);
  const project::Project less = after(base(), R"([{"edit": "delete_piece", "piece": "band"}])");
  EXPECT_TRUE(less.buttons.empty());
  EXPECT_TRUE(less.elastics.empty());
  EXPECT_EQ(less.attachments.size(), 1u);
}

TEST(ProjectEdit, AFoldGoesWithItsLine) {
  EXPECT_TRUE(after(base(), R"([{"edit": "remove_line", "piece": "front", "line": "pleat"}])").folds.empty());
}

TEST(ProjectEdit, AMovedPieceStaysWhereItStandsInSpace) {
  const std::vector<Vec2> was{{10, 20}, {90, 80}}, now{{35, -10}, {115, 50}};
  for (const char* piece : {"front", "back"}) {
    const std::string edit =
        std::string(R"([{"edit": "move_piece", "piece": ")") + piece + R"(", "by": [25, -30]}])";
    const std::vector<Vec3> before = stands(base(), piece, was),
                            later = stands(after(base(), edit), piece, now);
    ASSERT_EQ(before.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(length(before[i] - later[i]), 1e-9) << piece;
  }
}

TEST(ProjectEdit, ButtonsFollowAPieceThatIsTurnedOver) {
  const project::Project now = after(base(), R"([{"edit": "mirror_piece", "piece": "band"}])");
  EXPECT_EQ(now.buttons[0].a.at, (Vec2{190, 15}));
  EXPECT_EQ(now.buttons[0].b.at, (Vec2{10, 15}));
}

TEST(ProjectEdit, KeepsHolesAndNotchesOfAnEditedPiece) {
  const project::Project now =
      after(base(), R"([{"edit": "move_point", "piece": "back", "edge": "right", "point": 0,
                                        "to": [105, -5]}])");
  const project::ProjectPiece& back = now.pieces[1];
  ASSERT_EQ(back.holes.size(), 1u);
  ASSERT_EQ(back.notches.size(), 1u);
  EXPECT_EQ(back.notches[0].at, (Vec2{105, -5}));
  EXPECT_EQ(back.notches[0].depth_mm, 5);
  const project::Project again =
      after(now, R"([{"edit": "move_point", "piece": "back", "edge": "right", "point": 0,
                                       "to": [100, 0]}])");
  EXPECT_EQ(again.pieces[1].holes, back.holes) << "written and read, a hole stays as it is";
}

TEST(ProjectEdit, DoesAllEditsOrNone) {
  const Error error = refused(base(), R"([{"edit": "rename_piece", "piece": "front", "to": "fore"},
                                          {"edit": "mirror_piece", "piece": "front"}])");
  EXPECT_EQ(error.code, "edit.unknown_piece");
  EXPECT_EQ(error.where, "/edits/1: piece front");
}

TEST(ProjectEdit, TellsWhatIsWrongAndWhere) {
  struct Case {
    const char *edit, *code, *where;
  };
  for (
      const Case& c : {
          Case{R"({})", "edit.unknown", "/edits/0"},
          Case{R"(7)", "edit.unknown", "/edits/0"},
          Case{R"({"edit": 7})", "edit.unknown", "/edits/0/edit"},
          Case{R"({"edit": "move_pint"})", "edit.unknown", "/edits/0/edit"},
          Case{R"({"edit": "mirror_piece"})", "project.missing_key", "/edits/0"},
          Case{R"({"edit": "mirror_piece", "piece": ""})", "project.out_of_range", "/edits/0/piece"},
          Case{R"({"edit": "mirror_piece", "piece": "front", "x": 1})", "project.unknown_key", "/edits/0/x"},
          Case{R"({"edit": "move_piece", "piece": "front", "by": [1]})", "project.wrong_type", "/edits/0/by"},
          Case{R"({"edit": "move_piece", "piece": "front", "by": [1e9, 0]})", "project.out_of_range",
               "/edits/0/by/0"},
          Case{R"({"edit": "set_fabric", "piece": "front", "fabric": "tweed"})", "edit.unknown_fabric",
               "/edits/0"},
          Case{R"({"edit": "set_texture", "piece": "fro"})", "edit.unknown_piece", "/edits/0: piece fro"},
          Case{
              R"({"edit": "set_texture", "piece": "front", "texture": {"image": "../a.png", "scale_mm": 9}})",
              "project.path", "/edits: /pieces/0/texture/image"},
          Case{R"({"edit": "restore", "pieces": {"at": 2, "remove": 2}})", "edit.out_of_range",
               "/edits/0: pieces"},
          Case{R"({"edit": "restore", "pieces": {"at": 0, "remove": 3}})", "project.missing_key", "/edits"},
          Case{R"({"edit": "restore", "seams": {"at": 0, "remove": 0, "insert": [{"id": "side",
                "a": [{"piece": "front", "edge": "hem"}], "b": [{"piece": "back", "edge": "hem"}]}]}})",
               "project.duplicate_id", "/edits: /seams/1/id"},
      }) {
    const Error error = refused(base(), "[" + std::string(c.edit) + "]");
    EXPECT_EQ(error.code, c.code) << c.edit;
    EXPECT_EQ(error.where, c.where) << c.edit;
  }
  EXPECT_EQ(refused(base(), "{}").code, "project.wrong_type");
  std::string many = "[{}";
  for (std::size_t i = 0; i < editing::kMostEdits; ++i) many += ", {}";
  EXPECT_EQ(refused(base(), many + "]").code, "edit.too_many");
}

TEST(ProjectEdit, NoEditsChangeNothing) {
  const Result<editing::EditedProject> out = edited(base(), "[]");
  ASSERT_TRUE(out);
  EXPECT_TRUE(out->inverse.empty());
  EXPECT_EQ(out->project, base());
}

/// Files that count how often each is read. The body is one triangle.
struct CountedFiles {
  int dxf = 0, body = 0;

  resolve::ProjectFiles files() {
    resolve::ProjectFiles files = square_files();
    files.dxf_text = [this, read = files.dxf_text](const std::string& name) {
      ++dxf;
      return read(name);
    };
    files.body_mesh = [this](const std::string&,
                             const mesh_import::MeshSettings&) -> Result<mesh_import::RepairedMesh> {
      ++body;
      return mesh_import::RepairedMesh{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {}};
    };
    return files;
  }
};

Result<editing::EditedProject> edited_with(CountedFiles& counted, const project::Project& project,
                                           const std::string& edits) {
  const json::JsonValue list = TRY(json::parse_json(edits));
  const std::vector<editing::ProjectEdit> read = TRY(editing::read_edits(list, "/edits"));
  return editing::apply_edits(project, read, counted.files());
}

TEST(PatternEdits, ReadAFileOnceThoughTheDocumentIsResolvedBeforeAndAfter) {
  CountedFiles counted;
  const auto out = edited_with(counted, base(), R"([
    {"edit": "rename_edge", "piece": "back", "edge": "hem", "to": "low"},
    {"edit": "restore", "seams": {"at": 0, "remove": 1}},
    {"edit": "move_piece", "piece": "band", "by": [5, 0]}])");
  ASSERT_TRUE(out) << to_string(out.error());
  EXPECT_EQ(counted.dxf, 1);
  EXPECT_EQ(counted.body, 0) << "the bodies are the same";
}

TEST(PatternEdits, ReadABodyOnceWhenBodiesChange) {
  CountedFiles counted;
  const auto out = edited_with(counted, base(), R"([
    {"edit": "restore", "bodies": {"at": 0, "remove": 1, "insert": [
      {"id": "bea", "file": "bea.obj"}, {"id": "bob", "file": "bea.obj", "translation": [3, 0, 0]}]}}])");
  ASSERT_TRUE(out) << to_string(out.error());
  EXPECT_EQ(counted.body, 1);
  EXPECT_EQ(counted.dxf, 1);
}

}  // namespace
}  // namespace toile
