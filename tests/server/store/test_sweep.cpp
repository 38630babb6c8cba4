// What a start of the store removes, and what it leaves alone.

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// Paths of all files below a part of the store, from the store's folder.
std::set<std::string> files_in(const std::string& folder, const char* part) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(folder) / part)) {
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
  }
  return files;
}

void put_file(const fs::path& path) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "left behind";
}

/// A job in the state, of which `kept` are result files and `named` those that its row names.
store::JobRow job_with(store::Store& store, store::JobState state, const std::vector<std::string>& kept,
                       const std::vector<std::string>& named) {
  store::JobRow job = *store.create_job(kMe, some_job(std::string(store::name_of(state))), "");
  for (const std::string& name : kept) EXPECT_TRUE(store.put_result(kMe, job.id, name, "bytes"));
  job.state = state;
  for (const std::string& name : named) job.results[name] = 5;
  EXPECT_TRUE(test::update_job(store, kMe, job));
  return job;
}

TEST(StoreSweep, RemovesBlobsThatNoAssetNamesAndNoOthers) {
  const TemporaryFolder folder;
  std::string id;
  std::set<std::string> named;
  {
    const auto store = opened(folder.path());
    id = store->put_asset(kMe, toile::named("dxf", "a.dxf"), "content")->id;
    ASSERT_TRUE(store->put_asset(kStranger, toile::named("body", "b.obj"), "theirs"));
    named = files_in(folder.path(), "blobs");
  }
  ASSERT_EQ(named.size(), 2u);
  const std::string hash = "0123456789abcdef0123456789abcdef";
  put_file(fs::path(folder.path()) / "blobs" / "01" / (hash + ".dxf"));
  const std::set<std::string> strange{"blobs/01/notes.txt", "blobs/77/" + hash + ".dxf", "blobs/readme"};
  for (const std::string& path : strange) put_file(fs::path(folder.path()) / path);
  const auto store = opened(folder.path());
  named.insert(strange.begin(), strange.end());
  EXPECT_EQ(files_in(folder.path(), "blobs"), named) << "what the store never wrote stays";
  EXPECT_EQ(*store->asset_bytes(kMe, id), "content");
}

TEST(StoreSweep, RemovesResultsThatNoJobNamesAndNoOthers) {
  const TemporaryFolder folder;
  std::string done, cancelled, cut_off;
  {
    const auto store = opened(folder.path());
    done = job_with(*store, store::JobState::kSucceeded, {"report.json", "front.png", "late.png"},
                    {"report.json", "front.png"})
               .id;
    cancelled = job_with(*store, store::JobState::kCancelled, {"report.json"}, {}).id;
    cut_off = job_with(*store, store::JobState::kRunning, {"report.json", "front.png"}, {}).id;
  }
  put_file(fs::path(folder.path()) / "results" / "j_0000000000000000000a" / "report.json");
  put_file(fs::path(folder.path()) / "results" / "mine" / "notes.txt");
  const auto store = opened(folder.path());
  EXPECT_EQ(files_in(folder.path(), "results"),
            (std::set<std::string>{"results/" + done + "/front.png", "results/" + done + "/report.json",
                                   "results/mine/notes.txt"}));
  EXPECT_EQ(*store->result_bytes(kMe, done, "front.png"), "bytes");
}

TEST(StoreSweep, RemovesNothingWhenTheDatabaseIsNew) {
  const TemporaryFolder folder;
  std::set<std::string> blobs, results;
  {
    const auto store = opened(folder.path());
    ASSERT_TRUE(store->put_asset(kMe, toile::named("dxf", "a.dxf"), "content"));
    job_with(*store, store::JobState::kSucceeded, {"report.json"}, {"report.json"});
    blobs = files_in(folder.path(), "blobs");
    results = files_in(folder.path(), "results");
  }
  for (const char* name : {"toile.db", "toile.db-wal", "toile.db-shm"})
    fs::remove(fs::path(folder.path()) / name);
  const auto store = opened(folder.path());
  EXPECT_EQ(files_in(folder.path(), "blobs"), blobs) << "a lost database must not take the files with it";
  EXPECT_EQ(files_in(folder.path(), "results"), results);
}

TEST(StoreSweep, RemovesTheResultsOfOneJobOnRequest) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const std::string id = job_with(*store, store::JobState::kCancelled, {"report.json"}, {}).id;
  const std::string other =
      job_with(*store, store::JobState::kSucceeded, {"report.json"}, {"report.json"}).id;
  EXPECT_EQ(code_of(store->remove_results(kStranger, id)), "store.not_found");
  EXPECT_TRUE(store->remove_results(kMe, id));
  EXPECT_TRUE(store->remove_results(kMe, id)) << "twice is no error";
  EXPECT_EQ(files_in(folder.path(), "results"), (std::set<std::string>{"results/" + other + "/report.json"}));
}

}  // namespace
}  // namespace toile
