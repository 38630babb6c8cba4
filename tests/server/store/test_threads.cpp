#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

constexpr int kThreads = 8;

template <typename Work>
void on_threads(Work work) {
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(work, i);
  for (std::thread& thread : threads) thread.join();
}

TEST(StoreThreads, GiveEachJobItsOwnIdAndLoseNone) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  constexpr int kEach = 10;
  std::atomic<int> faults{0};
  on_threads([&](int thread) {
    for (int i = 0; i < kEach; ++i) {
      const std::string content = "the same file of all threads, number " + std::to_string(i);
      const Result<store::AssetRow> asset = store->put_asset(kMe, named("dxf", "a.dxf"), content);
      auto job = store->create_job(kMe, some_job(std::to_string(thread)), "");
      if (!asset || !job) {
        ++faults;
        continue;
      }
      job->state = store::JobState::kRunning;
      if (!test::update_job(*store, kMe, *job)) ++faults;
      if (!store->put_result(kMe, job->id, "r", job->id)) ++faults;
      if (store->asset_bytes(kMe, asset->id).value() != content) ++faults;
      if (!store->jobs(kMe, "", 5) || !store->unfinished_jobs()) ++faults;
    }
  });
  EXPECT_EQ(faults, 0);
  std::set<std::string> ids;
  const Result<std::vector<store::JobRow>> jobs = store->jobs(kMe, "", 1000);
  for (const store::JobRow& job : *jobs) ids.insert(job.id);
  EXPECT_EQ(ids.size(), static_cast<std::size_t>(kThreads * kEach));
  EXPECT_EQ(store->assets(kMe, "dxf")->size(), static_cast<std::size_t>(kEach));
}

TEST(StoreThreads, LetOneOfManyReplaceARevision) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const store::ProjectRow row = *store->create_project(kMe, some_project("one"));
  std::atomic<int> won{0}, conflicts{0};
  on_threads([&](int thread) {
    store::ProjectRow mine = row;
    mine.name = std::to_string(thread);
    const std::string code = code_of(store->replace_project(kMe, mine, 1));
    if (code == "ok") ++won;
    if (code == "store.conflict") ++conflicts;
  });
  EXPECT_EQ(won, 1);
  EXPECT_EQ(conflicts, kThreads - 1);
  EXPECT_EQ(store->project(kMe, row.id)->revision, 2);
}

TEST(StoreThreads, MakeOneJobOfOneIdempotencyKey) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  std::vector<std::string> ids(kThreads);
  on_threads([&](int thread) {
    const auto job = store->create_job(kMe, some_job("drape"), "key");
    if (job) ids[static_cast<std::size_t>(thread)] = job->id;
  });
  for (const std::string& id : ids) EXPECT_EQ(id, ids[0]);
  EXPECT_EQ(store->jobs(kMe, "", 100)->size(), 1u);
}

}  // namespace
}  // namespace toile
