// What becomes of jobs is written down with the job itself.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "server/store/events.h"
#include "tests/server/owners.h"
#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile::test {
namespace {

class Events : public testing::Test {
 protected:
  std::string make_job(const store::RequestContext& context) {
    store::JobRow row;
    row.project_id = "p_1";
    row.name = "Skirt";
    row.document = "{}";
    return store->create_job(context, row, "")->id;
  }
  void become(const std::string& id, store::JobState state, const std::string& why = "") {
    ASSERT_TRUE(store->change_job(kMe, id, [&](store::JobRow& row) -> Status {
      row.state = state;
      row.reason_code = why;
      return {};
    }));
  }
  std::vector<std::string> told(const store::RequestContext& context, std::int64_t after = 0) {
    std::vector<std::string> words;
    const auto events = store::events_of(*store)->events_after(context.owner, after, 5000);
    EXPECT_TRUE(events);
    for (const store::EventRow& event : *events)
      words.push_back(std::to_string(event.number) + " " + event.state + " " + event.job);
    return words;
  }

  TemporaryFolder folder;
  std::unique_ptr<store::Store> store = opened(folder.path());
};

using Words = std::vector<std::string>;

TEST_F(Events, FollowAJobFromItsBeginningToItsRemoval) {
  const std::string id = make_job(kMe);
  become(id, store::JobState::kRunning);
  become(id, store::JobState::kRunning);  // figures alone are no event
  become(id, store::JobState::kFailed, "start.crosses_body");
  ASSERT_TRUE(store->remove_job(kMe, id));
  EXPECT_EQ(told(kMe), (Words{"1 queued " + id, "2 running " + id, "3 failed " + id, "4 removed " + id}));
  EXPECT_EQ(told(kMe, 2), (Words{"3 failed " + id, "4 removed " + id}));
  const auto events = store::events_of(*store)->events_after(kMe.owner, 2, 1);
  ASSERT_TRUE(events);
  const store::EventRow& failed = events->front();
  EXPECT_EQ(failed.reason_code, "start.crosses_body");
  EXPECT_EQ(failed.name, "Skirt");
  EXPECT_EQ(failed.project_id, "p_1");
  EXPECT_NEAR(static_cast<double>(failed.at_ms),
              static_cast<double>(store->job(kMe, make_job(kMe))->created_ms), 60'000);
}

TEST_F(Events, AreAnOwnersOwnWithTheirOwnNumbers) {
  const std::string mine = make_job(kMe), theirs = make_job(kStranger);
  EXPECT_EQ(told(kMe), (Words{"1 queued " + mine}));
  EXPECT_EQ(told(kStranger), (Words{"1 queued " + theirs}));
  EXPECT_EQ(*store::events_of(*store)->newest_event("nobody"), 0);
}

TEST_F(Events, AreNotWrittenWhereTheJobIsNot) {
  const std::string id = make_job(kMe);
  const auto refuse = [](store::JobRow& row) -> Status {
    row.state = store::JobState::kRunning;
    return Error{"test.no", "not so", ""};
  };
  EXPECT_FALSE(store->change_job(kMe, id, refuse));
  EXPECT_EQ(told(kMe).size(), 1u);
}

TEST_F(Events, AreThereAfterARestart) {
  const std::string id = make_job(kMe);
  store.reset();
  store = opened(folder.path());
  EXPECT_EQ(told(kMe), (Words{"1 queued " + id}));
  make_job(kMe);
  EXPECT_EQ(*store::events_of(*store)->newest_event(kMe.owner), 2);
}

TEST_F(Events, OldOnesGoAndNumbersRiseOn) {
  const std::string id = make_job(kMe);
  for (int i = 0; i < 600; ++i) {
    become(id, store::JobState::kRunning);
    become(id, store::JobState::kQueued);
  }
  const Words words = told(kMe);
  EXPECT_GE(words.size(), 1000u);
  EXPECT_LE(words.size(), 1100u);
  EXPECT_EQ(words.back(), "1201 queued " + id);
}

}  // namespace
}  // namespace toile::test
