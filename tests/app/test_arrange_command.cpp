#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/json/tree.h"
#include "core/project/project.h"
#include "tests/app/program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// The sample, its pieces and holds where a newcomer's would be: all in one place, none held.
fs::path unplaced_sample(const std::string& name) {
  const fs::path folder = fresh_folder(name), sample = fs::path(TOILE_SOURCE_DIR) / "samples/skirt";
  for (const char* file : {"body.obj", "skirt.dxf"}) fs::copy_file(sample / file, folder / file);
  project::Project project = project::parse_project(text_of(sample / "project.json")).value();
  for (project::ProjectPiece& piece : project.pieces) piece.placement = {.rigid = project::ProjectRigid{}};
  project.attachments.clear();
  project.settings.particle_distance_mm = 25;
  write_text(folder / "project.json", project::write_project(project));
  return folder;
}

TEST(ArrangeCommand, PlacesAllPiecesHoldsTheWaistAndTellsWhatItDid) {
  const fs::path folder = unplaced_sample("toile_arrange");
  const std::string before = text_of(folder / "project.json");
  const Ran run =
      run_toile({"project", "arrange", folder / "project.json", "--out", folder / "a.json", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto tree = json::parse_json(run.out);
  ASSERT_TRUE(tree) << run.out;
  EXPECT_FALSE(tree->find("holds")->array()->empty());
  for (const json::JsonValue& finding : *tree->find("findings")->array()) {
    EXPECT_NE(*finding.find("severity")->text(), "error") << run.out;
  }
  const project::Project made = project::parse_project(text_of(folder / "a.json")).value();
  EXPECT_EQ(tree->find("pieces")->array()->size(), made.pieces.size());
  EXPECT_EQ(made.attachments.size(), tree->find("holds")->array()->size());
  bool front = false, back = false;
  for (const project::ProjectPiece& piece : made.pieces) {
    ASSERT_TRUE(piece.placement.rigid) << piece.id;
    front |= piece.placement.rigid->translation.z > 0.05;
    back |= piece.placement.rigid->translation.z < -0.05;
  }
  EXPECT_TRUE(front && back);
  EXPECT_EQ(text_of(folder / "project.json"), before) << "with --out the document itself stays";
  EXPECT_EQ(run_toile({"check", folder / "a.json"}).code, 0);
}

TEST(ArrangeCommand, WritesBoxesThatPutThePiecesInTheSamePlaces) {
  const fs::path folder = unplaced_sample("toile_arrange_boxes");
  ASSERT_EQ(run_toile({"project", "arrange", folder / "project.json", "--out", folder / "m.json"}).code, 0);
  const Ran run =
      run_toile({"project", "arrange", folder / "project.json", "--out", folder / "b.json", "--as", "box"});
  ASSERT_EQ(run.code, 0) << run.err;
  const project::Project told = project::parse_project(text_of(folder / "b.json")).value();
  for (const project::ProjectPiece& piece : told.pieces) EXPECT_TRUE(piece.placement.on_box) << piece.id;
  const Ran by_box = run_toile({"check", folder / "b.json"});
  EXPECT_EQ(by_box.code, 0) << by_box.err;
  EXPECT_EQ(run_toile({"project", "arrange", folder / "b.json", "--out", folder / "again.json"}).code, 0)
      << "boxes are no hindrance to arranging anew";
  EXPECT_EQ(text_of(folder / "again.json"), text_of(folder / "m.json"));
}

TEST(ArrangeCommand, RefusesWhatItCannotDressInWords) {
  const fs::path folder = unplaced_sample("toile_arrange_bad");
  project::Project project = project::parse_project(text_of(folder / "project.json")).value();
  project.bodies.clear();
  write_text(folder / "nobody.json", project::write_project(project));
  const Ran nobody = run_toile({"project", "arrange", folder / "nobody.json"});
  EXPECT_EQ(nobody.code, 2);
  EXPECT_NE(nobody.err.find("arrange.no_body"), std::string::npos) << nobody.err;
  EXPECT_EQ(run_toile({"project", "arrange", folder / "none.json"}).code, 2);
  EXPECT_EQ(run_toile({"project", "arrange", folder / "project.json", "--as", "sphere"}).code, 2);
}

}  // namespace
}  // namespace toile
