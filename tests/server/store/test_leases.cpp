// Who works on a job, as the store keeps it.

#include <map>

#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

using store::JobState;
constexpr std::int64_t kFarOff = std::int64_t{1} << 60;

class StoreLeases : public testing::Test {
 protected:
  /// A running job that somebody holds.
  std::string held(const std::string& holder, std::int64_t until_ms = kFarOff) {
    const std::string id = store->create_job(kMe, some_job("job"), "")->id;
    const auto kept = store->change_job(kMe, id, [&](store::JobRow& row) -> Status {
      row.state = JobState::kRunning;
      row.started_ms = 1;
      row.lease = {holder, 3, until_ms};
      return {};
    });
    EXPECT_TRUE(kept);
    return id;
  }
  /// Ids of those that are judged, each with how many its holder had running.
  std::vector<std::pair<std::string, int>> judged(std::int64_t now_ms, bool own = false) {
    std::vector<std::pair<std::string, int>> found;
    const auto left = store->take_from_the_gone(now_ms, own, [&](store::Store::LeftJob& one) {
      found.emplace_back(one.owned.job.id, one.running);
      one.owned.job.state = JobState::kQueued;
    });
    EXPECT_TRUE(left);
    return found;
  }
  static store::RequestContext under(std::int64_t lease) {
    store::RequestContext context = kMe;
    context.lease = lease;
    return context;
  }

  TemporaryFolder folder;
  std::unique_ptr<store::Store> store = opened(folder.path());
};

TEST_F(StoreLeases, AreKept) {
  const std::string id = held("h_somebody");
  EXPECT_EQ(store->job(kMe, id)->lease, (store::JobLease{"h_somebody", 3, kFarOff}));
  store.reset();
  store = opened(folder.path());
  EXPECT_EQ(store->job(kMe, id)->lease.number, 3);
}

TEST_F(StoreLeases, FenceWhatIsDoneUnderAnOlderNumber) {
  const std::string id = held("h_somebody");
  const auto nothing = [](store::JobRow&) -> Status { return {}; };
  EXPECT_TRUE(store->change_job(under(3), id, nothing));
  EXPECT_EQ(code_of(store->change_job(under(2), id, nothing)), "store.lease_lost");
  EXPECT_TRUE(store->put_result(under(3), id, "a", "new"));
  EXPECT_EQ(code_of(store->put_result(under(2), id, "a", "old")), "store.lease_lost");
  EXPECT_EQ(*store->result_bytes(kMe, id, "a"), "new");
  EXPECT_TRUE(store->put_checkpoint(under(3), id, "new"));
  EXPECT_EQ(code_of(store->put_checkpoint(under(2), id, "old")), "store.lease_lost");
  EXPECT_EQ(store->checkpoint(kMe, id)->bytes, "new");
}

TEST_F(StoreLeases, PutNothingForAJobThatHasEnded) {
  const std::string id = held("h_somebody");
  ASSERT_TRUE(store->change_job(kMe, id, [](store::JobRow& row) -> Status {
    row.state = JobState::kCancelled;
    return {};
  }));
  EXPECT_EQ(code_of(store->put_checkpoint(under(3), id, "late")), "store.lease_lost");
}

TEST_F(StoreLeases, AreJudgedByTheCheckpointOfTheirOwnJob) {
  const std::string with = held("h_gone"), without = held("h_gone");
  ASSERT_TRUE(store->put_checkpoint(under(3), with, "state"));
  std::map<std::string, std::int64_t> kept;
  ASSERT_TRUE(store->take_from_the_gone(
      2000, false, [&](store::Store::LeftJob& one) { kept[one.owned.job.id] = one.kept_ms; }));
  EXPECT_EQ(kept.at(with), store->checkpoint(kMe, with)->kept_ms);
  EXPECT_EQ(kept.at(without), 0);
}

TEST_F(StoreLeases, OfTheGoneAndTheLateAreEndedAndOthersAreNot) {
  const std::unique_ptr<store::Store> other = std::move(*sqlite::join_sqlite_store(folder.path()));
  const std::string late = held(other->holder(), 1000), mine = held(store->holder());
  const std::string gone = held("h_gone"), with_it = held("h_gone");
  const std::string in_time = held(other->holder(), 3000);
  using Found = std::vector<std::pair<std::string, int>>;
  EXPECT_EQ(judged(2000), (Found{{late, 2}, {gone, 2}, {with_it, 2}}));
  EXPECT_EQ(store->job(kMe, gone)->lease, (store::JobLease{"", 3, kFarOff}));
  EXPECT_EQ(store->job(kMe, gone)->state, JobState::kQueued);
  EXPECT_EQ(judged(2000), Found{}) << "once is enough";
  EXPECT_EQ(judged(2000, true), (Found{{mine, 1}})) << "what this store has left, when it says so";
  EXPECT_EQ(store->job(kMe, in_time)->lease.holder, other->holder());
}

TEST_F(StoreLeases, EndWithTheStoreThatHeldThem) {
  std::unique_ptr<store::Store> other = std::move(*sqlite::join_sqlite_store(folder.path()));
  const std::string id = held(other->holder());
  EXPECT_TRUE(judged(0).empty());
  other.reset();
  EXPECT_EQ(judged(0).size(), 1u);
}

TEST_F(StoreLeases, OfAnotherProcessAreSeenToChange) {
  const std::unique_ptr<store::Store> other = std::move(*sqlite::join_sqlite_store(folder.path()));
  const std::string id = held("h_somebody");
  const std::int64_t before = store->changes_by_others();
  EXPECT_EQ(store->changes_by_others(), before);
  ASSERT_TRUE(other->change_job(kMe, id, [](store::JobRow&) -> Status { return {}; }));
  EXPECT_NE(store->changes_by_others(), before);
}

TEST_F(StoreLeases, AreJudgedInPlaceOfAnyoneElse) {
  const std::string id = held("h_gone");
  const auto refused = store->change_job(kMe, id, [](store::JobRow& row) -> Status {
    row.name = "lost";
    return Error{"test.refused", "no", "", ErrorKind::kConflict};
  });
  EXPECT_EQ(code_of(refused), "test.refused");
  EXPECT_EQ(store->job(kMe, id)->state, JobState::kRunning) << "an edit that refuses leaves the row";
}

TEST(JoinedStore, NeedsAServersFolderAndLeavesItsFilesAlone) {
  const TemporaryFolder folder;
  EXPECT_EQ(code_of(sqlite::join_sqlite_store(folder.path())), "store.open");
  const auto server = opened(folder.path());
  const std::string scratch = server->scratch_folder() + "/half";
  std::filesystem::create_directory(scratch);
  const auto worker = sqlite::join_sqlite_store(folder.path());
  ASSERT_TRUE(worker) << to_string(worker.error());
  EXPECT_TRUE(std::filesystem::exists(scratch));
  EXPECT_NE((*worker)->holder(), server->holder());
}

TEST(JoinedStore, KeepsANewServerFromSweepingWhatItHasUnderHand) {
  const TemporaryFolder folder;
  auto server = opened(folder.path());
  auto worker = std::move(*sqlite::join_sqlite_store(folder.path()));
  const std::string id = server->create_job(kMe, some_job("job"), "")->id;
  ASSERT_TRUE(worker->put_result(kMe, id, "final.obj", "not yet named"));
  server.reset();
  server = opened(folder.path());
  EXPECT_EQ(*server->result_bytes(kMe, id, "final.obj"), "not yet named");
  worker.reset();
  server.reset();
  server = opened(folder.path());
  EXPECT_EQ(code_of(server->result_bytes(kMe, id, "final.obj")), "store.not_found")
      << "nobody else was there";
}

}  // namespace
}  // namespace toile
