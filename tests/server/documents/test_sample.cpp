#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/project/project.h"
#include "tests/server/documents/documents_fixture.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

const fs::path kSkirt = fs::path(TOILE_SOURCE_DIR) / "samples" / "skirt";

/// The ids of all projects there are.
std::vector<std::string> ids_in(const OpenedDocuments& store) {
  std::vector<std::string> ids;
  const Result<std::vector<store::ProjectRow>> rows = store->projects(kMe, "", 100);
  for (const store::ProjectRow& row : *rows) ids.push_back(row.id);
  return ids;
}

TEST(Sample, IsThereAfterTheFirstStartAndOnlyOnce) {
  const TemporaryFolder folder;
  {
    const auto store = opened_documents(folder.path());
    const Status added = documents::add_sample_project(store.documents(), kMe, kSkirt);
    ASSERT_TRUE(added) << to_string(added.error());
  }
  const auto store = opened_documents(folder.path());
  ASSERT_TRUE(documents::add_sample_project(store.documents(), kMe, kSkirt));
  const std::vector<std::string> ids = ids_in(store);
  ASSERT_EQ(ids.size(), 1u);
  EXPECT_EQ(store->get_setting(kMe, documents::kSampleSetting)->value(), ids[0]);
  const store::ProjectRow row = *store->project(kMe, ids[0]);
  const Result<project::Project> project = project::parse_project(row.document);
  ASSERT_TRUE(project);
  EXPECT_EQ(row.name, project->name);
  const Result<drape::DrapeInput> input =
      resolve::resolve_project(*project, documents::files_in_store(store.documents(), kMe, row.files));
  ASSERT_TRUE(input) << to_string(input.error());
  EXPECT_GE(input->pattern.panels.size(), 2u);
  EXPECT_EQ(input->bodies.size(), 1u);
}

TEST(Sample, DoesNotComeBackOnceItIsDeleted) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  ASSERT_TRUE(documents::add_sample_project(store.documents(), kMe, kSkirt));
  ASSERT_TRUE(store->remove_project(kMe, ids_in(store).front(), 0));
  ASSERT_TRUE(documents::add_sample_project(store.documents(), kMe, kSkirt));
  EXPECT_TRUE(ids_in(store).empty());
}

TEST(Sample, IsNotAddedTwiceWhenTheFirstStartWasCutOff) {
  ClothStore cloth;
  std::ofstream(cloth.folder.path() + "/project.json") << kClothDocument;
  const store::ProjectRow made =
      *documents::create_project(cloth.store.documents(), kMe, kClothDocument, cloth.files);
  ASSERT_TRUE(documents::add_sample_project(cloth.store.documents(), kMe, cloth.folder.path()));
  EXPECT_EQ(ids_in(cloth.store), std::vector<std::string>{made.id});
  EXPECT_EQ(cloth.store->get_setting(kMe, documents::kSampleSetting)->value(), made.id);
}

TEST(Sample, IsTriedAgainWhenItsFolderWasNotThere) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  EXPECT_EQ(code_of(documents::add_sample_project(store.documents(), kMe, folder.path() + "/absent")),
            "project.file");
  ASSERT_TRUE(documents::add_sample_project(store.documents(), kMe, kSkirt));
  EXPECT_EQ(ids_in(store).size(), 1u);
}

}  // namespace
}  // namespace toile
