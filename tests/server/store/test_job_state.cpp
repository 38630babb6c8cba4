#include "server/store/job_state.h"

#include <gtest/gtest.h>

#include "server/store/sqlite/migrations.h"
#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

TEST(JobState, EveryStateHasAWordThatReadsBackAsIt) {
  for (std::size_t i = 0; i < store::kJobStates.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(store::kJobStates[i]), i)
        << "the list has every state once, in its order";
    const Result<store::JobState> read = store::job_state_from(store::name_of(store::kJobStates[i]));
    ASSERT_TRUE(read.ok()) << store::name_of(store::kJobStates[i]);
    EXPECT_EQ(*read, store::kJobStates[i]);
  }
}

TEST(JobState, UnknownWordsAreRefusedAndQuotedAsThePlace) {
  for (const char* word : {"", "sleeping", "Queued", "queued ", "done"}) {
    const Result<store::JobState> read = store::job_state_from(word);
    ASSERT_FALSE(read.ok()) << word;
    EXPECT_EQ(read.error().code, "store.unknown_state");
    EXPECT_EQ(read.error().where, word);
  }
}

TEST(JobState, TheListForSqlHoldsJustTheStatesThatAreNotFinal) {
  const std::string list = store::unfinished_states_in_sql();
  for (const store::JobState state : store::kJobStates) {
    const bool listed = list.find("'" + std::string(store::name_of(state)) + "'") != std::string::npos;
    EXPECT_EQ(listed, !store::is_final(state)) << store::name_of(state);
  }
}

sqlite::SqlDatabase database_in(const TemporaryFolder& folder) {
  Result<sqlite::SqlDatabase> database = sqlite::SqlDatabase::open(folder.path() + "/toile.db");
  EXPECT_TRUE(database);
  return std::move(*database);
}

TEST(JobState, TheListForSqlReadsAsInTheIndexOfUnfinishedJobs) {
  const TemporaryFolder folder;
  sqlite::SqlDatabase database = database_in(folder);
  ASSERT_TRUE(sqlite::migrate(database));
  Result<sqlite::SqlStatement> plan =
      database.prepare("EXPLAIN QUERY PLAN SELECT id FROM jobs WHERE state IN (" +
                       store::unfinished_states_in_sql() + ") ORDER BY id");
  ASSERT_TRUE(plan);
  ASSERT_TRUE(*plan->step());
  const std::string words = plan->text(3);
  EXPECT_NE(words.find("jobs_unfinished"), std::string::npos) << words;
}

TEST(JobState, ARowOfAnUnknownStateIsToldAsDamagedWithItsJob) {
  const TemporaryFolder folder;
  std::string id;
  {
    const auto store = opened(folder.path());
    id = store->create_job(kMe, some_job("drape"), "").value().id;
  }
  ASSERT_TRUE(database_in(folder).run("UPDATE jobs SET state = 'sleeping'"));
  const auto store = opened(folder.path());
  const Result<store::JobRow> row = store->job(kMe, id);
  ASSERT_FALSE(row.ok());
  EXPECT_EQ(row.error().code, "store.corrupt");
  EXPECT_EQ(row.error().where, id);
}

TEST(JobState, ADamagedRowHidesNoOtherOfItsList) {
  const TemporaryFolder folder;
  std::string bad, good;
  {
    const auto store = opened(folder.path());
    bad = store->create_job(kMe, some_job("bad"), "").value().id;
    good = store->create_job(kMe, some_job("good"), "").value().id;
  }
  ASSERT_TRUE(database_in(folder).run("UPDATE jobs SET state = 'sleeping' WHERE id = ?", {bad}));
  const auto store = opened(folder.path());
  const Result<std::vector<store::JobRow>> jobs = store->jobs(kMe, "", 10);
  ASSERT_TRUE(jobs);
  ASSERT_EQ(jobs->size(), 1u);
  EXPECT_EQ(jobs->front().id, good);
  EXPECT_TRUE(store->unfinished_jobs()) << "and keeps no server from starting";
}

}  // namespace
}  // namespace toile
