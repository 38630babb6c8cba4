// What owners keep and may keep, what has been kept long enough, and whether it is still what it was.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/base/hash.h"
#include "server/store/sqlite/migrations.h"
#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// A job that has ended at that time, with one result whose row has its hash.
store::JobRow ended_job(store::Store& store, std::int64_t ended_ms, const std::string& bytes = "report") {
  store::JobRow job = *store.create_job(kMe, some_job("old"), "");
  EXPECT_TRUE(store.put_result(kMe, job.id, "report.json", bytes));
  job.state = store::JobState::kSucceeded;
  job.ended_ms = ended_ms;
  job.results["report.json"] = {static_cast<std::int64_t>(bytes.size()), hash_of(std::string_view(bytes))};
  EXPECT_TRUE(test::update_job(store, kMe, job));
  return job;
}

void write_log(store::Store& store, const std::string& job_id) {
  std::ofstream(fs::path(store.log_folder()) / job_id) << "a line\n";
}

TEST(StoreKeeping, AResultThatTheDiskHasChangedIsToldAndNotGivenOut) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::JobRow job = ended_job(*store, 1000);
  EXPECT_EQ(*store->result_bytes(kMe, job.id, "report.json"), "report");
  const std::string path = *store->result_path(kMe, job.id, "report.json");
  std::ofstream(path, std::ios::binary) << "reporT";
  EXPECT_EQ(code_of(store->result_bytes(kMe, job.id, "report.json")), "store.corrupt");
  EXPECT_EQ(code_of(store->result_path(kMe, job.id, "report.json")), "store.corrupt");
  EXPECT_EQ(store->figures().failures.at("store.corrupt"), 2);
}

TEST(StoreKeeping, AResultOfARowFromBeforeThereWereHashesIsGivenOut) {
  const TemporaryFolder folder;
  store::JobRow job;
  {
    const auto store = opened(folder.path());
    job = ended_job(*store, 1000);
  }
  Result<sqlite::SqlDatabase> database = sqlite::SqlDatabase::open(folder.path() + "/toile.db");
  ASSERT_TRUE(database->run("UPDATE jobs SET results = '{\"report.json\": 6}'"));
  const auto store = opened(folder.path());
  EXPECT_EQ(store->job(kMe, job.id)->results, (store::ResultFiles{{"report.json", 6}}));
  EXPECT_EQ(*store->result_bytes(kMe, job.id, "report.json"), "report");
}

TEST(StoreKeeping, UsageCountsUploadsDocumentsAndResultsOfTheOwnerAlone) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  ASSERT_TRUE(store->put_asset(kMe, named("dxf", "a.dxf"), "0123456789"));
  ASSERT_TRUE(store->put_asset(kStranger, named("dxf", "a.dxf"), "0123456789"));
  store::ProjectRow project = *store->create_project(kMe, some_project("skirt"));
  project.document = "{\"toile\": 1, \"name\": \"longer\"}";
  ASSERT_TRUE(store->replace_project(kMe, project, 0));
  const store::JobRow job = ended_job(*store, 1000);
  const store::Usage usage = *store->usage(kMe);
  EXPECT_EQ(usage.bytes, 10 + static_cast<std::int64_t>(project.document.size() + job.document.size()) + 6);
  EXPECT_EQ(usage.assets, 1);
  EXPECT_EQ(usage.projects, 1);
  EXPECT_EQ(usage.jobs, 1);
  EXPECT_EQ(usage.unfinished_jobs, 0);
  ASSERT_TRUE(store->remove_job(kMe, job.id));
  EXPECT_EQ(store->usage(kMe)->bytes, 10 + static_cast<std::int64_t>(project.document.size()));
  EXPECT_EQ(store->usage(kBob)->bytes, 0);
}

TEST(StoreKeeping, WhatAnOlderProgramKeptIsCountedAsWell) {
  const TemporaryFolder folder;
  Result<sqlite::SqlDatabase> database = sqlite::SqlDatabase::open(folder.path() + "/toile.db");
  ASSERT_TRUE(sqlite::migrate(*database, sqlite::migrations().first(4)));
  ASSERT_TRUE(database->run(
      "INSERT INTO jobs (owner, id, project_id, project_revision, name, state, reason_code, reason,"
      " reason_where, attempt, created_ms, started_ms, ended_ms, results, files, report, document)"
      " VALUES ('local', 'j_0', 'p_0', 1, 'a', 'succeeded', '', '', '', 1, 1, 2, 3, '{\"a\": 5, \"b\": 6}',"
      " '{}', '', 'document')"));
  const auto store = opened(folder.path());
  EXPECT_EQ(store->usage(kMe)->bytes, 8 + 11);
}

TEST(StoreKeeping, BeyondTheirBytesOwnersCanOnlyLookAndRemove) {
  const TemporaryFolder folder;
  const auto store = std::move(*sqlite::open_sqlite_store(folder.path(), {.bytes = 100}));
  const store::AssetRow had = *store->put_asset(kMe, named("dxf", "a.dxf"), std::string(90, 'a'));
  EXPECT_EQ(code_of(store->put_asset(kMe, named("dxf", "b.dxf"), std::string(20, 'b'))), "quota.bytes");
  EXPECT_EQ(code_of(store->create_project(kMe, some_project("skirt"))), "quota.bytes");
  EXPECT_EQ(code_of(store->create_job(kMe, some_job("drape"), "")), "quota.bytes");
  EXPECT_EQ(store->create_job(kMe, some_job("drape"), "").error().kind, ErrorKind::kNoRoom);
  EXPECT_TRUE(store->put_asset(kMe, named("dxf", "a.dxf"), std::string(90, 'a'))) << "it is there already";
  EXPECT_TRUE(store->put_asset(kBob, named("dxf", "b.dxf"), std::string(90, 'b'))) << "somebody else's";
  ASSERT_TRUE(store->remove_asset(kMe, had.id));
  EXPECT_TRUE(store->create_project(kMe, some_project("skirt")));
}

TEST(StoreKeeping, ADrapeMayEndBeyondTheBytesThatItsOwnerMayKeep) {
  const TemporaryFolder folder;
  const auto store = std::move(*sqlite::open_sqlite_store(folder.path(), {.bytes = 100}));
  const store::JobRow job = ended_job(*store, 1000, std::string(500, 'r'));
  EXPECT_EQ(store->result_bytes(kMe, job.id, "report.json")->size(), 500u) << "what was draped is not lost";
  EXPECT_EQ(code_of(store->create_job(kMe, some_job("next"), "")), "quota.bytes");
}

TEST(StoreKeeping, OwnersHaveSoManyUnfinishedJobsAndARetryIsNone) {
  const TemporaryFolder folder;
  const auto store = std::move(*sqlite::open_sqlite_store(folder.path(), {.unfinished_jobs = 2}));
  const store::JobRow first = *store->create_job(kMe, some_job("a"), "key");
  ASSERT_TRUE(store->create_job(kMe, some_job("b"), ""));
  EXPECT_EQ(code_of(store->create_job(kMe, some_job("c"), "")), "quota.jobs");
  EXPECT_EQ(store->create_job(kMe, some_job("a"), "key")->id, first.id);
  EXPECT_TRUE(store->create_job(kBob, some_job("c"), ""));
  store::JobRow ended = first;
  ended.state = store::JobState::kCancelled;
  ASSERT_TRUE(test::update_job(*store, kMe, ended));
  EXPECT_TRUE(store->create_job(kMe, some_job("c"), ""));
}

TEST(StoreKeeping, NamesJobsThatEndedLongAgoOldestFirst) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::JobRow newer = ended_job(*store, 2000), older = ended_job(*store, 1000);
  const store::JobRow recent = ended_job(*store, 9000);
  ASSERT_TRUE(store->create_job(kMe, some_job("waits"), ""));
  const std::vector<store::OwnedId> both{{"local", older.id}, {"local", newer.id}};
  EXPECT_EQ(*store->jobs_ended_before(9000, 10), both);
  EXPECT_EQ(store->jobs_ended_before(9000, 1)->size(), 1u);
  EXPECT_EQ(store->jobs_ended_before(9001, 10)->back().id, recent.id);
}

TEST(StoreKeeping, NamesUploadsThatNothingUsesAndNoOthers) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const std::string idle = store->put_asset(kMe, named("dxf", "idle.dxf"), "1")->id;
  const std::string drawn = store->put_asset(kMe, named("dxf", "drawn.dxf"), "2")->id;
  const std::string draped = store->put_asset(kMe, named("body", "draped.obj"), "3")->id;
  store::ProjectRow project = some_project("skirt");
  project.files = {{"drawn.dxf", drawn}};
  ASSERT_TRUE(store->create_project(kMe, project));
  store::JobRow job = some_job("drape");
  job.files = {{"draped.obj", draped}};
  ASSERT_TRUE(store->create_job(kMe, job, ""));
  const std::int64_t later = store->asset(kMe, idle)->created_ms + 60'000;
  EXPECT_EQ(*store->unused_assets(later), (std::vector<store::OwnedId>{{"local", idle}}));
  EXPECT_TRUE(store->unused_assets(store->asset(kMe, idle)->created_ms)->empty()) << "it is not that old";
}

TEST(StoreKeeping, AJobsLogIsItsOwnersAndGoesWithTheJob) {
  const TemporaryFolder folder;
  std::string left;
  {
    const auto store = opened(folder.path());
    const store::JobRow job = ended_job(*store, 1000);
    EXPECT_EQ(*store->job_log(kMe, job.id), "") << "nothing was written";
    write_log(*store, job.id);
    EXPECT_EQ(*store->job_log(kMe, job.id), "a line\n");
    EXPECT_EQ(code_of(store->job_log(kStranger, job.id)), "store.not_found");
    left = (fs::path(store->log_folder()) / job.id).string();
    ASSERT_TRUE(store->remove_job(kMe, job.id));
    EXPECT_FALSE(fs::exists(left));
    write_log(*store, job.id);  // as a crash between row and file would leave it
    ASSERT_TRUE(fs::exists(left));
  }
  opened(folder.path());
  EXPECT_FALSE(fs::exists(left)) << "the next start removes it";
}

TEST(StoreKeeping, KnowsTheRoomOnItsDisk) {
  const TemporaryFolder folder;
  const store::StoreFigures figures = opened(folder.path())->figures();
  EXPECT_TRUE(figures.failures.empty());
  EXPECT_GT(figures.disk_bytes, 0);
  EXPECT_LE(figures.disk_free_bytes, figures.disk_bytes);
}

}  // namespace
}  // namespace toile
