#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/body/mesh_import/formats.h"
#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

TEST(MeshFormats, AreFoundByTheEndingOfANameInCapitalsOrNot) {
  ASSERT_NE(mesh_import::format_of_name("scan.OBJ"), nullptr);
  EXPECT_STREQ(mesh_import::format_of_name("scan.OBJ")->name, "OBJ");
  EXPECT_STREQ(mesh_import::format_of_name("a.b/scan.3ds")->name, "3DS");
  EXPECT_EQ(mesh_import::format_of_name("scan.txt"), nullptr);
  EXPECT_EQ(mesh_import::format_of_name("obj"), nullptr);
}

TEST(MeshFormats, HaveEachAnEndingAndANameOfTheirOwn) {
  std::set<std::string> endings, names;
  for (const mesh_import::MeshFormat& format : mesh_import::mesh_formats()) {
    EXPECT_TRUE(endings.insert(format.ending).second) << format.ending;
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_EQ(mesh_import::format_of_name(std::string("body") + format.ending), &format);
  }
}

TEST(MeshFormats, AreNamedAllWhereAFileIsOfNone) {
  const Result<geometry::TriangleMesh> mesh = mesh_import::load_mesh_bytes("body.txt", "words", {});
  ASSERT_FALSE(mesh.ok());
  for (const mesh_import::MeshFormat& format : mesh_import::mesh_formats())
    EXPECT_NE(mesh.error().message.find(format.name), std::string::npos) << mesh.error().message;
}

TEST(MeshFormats, TellNoFileOfZerosForTheirs) {
  const mesh_import::FileOpening zeros{std::string(200, '\0'), 200};
  for (const mesh_import::MeshFormat& format : mesh_import::mesh_formats())
    EXPECT_FALSE(format.begins(zeros)) << format.name;
}

}  // namespace
}  // namespace toile
