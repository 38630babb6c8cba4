#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/rules/include_rules.h"

namespace toile::rules {
namespace {

namespace fs = std::filesystem;

bool allowed(const std::string& path, const std::string& include) {
  return check_file(path, "#pragma once\n#include " + include + "\n", false).empty();
}

std::string joined(const Violations& violations) {
  std::string out;
  for (const std::string& violation : violations) out += violation + "\n";
  return out;
}

TEST(IncludeRules, HoldInThisHouse) {
  const Violations violations = check_tree(TOILE_SOURCE_DIR);
  EXPECT_TRUE(violations.empty()) << joined(violations);
}

TEST(IncludeRules, AllowNoArrowRoomOrDoorThatNobodyUses) {
  const Violations unused = unused_arrows(TOILE_SOURCE_DIR);
  EXPECT_TRUE(unused.empty()) << joined(unused);
}

TEST(IncludeRules, FindArrowsThatNobodyUses) {
  const fs::path root = fs::path(testing::TempDir()) / "toile_rules_unused";
  fs::remove_all(root);
  fs::create_directories(root / "core/mesh");
  std::ofstream(root / "core/mesh/mesh.h") << "#pragma once\n#include \"core/pattern/pattern.h\"\n";
  const Violations unused = unused_arrows(root);
  const auto told = [&](const char* what) {
    return std::find(unused.begin(), unused.end(), what) != unused.end();
  };
  EXPECT_FALSE(told("mesh is no room"));
  EXPECT_FALSE(told("mesh never includes pattern"));
  EXPECT_TRUE(told("mesh never includes geometry"));
  EXPECT_TRUE(told("pattern is no room"));
  EXPECT_TRUE(told("assimp never comes through core/body/mesh_import/load."));
  fs::remove_all(root);
}

TEST(IncludeRules, LetARoomIncludeItselfBaseAndWhatTheTableSays) {
  EXPECT_TRUE(allowed("core/mesh/a.h", "\"core/mesh/b.h\""));
  EXPECT_TRUE(allowed("core/mesh/a.h", "\"core/base/types.h\""));
  EXPECT_TRUE(allowed("core/mesh/a.h", "\"core/pattern/pattern.h\""));
  EXPECT_TRUE(allowed("core/mesh/a.h", "<vector>"));
  EXPECT_TRUE(allowed("server/app/a.cpp", "\"core/solver/cloth_solver.h\""));
}

TEST(IncludeRules, CatchAnIncludeAgainstTheTable) {
  EXPECT_FALSE(allowed("core/pattern/a.h", "\"core/mesh/panel_mesh.h\""));
  EXPECT_FALSE(allowed("core/pattern/a.h", "\"core/pattern/dxf/read.h\""));
  EXPECT_FALSE(allowed("core/pattern/dxf/a.h", "\"core/pattern/seams/propose.h\""));
  EXPECT_FALSE(allowed("core/collision/a.cpp", "\"core/solver/cloth_solver.h\""));
  EXPECT_FALSE(allowed("core/drape/a.cpp", "\"server/render/scene.h\""));
  EXPECT_FALSE(allowed("core/base/a.h", "\"core/geometry/triangle_mesh.h\""));
  EXPECT_FALSE(allowed("core/exports/a.cpp", "\"core/project/project.h\""));
  EXPECT_FALSE(allowed("server/jobs/a.cpp", "\"server/ws/hub.h\""));
  EXPECT_FALSE(allowed("core/mesh/a.cpp", "\"server/app/main.h\""));
}

TEST(IncludeRules, CatchAnIncludeInAnyLayoutOfTheLine) {
  EXPECT_FALSE(allowed("core/pattern/a.h", "  \"core/mesh/panel_mesh.h\" // why not"));
  const Violations violations =
      check_file("core/pattern/a.h", "\n  #  include\t\"core/mesh/panel_mesh.h\"\n", false);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0], "core/pattern/a.h:2: core/mesh/panel_mesh.h: pattern may not include mesh");
}

TEST(IncludeRules, CatchAPathThatDoesNotStartAtTheRoot) {
  EXPECT_FALSE(allowed("core/mesh/a.cpp", "\"topology.h\""));
  EXPECT_FALSE(allowed("core/mesh/a.cpp", "\"../pattern/pattern.h\""));
}

TEST(IncludeRules, CatchARoomThatTheTableDoesNotKnow) {
  EXPECT_FALSE(allowed("core/helpers/a.h", "<vector>"));
}

TEST(IncludeRules, KeepEachLibraryBehindItsDoor) {
  EXPECT_TRUE(allowed("core/body/mesh_import/load.cpp", "<assimp/Importer.hpp>"));
  EXPECT_FALSE(allowed("core/body/mannequin/mannequin.cpp", "<assimp/Importer.hpp>"));
  EXPECT_TRUE(allowed("server/render/gl/context.cpp", "<GL/osmesa.h>"));
  EXPECT_FALSE(allowed("server/render/still.cpp", "<GL/osmesa.h>"));
  EXPECT_TRUE(allowed("core/json/tree.cpp", "<nlohmann/json.hpp>"));
  EXPECT_TRUE(allowed("core/exports/write_glb.cpp", "<nlohmann/json.hpp>"));
  EXPECT_FALSE(allowed("core/exports/write_obj.cpp", "<nlohmann/json.hpp>"));
  EXPECT_TRUE(allowed("core/image/read_png.cpp", "<png.h>"));
  EXPECT_TRUE(allowed("core/image/read_jpeg.cpp", "<jpeglib.h>"));
  EXPECT_FALSE(allowed("server/render/png.cpp", "<png.h>"));
  EXPECT_FALSE(allowed("core/drape/pipeline.cpp", "<nlohmann/json_fwd.hpp>"));
  EXPECT_FALSE(allowed("server/http/a.cpp", "<CLI/CLI.hpp>"));
}

TEST(IncludeRules, KeepLibrariesOutOfHeaders) {
  EXPECT_FALSE(allowed("core/body/mesh_import/load.h", "<assimp/scene.h>"));
  EXPECT_FALSE(allowed("core/json/tree.h", "<nlohmann/json_fwd.hpp>"));
}

TEST(IncludeRules, WantAFilesOwnHeaderFirst) {
  EXPECT_FALSE(
      check_file("core/mesh/a.cpp", "#include <vector>\n#include \"core/mesh/a.h\"\n", true).empty());
  EXPECT_TRUE(check_file("core/mesh/a.cpp", "#include \"core/mesh/a.h\"\n#include <vector>\n", true).empty());
  EXPECT_FALSE(check_file("core/mesh/a.cpp", "", true).empty());
}

TEST(IncludeRules, FailForATreeWithOneBadFile) {
  const fs::path root = fs::path(testing::TempDir()) / "toile_rules_house";
  fs::remove_all(root);
  fs::create_directories(root / "core/pattern");
  fs::create_directories(root / "core/mesh");
  std::ofstream(root / "core/mesh/mesh.h") << "#pragma once\n#include \"core/pattern/pattern.h\"\n";
  std::ofstream(root / "core/pattern/pattern.h") << "#pragma once\n";
  EXPECT_EQ(joined(check_tree(root)), "");

  std::ofstream(root / "core/pattern/edit.cpp")
      << "#include \"core/mesh/mesh.h\"\n#include \"core/pattern/lost.h\"\n";
  EXPECT_EQ(joined(check_tree(root)),
            "core/pattern/edit.cpp:1: core/mesh/mesh.h: pattern may not include mesh\n"
            "core/pattern/edit.cpp:2: core/pattern/lost.h is not there\n");
  fs::remove_all(root);
}

}  // namespace
}  // namespace toile::rules
