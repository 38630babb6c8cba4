#include "server/documents/projects.h"

#include <gtest/gtest.h>

#include "core/project/project.h"
#include "tests/server/documents/documents_fixture.h"

namespace toile {
namespace {

TEST(Projects, AreKeptUnderTheNameOfTheirDocument) {
  ClothStore cloth;
  const auto made = documents::create_project(cloth.store.documents(), kMe, kClothDocument, cloth.files);
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->name, "Cloth over a post");
  EXPECT_EQ(made->revision, 1);
  cloth.store.reset();
  cloth.store = opened_documents(cloth.folder.path());
  const Result<store::ProjectRow> row = cloth.store->project(kMe, made->id);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->document, kClothDocument);
  EXPECT_EQ(row->files, cloth.files);
}

TEST(Projects, NameTheFilesThatAreMissingAndTheFirstPlace) {
  ClothStore cloth;
  const auto both = documents::create_project(cloth.store.documents(), kMe, kClothDocument, {});
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().code, "documents.missing_file");
  EXPECT_EQ(both.error().where, "/document/pieces/0/from/dxf");
  EXPECT_NE(both.error().message.find("cut/cloth.dxf"), std::string::npos);
  EXPECT_NE(both.error().message.find("post.obj"), std::string::npos);
  const auto one =
      documents::create_project(cloth.store.documents(), kMe, kClothDocument, {{"cut/cloth.dxf", cloth.dxf}});
  ASSERT_FALSE(one);
  EXPECT_EQ(one.error().where, "/document/bodies/0/file");
  EXPECT_TRUE(cloth.store->projects(kMe, "", 10)->empty());
}

TEST(Projects, RefuseAFileOfTheWrongKind) {
  ClothStore cloth;
  const auto made = documents::create_project(cloth.store.documents(), kMe, kClothDocument,
                                              {{"cut/cloth.dxf", cloth.dxf}, {"post.obj", cloth.dxf}});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "documents.wrong_kind");
  EXPECT_EQ(made.error().where, "/document/bodies/0/file");
}

TEST(Projects, TakeAnotherOwnersFileForOneThatIsNotThere) {
  ClothStore cloth;
  const auto made =
      documents::create_project(cloth.store.documents(), kStranger, kClothDocument, cloth.files);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "documents.unknown_asset");
  EXPECT_EQ(made.error().where, "/files/cut~1cloth.dxf");
}

TEST(Projects, CheckFilesThatTheDocumentDoesNotUseYet) {
  ClothStore cloth;
  documents::ProjectFileMap files = cloth.files;
  files["later.dxf"] = cloth.dxf;
  EXPECT_TRUE(documents::create_project(cloth.store.documents(), kMe, kClothDocument, files));
  files["later.dxf"] = "a_00000000000000000000000000000000";
  EXPECT_EQ(code_of(documents::create_project(cloth.store.documents(), kMe, kClothDocument, files)),
            "documents.unknown_asset");
  for (int i = 0; i < 1000; ++i) files["file" + std::to_string(i)] = cloth.dxf;
  EXPECT_EQ(code_of(documents::create_project(cloth.store.documents(), kMe, kClothDocument, files)),
            "documents.too_many_files");
}

TEST(Projects, RefuseADocumentOfWhichNoDrapeCanBeMade) {
  ClothStore cloth;
  const auto refused = [&](const std::string& from, const std::string& to) {
    const auto made =
        documents::create_project(cloth.store.documents(), kMe, cloth_document(from, to), cloth.files);
    return made ? "made" : made.error().code + " at " + made.error().where;
  };
  EXPECT_EQ(refused("\"CLOTH\"", "\"CLOTHES\""), "project.unknown_piece at /document/pieces/0/from/piece");
  EXPECT_EQ(refused("\"fabric\": \"cotton\"", "\"fabric\": \"silk\""),
            "project.unknown_fabric at /document/pieces/0/fabric");
  EXPECT_TRUE(refused("\"toile\": 1,", "\"toile\": 1,,").starts_with("json.syntax at line 2"));
  EXPECT_TRUE(refused("\"seams\": []", "\"seam\": []").starts_with("project."));
  EXPECT_TRUE(
      refused("post.obj", "../post.obj").starts_with("documents.missing_file at /document/bodies/0/file"));
  EXPECT_TRUE(cloth.store->projects(kMe, "", 10)->empty());
}

TEST(Projects, RefuseAFileNameThatLeavesTheProjectEvenWhenItIsMapped) {
  ClothStore cloth;
  documents::ProjectFileMap files = cloth.files;
  files["../post.obj"] = cloth.body;
  const std::string document = cloth_document("post.obj", "../post.obj");
  EXPECT_EQ(code_of(documents::create_project(cloth.store.documents(), kMe, document, files)),
            "project.path");
}

TEST(Projects, TellABadDrawingThatCameAroundTheUpload) {
  ClothStore cloth;
  const Result<store::AssetRow> broken =
      cloth.store->put_asset(kMe, named("dxf", "broken.dxf"), "0\nSECTION\n");
  ASSERT_TRUE(broken);
  documents::ProjectFileMap files = cloth.files;
  files["cut/cloth.dxf"] = broken->id;
  const auto made = documents::create_project(cloth.store.documents(), kMe, kClothDocument, files);
  ASSERT_FALSE(made);
  EXPECT_TRUE(made.error().code.starts_with("dxf.")) << made.error().code;
  EXPECT_TRUE(made.error().where.starts_with("/document/pieces/0/from/dxf")) << made.error().where;
}

TEST(Projects, AreReplacedAtTheExpectedRevisionOnly) {
  ClothStore cloth;
  const store::ProjectRow made =
      *documents::create_project(cloth.store.documents(), kMe, kClothDocument, cloth.files);
  const std::string renamed = cloth_document("Cloth over a post", "Another name");
  const Result<store::ProjectRow> second =
      documents::replace_project(cloth.store.documents(), kMe, made.id, renamed, cloth.files, 1);
  ASSERT_TRUE(second) << to_string(second.error());
  EXPECT_EQ(second->name, "Another name");
  EXPECT_EQ(second->revision, 2);
  EXPECT_EQ(
      code_of(documents::replace_project(cloth.store.documents(), kMe, made.id, renamed, cloth.files, 1)),
      "store.conflict");
  EXPECT_EQ(code_of(documents::replace_project(cloth.store.documents(), kMe, made.id, "{", cloth.files, 2)),
            "json.syntax");
  EXPECT_EQ(cloth.store->project(kMe, made.id)->revision, 2);
  EXPECT_EQ(code_of(documents::replace_project(cloth.store.documents(), kStranger, made.id, kClothDocument,
                                               cloth.files, 2)),
            "store.not_found");
}

TEST(FilesInStore, GiveADrapeItsInput) {
  ClothStore cloth;
  const Result<project::Project> project = project::parse_project(kClothDocument);
  ASSERT_TRUE(project);
  const Result<drape::DrapeInput> input = resolve::resolve_project(
      *project, documents::files_in_store(cloth.store.documents(), kMe, cloth.files));
  ASSERT_TRUE(input) << to_string(input.error());
  ASSERT_EQ(input->bodies.size(), 1u);
  EXPECT_EQ(input->bodies[0].mesh.vertices.size(), 8u);
  EXPECT_EQ(input->bodies[0].mesh.triangles.size(), 12u);
  ASSERT_EQ(input->pattern.panels.size(), 1u);
  EXPECT_EQ(input->pattern.panels[0].outline.edges.size(), 4u);
}

TEST(FilesInStore, RefuseWhatIsMissingOrOfTheWrongKindOrNotTheirs) {
  ClothStore cloth;
  const documents::ProjectFileMap swapped{{"a.dxf", cloth.body}, {"b.obj", cloth.dxf}};
  const resolve::ProjectFiles files = documents::files_in_store(cloth.store.documents(), kMe, swapped);
  EXPECT_EQ(code_of(files.dxf_text("a.dxf")), "documents.wrong_kind");
  EXPECT_EQ(code_of(files.body_mesh("b.obj", {})), "documents.wrong_kind");
  EXPECT_EQ(code_of(files.dxf_text("c.dxf")), "documents.missing_file");
  EXPECT_EQ(code_of(files.body_mesh("c.obj", {})), "documents.missing_file");
  const resolve::ProjectFiles theirs =
      documents::files_in_store(cloth.store.documents(), kStranger, cloth.files);
  EXPECT_EQ(code_of(theirs.dxf_text("cut/cloth.dxf")), "store.not_found");
  EXPECT_EQ(code_of(theirs.body_mesh("post.obj", {})), "store.not_found");
}

}  // namespace
}  // namespace toile
