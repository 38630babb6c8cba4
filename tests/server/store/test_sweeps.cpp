// Sweeps are kept with their drapes, all at once, and go with the last of them.

#include "server/store/sweeps.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "server/store/events.h"
#include "server/store/job_search.h"
#include "server/store/webhooks.h"
#include "tests/server/store/store_folder.h"

namespace toile::test {
namespace {

using Words = std::vector<std::string>;

class StoredSweeps : public testing::Test {
 protected:
  static store::SweptJobs two_by_two(const std::string& project = "p_00000000000000000000") {
    store::SweptJobs wanted;
    wanted.sweep.project_id = project;
    wanted.sweep.project_revision = 3;
    wanted.sweep.name = "Skirt";
    wanted.sweep.bodies = {"eu36", "Größe \"M\""};
    wanted.sweep.fabrics = {"denim", "poplin"};
    for (int body = 0; body < 2; ++body) {
      for (int fabric = 0; fabric < 2; ++fabric) {
        store::JobRow job = some_job(std::to_string(body) + std::to_string(fabric));
        job.project_id = project;
        job.cell = {"", body, fabric};
        job.tags = {"spring"};
        wanted.jobs.push_back(job);
      }
    }
    return wanted;
  }
  store::Sweeps& sweeps() { return *store::sweeps_of(*store); }
  void become(const std::string& job, store::JobState state) {
    ASSERT_TRUE(store->change_job(kMe, job, [&](store::JobRow& row) -> Status {
      row.state = state;
      return {};
    }));
  }
  /// "sweep state" or "job state" of all events.
  Words told() {
    Words words;
    const auto events = store::events_of(*store)->events_after(kMe.owner, 0, 1000);
    for (const store::EventRow& event : *events)
      words.push_back((event.job.empty() ? "sweep " : "job ") + event.state);
    return words;
  }
  void reopen() {
    store.reset();
    store = opened(folder.path());
  }

  TemporaryFolder folder;
  std::unique_ptr<store::Store> store = opened(folder.path());
};

TEST_F(StoredSweeps, KeepWhatTheyAreAcrossAStart) {
  const auto made = sweeps().create_sweep(kMe, two_by_two(), "");
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_TRUE(made->anew);
  EXPECT_TRUE(made->sweep.id.starts_with("s_"));
  reopen();
  const auto kept = sweeps().sweep(kMe, made->sweep.id);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->bodies, (Words{"eu36", "Größe \"M\""}));
  EXPECT_EQ(kept->fabrics, (Words{"denim", "poplin"}));
  EXPECT_EQ(kept->name, "Skirt");
  EXPECT_EQ(kept->project_revision, 3);
  const auto jobs = sweeps().jobs_of_sweep(kMe, made->sweep.id);
  ASSERT_TRUE(jobs);
  ASSERT_EQ(jobs->size(), 4u);
  EXPECT_EQ((*jobs)[2].cell, (store::SweepCell{made->sweep.id, 1, 0}));
  EXPECT_EQ(store->job(kMe, (*jobs)[2].id)->document, some_job("").document);
  EXPECT_EQ(*store::tags_of_job(*store, kMe, (*jobs)[3].id), (store::Tags{"spring"}));
  EXPECT_EQ(store->unfinished_jobs()->size(), 4u) << "workers find them as any others";
}

TEST_F(StoredSweeps, AreMadeOnceUnderAKey) {
  const auto made = sweeps().create_sweep(kMe, two_by_two(), "once");
  const auto again = sweeps().create_sweep(kMe, two_by_two(), "once");
  ASSERT_TRUE(made && again);
  EXPECT_FALSE(again->anew);
  EXPECT_EQ(again->sweep.id, made->sweep.id);
  EXPECT_EQ(again->jobs.size(), 4u);
  EXPECT_EQ(sweeps().sweep_of_key(kMe, "once")->sweep.id, made->sweep.id);
  EXPECT_EQ(sweeps().sweep_of_key(kMe, "never")->sweep.id, "");
  EXPECT_EQ(code_of(sweeps().create_sweep(kMe, two_by_two("p_1"), "once")), "store.idempotency_mismatch");
  EXPECT_NE(sweeps().create_sweep(kAnn, two_by_two(), "once")->sweep.id, made->sweep.id);
  EXPECT_EQ(store->usage(kMe)->jobs, 4);
}

TEST_F(StoredSweeps, AreMadeWholeOrNotAtAll) {
  store.reset();
  store = std::move(*sqlite::open_sqlite_store(folder.path(), {.bytes = 0, .unfinished_jobs = 5}));
  ASSERT_TRUE(sweeps().create_sweep(kMe, two_by_two(), ""));
  const auto refused = sweeps().create_sweep(kMe, two_by_two(), "");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "quota.jobs");
  EXPECT_NE(refused.error().message.find("4 drapes"), std::string::npos) << refused.error().message;
  EXPECT_EQ(store->usage(kMe)->jobs, 4) << "not even one of them";
  EXPECT_EQ(sweeps().sweeps(kMe, "", "", 10)->size(), 1u);
}

TEST_F(StoredSweeps, AreListedNewestFirstAndByProject) {
  const std::string first = sweeps().create_sweep(kMe, two_by_two("p_1"), "")->sweep.id;
  const std::string second = sweeps().create_sweep(kMe, two_by_two("p_2"), "")->sweep.id;
  const auto all = sweeps().sweeps(kMe, "", "", 10);
  ASSERT_EQ(all->size(), 2u);
  EXPECT_EQ(all->front().id, second);
  EXPECT_EQ(sweeps().sweeps(kMe, "p_1", "", 10)->front().id, first);
  EXPECT_EQ(sweeps().sweeps(kMe, "", second, 10)->front().id, first) << "the page after it";
  EXPECT_TRUE(sweeps().sweeps(kAnn, "", "", 10)->empty());
  EXPECT_EQ(code_of(sweeps().sweep(kAnn, first)), "store.not_found");
  EXPECT_EQ(code_of(sweeps().jobs_of_sweep(kAnn, first)), "store.not_found");
  EXPECT_EQ(code_of(sweeps().sweeps(kMe, "", "j_1", 10)), "store.cursor");
  const auto found = store::job_search_of(*store)->find_jobs(
      kMe, {.states = {}, .project_id = {}, .tag = {}, .sweep = first}, "", 10);
  EXPECT_EQ(found->size(), 4u);
}

TEST_F(StoredSweeps, TellOfTheirEndOnceTheLastDrapeHasEnded) {
  const auto made = sweeps().create_sweep(kMe, two_by_two(), "");
  for (const store::JobRow& job : made->jobs) become(job.id, store::JobState::kSucceeded);
  EXPECT_EQ(told(), (Words{"job queued", "job queued", "job queued", "job queued", "job succeeded",
                           "job succeeded", "job succeeded", "job succeeded", "sweep succeeded"}));
  const auto events = store::events_of(*store)->events_after(kMe.owner, 0, 1000);
  EXPECT_EQ(events->front().sweep, made->sweep.id);
  EXPECT_EQ(events->back().sweep, made->sweep.id);
  EXPECT_EQ(events->back().name, "Skirt");
  EXPECT_EQ(events->back().project_id, made->sweep.project_id);
}

TEST_F(StoredSweeps, SayTheWorstOfTheNewestDrapes) {
  const auto made = sweeps().create_sweep(kMe, two_by_two(), "");
  become(made->jobs[0].id, store::JobState::kFailed);
  become(made->jobs[1].id, store::JobState::kCancelled);
  become(made->jobs[2].id, store::JobState::kSucceeded);
  become(made->jobs[3].id, store::JobState::kSucceeded);
  EXPECT_EQ(told().back(), "sweep failed");
  store::JobRow again = some_job("again");
  again.cell = made->jobs[0].cell;
  const std::string id = store->create_job(kMe, again, "")->id;
  become(id, store::JobState::kSucceeded);
  EXPECT_EQ(told().back(), "sweep cancelled") << "the failed one is no longer what its cell stands at";
}

TEST_F(StoredSweeps, GoWithTheLastOfTheirDrapes) {
  const auto made = sweeps().create_sweep(kMe, two_by_two(), "");
  for (const store::JobRow& job : made->jobs) become(job.id, store::JobState::kSucceeded);
  for (std::size_t i = 0; i < 3; ++i) ASSERT_TRUE(store->remove_job(kMe, made->jobs[i].id));
  EXPECT_EQ(sweeps().jobs_of_sweep(kMe, made->sweep.id)->size(), 1u);
  ASSERT_TRUE(store->remove_job(kMe, made->jobs[3].id));
  EXPECT_EQ(code_of(sweeps().sweep(kMe, made->sweep.id)), "store.not_found");
  EXPECT_EQ(told().back(), "sweep removed");
}

TEST_F(StoredSweeps, EndsAreToldToWebhooks) {
  store::WebhookRow webhook;
  webhook.owner = kMe.owner;
  webhook.url = "https://example.org/";
  webhook.states = {"succeeded"};
  const std::string hook = store::webhooks_of(*store)->add_webhook(webhook)->id;
  const auto made = sweeps().create_sweep(kMe, two_by_two(), "");
  for (const store::JobRow& job : made->jobs) become(job.id, store::JobState::kSucceeded);
  const auto deliveries = store::webhooks_of(*store)->deliveries(kMe.owner, hook, 10);
  ASSERT_EQ(deliveries->size(), 5u);
  EXPECT_EQ(deliveries->front().event.job, "") << "newest first: the sweep's own";
  EXPECT_EQ(deliveries->front().event.sweep, made->sweep.id);
  EXPECT_EQ(deliveries->back().event.sweep, made->sweep.id);
}

}  // namespace
}  // namespace toile::test
