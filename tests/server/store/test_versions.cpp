// Versions of projects in the store.

#include "server/store/versions.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

/// A store with one project.
struct VersionedStore {
  TemporaryFolder folder;
  std::unique_ptr<store::Store> store = opened(folder.path());
  std::string id = store->create_project(kMe, some_project("Skirt"))->id;

  store::Versions& versions() { return *store::versions_of(*store); }
  store::ProjectRow project() { return *store->project(kMe, id); }
  Result<store::VersionRow> name(const std::string& name, int expected = 0, const std::string& line = "") {
    const store::ProjectRow now = project();
    store::VersionRow row;
    row.project_id = id;
    row.name = name;
    row.revision = now.revision;
    row.document = now.document;
    row.line = line;
    row.files = now.files;
    return versions().add_version(kMe, row, expected);
  }
  void become(const std::string& document, const std::string& dxf = "a_1") {
    store::ProjectRow row = project();
    row.document = document;
    row.files["cut/skirt.dxf"] = dxf;
    ASSERT_TRUE(store->replace_project(kMe, row, 0));
  }
  std::string drape() {
    const store::ProjectRow now = project();
    store::JobRow row = some_job("a drape");
    row.project_id = id;
    row.document = now.document;
    row.files = now.files;
    return store->create_job(kMe, row, "")->id;
  }
  std::vector<store::ToldVersion> told() { return *versions().versions(kMe, id); }
};

TEST(StoreVersions, AreKeptOverAReopening) {
  VersionedStore at;
  const Result<store::VersionRow> made = at.name("with a slit", 1, "{\"toile\":1}");
  ASSERT_TRUE(made) << to_string(made.error());
  at.store.reset();
  at.store = opened(at.folder.path());
  const Result<store::VersionRow> kept = at.versions().version(kMe, at.id, made->id);
  ASSERT_TRUE(kept) << to_string(kept.error());
  EXPECT_EQ(kept->name, "with a slit");
  EXPECT_EQ(kept->revision, 1);
  EXPECT_EQ(kept->document, some_project("").document);
  EXPECT_EQ(kept->line, "{\"toile\":1}");
  EXPECT_EQ(kept->files, some_project("").files);
  EXPECT_GT(kept->created_ms, 0);
}

TEST(StoreVersions, TellWhichDrapesWereMadeOfThem) {
  VersionedStore at;
  ASSERT_TRUE(at.name("first", 0, "one line"));
  const std::string first = at.drape();
  at.become("second");
  ASSERT_TRUE(at.name("second"));
  const std::string second = at.drape();
  at.become("one line");  // the first again, as edits write it
  const std::string again = at.drape();
  const std::vector<store::ToldVersion> told = at.told();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].version.name, "second") << "the newest first";
  EXPECT_EQ(told[0].jobs, std::vector{second});
  EXPECT_FALSE(told[0].current);
  EXPECT_EQ(told[1].jobs, (std::vector{again, first}));
  EXPECT_TRUE(told[1].current);
  at.become("one line", "a_9");  // of another file
  at.drape();
  EXPECT_FALSE(at.told()[1].current);
  EXPECT_EQ(at.told()[1].jobs.size(), 2U);
}

TEST(StoreVersions, RefuseANameThatIsTakenAndARevisionThatIsOld) {
  VersionedStore at;
  ASSERT_TRUE(at.name("first"));
  EXPECT_EQ(code_of(at.name("first")), "versions.taken");
  at.become("second");
  EXPECT_EQ(code_of(at.name("late", 1)), "store.conflict");
  EXPECT_EQ(at.told().size(), 1U);
}

TEST(StoreVersions, AreBounded) {
  VersionedStore at;
  for (int i = 0; i < store::Versions::kMostVersions; ++i)
    ASSERT_TRUE(at.name("version " + std::to_string(i)));
  EXPECT_EQ(code_of(at.name("one more")), "versions.too_many");
  ASSERT_TRUE(at.versions().remove_version(kMe, at.id, at.told().back().version.id));
  EXPECT_TRUE(at.name("one more"));
}

TEST(StoreVersions, CountAmongWhatIsKept) {
  VersionedStore at;
  const std::int64_t before = at.store->usage(kMe)->bytes;
  ASSERT_TRUE(at.name("first", 0, "0123456789"));
  EXPECT_EQ(at.store->usage(kMe)->bytes,
            before + static_cast<std::int64_t>(at.project().document.size()) + 10);
  TemporaryFolder folder;
  at.store = std::move(*sqlite::open_sqlite_store(folder.path(), store::Quotas{.bytes = 20}));
  at.id = at.store->create_project(kMe, some_project("Skirt"))->id;
  EXPECT_EQ(code_of(at.name("too much")), "quota.bytes");
}

TEST(StoreVersions, HoldTheFilesThatTheyName) {
  VersionedStore at;
  const store::AssetRow asset = *at.store->put_asset(kMe, named("dxf", "skirt.dxf"), "0\nEOF\n");
  at.become("second", asset.id);
  ASSERT_TRUE(at.name("with that file"));
  at.become("third");
  EXPECT_EQ(code_of(at.store->remove_asset(kMe, asset.id)), "store.in_use");
  EXPECT_TRUE(at.store->unused_assets(asset.created_ms + 1)->empty());
  ASSERT_TRUE(at.versions().remove_version(kMe, at.id, at.told().front().version.id));
  EXPECT_EQ(at.store->unused_assets(asset.created_ms + 1)->size(), 1U);
  EXPECT_TRUE(at.store->remove_asset(kMe, asset.id));
}

TEST(StoreVersions, AreNobodyElsesAndGoWithTheirProject) {
  VersionedStore at;
  const std::string version = at.name("first")->id;
  EXPECT_EQ(code_of(at.versions().versions(kStranger, at.id)), "store.not_found");
  EXPECT_EQ(code_of(at.versions().version(kStranger, at.id, version)), "store.not_found");
  EXPECT_EQ(code_of(at.versions().remove_version(kStranger, at.id, version)), "store.not_found");
  ASSERT_TRUE(at.store->remove_project(kMe, at.id, 0));
  EXPECT_EQ(code_of(at.versions().version(kMe, at.id, version)), "store.not_found");
}

}  // namespace
}  // namespace toile
