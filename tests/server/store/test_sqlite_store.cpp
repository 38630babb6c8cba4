#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "server/store/store.h"
#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// Bytes with everything that text would stumble over.
std::string odd_bytes() { return std::string("a\0b\r\n\xff'\"", 8); }

TEST(SqliteStore, KeepsAnAssetOverAReopening) {
  const TemporaryFolder folder;
  store::AssetRow given = named("dxf", "Rock blau.DXF");
  given.info = R"({"pieces": []})";
  std::string id;
  {
    const auto store = opened(folder.path());
    const Result<store::AssetRow> kept = store->put_asset(kMe, given, odd_bytes());
    ASSERT_TRUE(kept);
    id = kept->id;
    EXPECT_EQ(kept->size, 8);
    EXPECT_GT(kept->created_ms, 1'735'689'600'000);
  }
  const auto store = opened(folder.path());
  const Result<store::AssetRow> row = store->asset(kMe, id);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->id.size(), 34u);
  EXPECT_EQ(row->kind, "dxf");
  EXPECT_EQ(row->name, "Rock blau.DXF");
  EXPECT_EQ(row->info, given.info);
  EXPECT_EQ(*store->asset_bytes(kMe, id), odd_bytes());
}

TEST(SqliteStore, GivesAPathThatEndsAsTheUploadedNameDoes) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const Result<store::AssetRow> kept = store->put_asset(kMe, named("body", "Ann.OBJ"), "v 0 0 0\n");
  ASSERT_TRUE(kept);
  const Result<std::string> path = store->asset_path(kMe, kept->id);
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->ends_with(".obj")) << *path;
  std::ifstream in(*path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "v 0 0 0\n");
}

TEST(SqliteStore, TakesTheSameFileUnderTheSameNameAndKindForOneAsset) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::AssetRow first = named("body", "a.obj");
  first.info = R"({"first": true})";
  const Result<store::AssetRow> one = store->put_asset(kMe, first, "same");
  const Result<store::AssetRow> again = store->put_asset(kMe, named("body", "a.obj"), "same");
  const Result<store::AssetRow> renamed = store->put_asset(kMe, named("body", "b.obj"), "same");
  const Result<store::AssetRow> changed = store->put_asset(kMe, named("body", "a.obj"), "Same");
  ASSERT_TRUE(one && again && renamed && changed);
  EXPECT_EQ(again->id, one->id);
  EXPECT_EQ(again->info, R"({"first": true})");
  EXPECT_NE(renamed->id, one->id);
  EXPECT_NE(changed->id, one->id);
  EXPECT_EQ(store->assets(kMe, "body")->size(), 3u);
  EXPECT_EQ(store->assets(kMe, "dxf")->size(), 0u);
  EXPECT_EQ(store->assets(kMe, "")->size(), 3u);
  EXPECT_EQ(store->assets(kMe, "")->front().id, changed->id) << "newest first";
}

TEST(SqliteStore, KeepsAProjectOverAReopening) {
  const TemporaryFolder folder;
  store::ProjectRow made;
  {
    const auto store = opened(folder.path());
    made = *store->create_project(kMe, some_project("Skirt \xc3\xa4 \"1\""));
  }
  const auto store = opened(folder.path());
  const Result<store::ProjectRow> row = store->project(kMe, made.id);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->id.size(), 22u);
  EXPECT_EQ(row->name, "Skirt \xc3\xa4 \"1\"");
  EXPECT_EQ(row->revision, 1);
  EXPECT_EQ(row->document, "{\"toile\": 1}");
  EXPECT_EQ(row->files, some_project("").files);
  EXPECT_EQ(row->created_ms, made.created_ms);
  EXPECT_EQ(row->updated_ms, made.updated_ms);
}

TEST(SqliteStore, ReplacesAProjectOnlyAtTheExpectedRevision) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::ProjectRow row = *store->create_project(kMe, some_project("one"));
  row.name = "two";
  row.files = {{"x.dxf", "a_9"}};
  const Result<store::ProjectRow> second = store->replace_project(kMe, row, 1);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->revision, 2);
  row.name = "stale";
  EXPECT_EQ(code_of(store->replace_project(kMe, row, 1)), "store.conflict");
  const Result<store::ProjectRow> now = store->project(kMe, row.id);
  EXPECT_EQ(now->name, "two");
  EXPECT_EQ(now->revision, 2);
  EXPECT_EQ(now->files, (std::map<std::string, std::string>{{"x.dxf", "a_9"}}));
  row.name = "anyway";
  EXPECT_EQ(store->replace_project(kMe, row, 0)->revision, 3);
  row.id = "p_00000000000000000000";
  EXPECT_EQ(code_of(store->replace_project(kMe, row, 0)), "store.not_found");
}

TEST(SqliteStore, ForgetsARemovedProjectAndKeepsItsJobs) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::ProjectRow row = *store->create_project(kMe, some_project("gone"));
  store::JobRow job = some_job("stays");
  job.project_id = row.id;
  job = *store->create_job(kMe, job, "");
  EXPECT_TRUE(store->remove_project(kMe, row.id, 0));
  EXPECT_EQ(code_of(store->project(kMe, row.id)), "store.not_found");
  EXPECT_EQ(code_of(store->remove_project(kMe, row.id, 0)), "store.not_found");
  EXPECT_EQ(store->job(kMe, job.id)->document, job.document);
}

TEST(SqliteStore, ListsNewestFirstPageByPage) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  std::vector<std::string> made, listed;
  for (int i = 0; i < 25; ++i) {
    made.push_back(store->create_project(kMe, some_project(std::to_string(i)))->id);
    ASSERT_TRUE(store->create_job(kMe, some_job(std::to_string(i)), ""));
  }
  std::string cursor;
  for (int page = 0; page < 3; ++page) {
    const Result<std::vector<store::ProjectRow>> rows = store->projects(kMe, cursor, 10);
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), page < 2 ? 10u : 5u);
    for (const store::ProjectRow& row : *rows) listed.push_back(row.id);
    cursor = listed.back();
    EXPECT_TRUE(store->remove_project(kMe, cursor, 0)) << "a cursor may be gone";
  }
  std::reverse(made.begin(), made.end());
  EXPECT_EQ(listed, made);
  EXPECT_TRUE(store->projects(kMe, cursor, 10)->empty());
  const Result<std::vector<store::JobRow>> jobs = store->jobs(kMe, "", 3);
  ASSERT_TRUE(jobs);
  ASSERT_EQ(jobs->size(), 3u);
  EXPECT_EQ(jobs->front().name, "24");
  EXPECT_EQ(jobs->front().document, "");
  EXPECT_EQ(store->jobs(kMe, jobs->back().id, 3)->front().name, "21");
  EXPECT_TRUE(store->jobs(kMe, "", -1)->empty());
}

TEST(SqliteStore, RefusesACursorThatNoListGave) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  for (const char* cursor : {"x", "p_", "j_00000000000000000000", "p_0000000000000000000'", "~"}) {
    EXPECT_EQ(code_of(store->projects(kMe, cursor, 10)), "store.cursor") << cursor;
  }
  EXPECT_EQ(code_of(store->jobs(kMe, "p_00000000000000000000", 10)), "store.cursor");
}

TEST(SqliteStore, KeepsAJobAndWhatBecomesOfItOverAReopening) {
  const TemporaryFolder folder;
  store::JobRow job = some_job("drape");
  {
    const auto store = opened(folder.path());
    job = *store->create_job(kMe, job, "");
    EXPECT_EQ(job.state, store::JobState::kQueued);
    job.state = store::JobState::kFailed;
    job.reason_code = "start.crosses_body";
    job.reason = "The piece begins inside the body.";
    job.reason_where = "/pieces/0";
    job.attempt = 2;
    job.started_ms = job.created_ms + 5;
    job.ended_ms = job.created_ms + 9;
    job.report = R"({"steps": 12})";
    job.notes = {{"stills.not_drawn", "there are \"none\""}};
    job.verdict = store::JobVerdict{true, "settled", "the cloth came to rest", "seam a"};
    job.results = {{"report.json", 13}, {"front.png", std::int64_t{5'000'000'000}}};
    ASSERT_TRUE(test::update_job(*store, kMe, job));
  }
  const auto store = opened(folder.path());
  const Result<store::JobRow> row = store->job(kMe, job.id);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->project_id, job.project_id);
  EXPECT_EQ(row->project_revision, 3);
  EXPECT_EQ(row->name, "drape");
  EXPECT_EQ(row->document, job.document);
  EXPECT_EQ(row->files, job.files);
  EXPECT_EQ(row->state, store::JobState::kFailed);
  EXPECT_EQ(row->reason_code, "start.crosses_body");
  EXPECT_EQ(row->reason, job.reason);
  EXPECT_EQ(row->reason_where, "/pieces/0");
  EXPECT_EQ(row->attempt, 2);
  EXPECT_EQ(row->created_ms, job.created_ms);
  EXPECT_EQ(row->started_ms, job.started_ms);
  EXPECT_EQ(row->ended_ms, job.ended_ms);
  EXPECT_EQ(row->report, job.report);
  EXPECT_EQ(row->results, job.results);
  EXPECT_EQ(row->notes, job.notes);
  EXPECT_EQ(row->verdict, job.verdict);
  EXPECT_EQ(code_of(test::update_job(*store, kMe, some_job("no id"))), "store.not_found");
}

TEST(SqliteStore, NamesTheUnfinishedJobsOfAllOwnersOldestFirst) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  for (const auto& [owner, state] :
       std::vector<std::pair<std::string, store::JobState>>{{"b", store::JobState::kRunning},
                                                            {"a", store::JobState::kSucceeded},
                                                            {"a", store::JobState::kPaused},
                                                            {"b", store::JobState::kCancelled},
                                                            {"b", store::JobState::kFailed},
                                                            {"a", store::JobState::kQueued}}) {
    const store::RequestContext whose(owner);
    store::JobRow job = *store->create_job(whose, some_job(std::string(store::name_of(state))), "");
    job.state = state;
    ASSERT_TRUE(test::update_job(*store, whose, job));
  }
  const Result<std::vector<store::Store::OwnedJob>> unfinished = store->unfinished_jobs();
  ASSERT_TRUE(unfinished);
  ASSERT_EQ(unfinished->size(), 3u);
  EXPECT_EQ(unfinished->at(0).owner, "b");
  EXPECT_EQ(unfinished->at(0).job.name, "running");
  EXPECT_EQ(unfinished->at(1).job.name, "paused");
  EXPECT_EQ(unfinished->at(2).owner, "a");
  EXPECT_EQ(unfinished->at(2).job.name, "queued");
  EXPECT_EQ(unfinished->at(2).job.document, "") << "whoever drapes it reads that";
}

TEST(SqliteStore, MakesOneJobOfOneIdempotencyKey) {
  const TemporaryFolder folder;
  std::string id;
  {
    const auto store = opened(folder.path());
    id = store->create_job(kMe, some_job("once"), "key-1")->id;
    EXPECT_EQ(store->create_job(kMe, some_job("twice"), "key-1")->id, id);
  }
  const auto store = opened(folder.path());
  const auto again = store->create_job(kMe, some_job("thrice"), "key-1");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->id, id);
  EXPECT_EQ(again->name, "once");
  EXPECT_NE(store->create_job(kMe, some_job("other"), "key-2")->id, id);
  EXPECT_NE(store->create_job(kStranger, some_job("theirs"), "key-1")->id, id);
  EXPECT_NE(store->create_job(kMe, some_job("none"), "")->id,
            store->create_job(kMe, some_job("none"), "")->id);
  EXPECT_EQ(store->jobs(kMe, "", 100)->size(), 4u);
}

TEST(SqliteStore, RefusesAnIdempotencyKeyForAnotherProject) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const auto once = store->create_job(kMe, some_job("once"), "key");
  ASSERT_TRUE(once && once->anew);
  store::JobRow revised = some_job("revised"), other = some_job("other");
  revised.project_revision += 1;
  other.project_id = "p_00000000000000000001";
  const auto retried = store->create_job(kMe, revised, "key");
  ASSERT_TRUE(retried) << "a retry may come after the project was changed";
  EXPECT_EQ(retried->id, once->id);
  EXPECT_FALSE(retried->anew);
  EXPECT_EQ((*store->job_of_key(kMe, "key"))->id, once->id);
  EXPECT_FALSE(store->job_of_key(kMe, "other")->has_value());
  EXPECT_FALSE(store->job_of_key(kMe, "")->has_value());
  EXPECT_FALSE(store->job_of_key(kStranger, "key")->has_value());
  EXPECT_EQ(code_of(store->create_job(kMe, other, "key")), "store.idempotency_mismatch");
  EXPECT_EQ(store->jobs(kMe, "", 100)->size(), 1u);
  for (const std::string& key : {std::string("two words"), std::string("\n"), std::string(201, 'k')}) {
    EXPECT_EQ(code_of(store->create_job(kMe, other, key)), "store.idempotency_key");
    EXPECT_EQ(code_of(store->job_of_key(kMe, key)), "store.idempotency_key");
    EXPECT_EQ(code_of(store->create_project(kMe, some_project("a"), key)), "store.idempotency_key");
  }
}

TEST(SqliteStore, MakesOneProjectOfOneIdempotencyKey) {
  const TemporaryFolder folder;
  std::string id;
  {
    const auto store = opened(folder.path());
    const auto once = store->create_project(kMe, some_project("once"), "key");
    ASSERT_TRUE(once && once->anew);
    id = once->id;
  }
  const auto store = opened(folder.path());
  const auto again = store->create_project(kMe, some_project("once"), "key");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->id, id);
  EXPECT_FALSE(again->anew);
  store::ProjectRow other = some_project("once");
  other.files["body.obj"] = "a_9";
  EXPECT_EQ(code_of(store->create_project(kMe, other, "key")), "store.idempotency_mismatch");
  EXPECT_NE(store->create_project(kStranger, other, "key")->id, id);
  EXPECT_TRUE(store->remove_project(kMe, id, 0));
  EXPECT_TRUE(store->create_project(kMe, other, "key")->anew) << "its key is free again";
}

TEST(SqliteStore, RemovesAProjectOnlyAtTheExpectedRevision) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::ProjectRow row = *store->create_project(kMe, some_project("one"));
  ASSERT_TRUE(store->replace_project(kMe, row, 1));
  EXPECT_EQ(code_of(store->remove_project(kMe, row.id, 1)), "store.conflict");
  EXPECT_TRUE(store->project(kMe, row.id));
  EXPECT_TRUE(store->remove_project(kMe, row.id, 2));
  EXPECT_EQ(code_of(store->remove_project(kMe, row.id, 2)), "store.not_found");
}

TEST(SqliteStore, FindsNothingForAnotherOwner) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::AssetRow asset = *store->put_asset(kMe, named("dxf", "a.dxf"), "mine");
  const store::ProjectRow project = *store->create_project(kMe, some_project("mine"));
  const store::JobRow job = *store->create_job(kMe, some_job("mine"), "");
  ASSERT_TRUE(store->put_result(kMe, job.id, "front.png", "png"));
  ASSERT_TRUE(store->put_setting(kMe, "key", "mine"));

  EXPECT_EQ(code_of(store->asset(kStranger, asset.id)), "store.not_found");
  EXPECT_EQ(code_of(store->asset_bytes(kStranger, asset.id)), "store.not_found");
  EXPECT_EQ(code_of(store->asset_path(kStranger, asset.id)), "store.not_found");
  EXPECT_TRUE(store->assets(kStranger, "")->empty());
  EXPECT_EQ(code_of(store->project(kStranger, project.id)), "store.not_found");
  EXPECT_EQ(code_of(store->replace_project(kStranger, project, 0)), "store.not_found");
  EXPECT_EQ(code_of(store->remove_project(kStranger, project.id, 0)), "store.not_found");
  EXPECT_TRUE(store->projects(kStranger, "", 10)->empty());
  EXPECT_EQ(code_of(store->job(kStranger, job.id)), "store.not_found");
  EXPECT_EQ(code_of(test::update_job(*store, kStranger, job)), "store.not_found");
  EXPECT_TRUE(store->jobs(kStranger, "", 10)->empty());
  EXPECT_EQ(code_of(store->put_result(kStranger, job.id, "front.png", "theirs")), "store.not_found");
  EXPECT_EQ(code_of(store->result_bytes(kStranger, job.id, "front.png")), "store.not_found");
  EXPECT_FALSE(store->get_setting(kStranger, "key")->has_value());
  EXPECT_EQ(*store->result_bytes(kMe, job.id, "front.png"), "png");
}

TEST(SqliteStore, KeepsResultsAndReplacesThem) {
  const TemporaryFolder folder;
  std::string id;
  {
    const auto store = opened(folder.path());
    store::JobRow job = *store->create_job(kMe, some_job("drape"), "");
    id = job.id;
    ASSERT_TRUE(store->put_result(kMe, id, "report.json", "first"));
    ASSERT_TRUE(store->put_result(kMe, id, "report.json", odd_bytes()));
    ASSERT_TRUE(store->put_result(kMe, id, "empty", ""));
    job.results = {{"report.json", 8}, {"empty", 0}};
    ASSERT_TRUE(test::update_job(*store, kMe, job));
  }
  const auto store = opened(folder.path());
  EXPECT_EQ(*store->result_bytes(kMe, id, "report.json"), odd_bytes());
  EXPECT_EQ(*store->result_bytes(kMe, id, "empty"), "");
  EXPECT_EQ(code_of(store->result_bytes(kMe, id, "absent")), "store.not_found");
}

TEST(SqliteStore, RefusesNamesThatLeaveTheirFolder) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const std::string id = store->create_job(kMe, some_job("drape"), "")->id;
  for (const std::string& name :
       {std::string(), std::string("."), std::string(".."), std::string("../toile.db"), std::string("a/b"),
        std::string("/etc/passwd"), std::string("..\\x"), std::string("a\\b"), std::string(".hidden"),
        std::string("a\nb"), std::string("a\0b", 3), std::string("a\x7f"), std::string("\xff\xfe"),
        std::string("\xc0\xae\xc0\xae/"), std::string(256, 'n')}) {
    EXPECT_EQ(code_of(store->put_result(kMe, id, name, "x")), "store.bad_name") << name;
    EXPECT_EQ(code_of(store->result_bytes(kMe, id, name)), "store.bad_name") << name;
    EXPECT_EQ(code_of(store->put_asset(kMe, named("dxf", name), "x")), "store.bad_name") << name;
  }
  for (const char* job : {"..", "../blobs", "j_/../../../..", ""}) {
    EXPECT_EQ(code_of(store->put_result(kMe, job, "toile.db", "x")), "store.not_found") << job;
    EXPECT_EQ(code_of(store->result_bytes(kMe, job, "toile.db")), "store.not_found") << job;
  }
  EXPECT_TRUE(store->put_result(kMe, id, "Vorderansicht \xc3\xbc 1..2.png", "x"));
}

TEST(SqliteStore, RemembersSettings) {
  const TemporaryFolder folder;
  {
    const auto store = opened(folder.path());
    EXPECT_FALSE(store->get_setting(kMe, "sample")->has_value());
    ASSERT_TRUE(store->put_setting(kMe, "sample", "one"));
    ASSERT_TRUE(store->put_setting(kMe, "sample", "two"));
  }
  EXPECT_EQ(opened(folder.path())->get_setting(kMe, "sample")->value(), "two");
}

TEST(SqliteStore, TreatsTextAsTextAndNotAsSql) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const std::string evil = "'; DROP TABLE projects; --";
  const store::ProjectRow row = *store->create_project(store::RequestContext(evil), some_project(evil));
  EXPECT_EQ(store->project(store::RequestContext(evil), row.id)->name, evil);
  EXPECT_EQ(code_of(store->project(kMe, "' OR '1'='1")), "store.not_found");
}

TEST(SqliteStore, TellsWhenAFileHasChangedOrGone) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::AssetRow asset = *store->put_asset(kMe, named("dxf", "a.dxf"), "content");
  const std::string path = *store->asset_path(kMe, asset.id);
  std::ofstream(path, std::ios::binary) << "CONTENT";
  EXPECT_EQ(code_of(store->asset_bytes(kMe, asset.id)), "store.corrupt");
  std::ofstream(path, std::ios::binary) << "cont";
  EXPECT_EQ(code_of(store->asset_path(kMe, asset.id)), "store.corrupt");
  fs::remove(path);
  EXPECT_EQ(code_of(store->asset_bytes(kMe, asset.id)), "store.corrupt");
  ASSERT_TRUE(store->put_asset(kMe, named("dxf", "a.dxf"), "content"));
  EXPECT_EQ(*store->asset_bytes(kMe, asset.id), "content") << "uploading it again heals";
}

TEST(SqliteStore, AnswersAPing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(opened(folder.path())->ping());
}

TEST(SqliteStore, HasItsFolderForItself) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const Result<std::unique_ptr<store::Store>> second = sqlite::open_sqlite_store(folder.path());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, "store.in_use");
  EXPECT_NE(second.error().where.find(folder.path()), std::string::npos);
}

TEST(SqliteStore, SaysWhereItCannotBeOpened) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/file") << "in the way";
  const Result<std::unique_ptr<store::Store>> in_file = sqlite::open_sqlite_store(folder.path() + "/file");
  ASSERT_FALSE(in_file);
  EXPECT_EQ(in_file.error().code, "store.open");
  EXPECT_NE(in_file.error().where.find("file"), std::string::npos);
  std::ofstream(folder.path() + "/toile.db") << "this is no database, whatever it may be called, not at all";
  const Result<std::unique_ptr<store::Store>> no_database = sqlite::open_sqlite_store(folder.path());
  ASSERT_FALSE(no_database);
  EXPECT_EQ(no_database.error().code, "store.open");
  EXPECT_NE(no_database.error().where.find("toile.db"), std::string::npos);
}

TEST(SqliteStore, RemovesWhatACrashLeftInItsScratchFolder) {
  const TemporaryFolder folder;
  const std::string scratch = opened(folder.path())->scratch_folder();
  std::ofstream(scratch + "/half") << "written";
  const auto store = opened(folder.path());
  EXPECT_EQ(store->scratch_folder(), scratch);
  EXPECT_TRUE(fs::is_directory(scratch));
  EXPECT_TRUE(fs::is_empty(scratch));
}

}  // namespace
}  // namespace toile
