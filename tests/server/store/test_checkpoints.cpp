// What the store keeps of drapes under way.

#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

TEST(StoreCheckpoints, AreReplacedKeptOverAReopeningAndRemoved) {
  const TemporaryFolder folder;
  std::string id;
  {
    const auto store = opened(folder.path());
    id = store->create_job(kAnn, some_job("skirt"), "").value().id;
    EXPECT_EQ(code_of(store->checkpoint(kAnn, id)), "store.not_found");
    EXPECT_TRUE(store->remove_checkpoint(kAnn, id).ok()) << "nothing to remove is no error";
    EXPECT_TRUE(store->put_checkpoint(kAnn, id, "first").ok());
    EXPECT_TRUE(store->put_checkpoint(kAnn, id, std::string("sec\0ond", 7)).ok());
  }
  const auto store = opened(folder.path());
  const auto kept = store->checkpoint(kAnn, id);
  ASSERT_TRUE(kept.ok()) << to_string(kept.error());
  EXPECT_EQ(kept->bytes, std::string("sec\0ond", 7));
  const auto age = store->job(kAnn, id)->created_ms - kept->kept_ms;
  EXPECT_LT(std::abs(age), 60000) << "its time is the clock's";
  EXPECT_TRUE(store->remove_checkpoint(kAnn, id).ok());
  EXPECT_EQ(code_of(store->checkpoint(kAnn, id)), "store.not_found");
}

TEST(StoreCheckpoints, BelongToTheirOwner) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  const std::string id = store->create_job(kAnn, some_job("skirt"), "").value().id;
  EXPECT_TRUE(store->put_checkpoint(kAnn, id, "hers").ok());
  EXPECT_EQ(code_of(store->put_checkpoint(kBob, id, "his")), "store.not_found");
  EXPECT_EQ(code_of(store->checkpoint(kBob, id)), "store.not_found");
  EXPECT_EQ(code_of(store->remove_checkpoint(kBob, id)), "store.not_found");
  EXPECT_EQ(code_of(store->put_checkpoint(kAnn, "../../toile.db", "x")), "store.not_found");
  EXPECT_EQ(store->checkpoint(kAnn, id)->bytes, "hers");
}

TEST(StoreCheckpoints, OfJobsThatHaveEndedGoWhenTheStoreIsOpened) {
  const TemporaryFolder folder;
  std::string ended, running;
  {
    const auto store = opened(folder.path());
    store::JobRow row = store->create_job(kAnn, some_job("ended"), "").value();
    ended = row.id;
    running = store->create_job(kBob, some_job("running"), "").value().id;
    for (const auto& [owner, id] : {std::pair{kAnn, ended}, {kBob, running}}) {
      EXPECT_TRUE(store->put_checkpoint(owner, id, "state").ok());
    }
    row.state = store::JobState::kSucceeded;
    EXPECT_TRUE(test::update_job(*store, kAnn, row).ok());  // and then it was killed
  }
  const auto store = opened(folder.path());
  EXPECT_EQ(code_of(store->checkpoint(kAnn, ended)), "store.not_found");
  EXPECT_EQ(code_of(store->checkpoint(kBob, running)), "ok");
}

}  // namespace
}  // namespace toile
