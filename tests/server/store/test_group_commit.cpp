#include "server/store/sqlite/group_commit.h"

#include <atomic>
#include <future>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

using sqlite::GroupCommit;
using sqlite::SqlDatabase;

Error refusal() { return {"test.refused", "it does not want to", ""}; }

/// A table of texts, and a second connection that sees what is committed.
class TogetherInSqlite : public testing::Test {
 protected:
  TogetherInSqlite()
      : database(SqlDatabase::open(folder.path() + "/a.db").value()),
        other(SqlDatabase::open(folder.path() + "/a.db").value()) {
    EXPECT_TRUE(database.run_script("CREATE TABLE texts (text TEXT UNIQUE)"));
  }

  Status insert(const std::string& text) {
    TRY(database.run("INSERT INTO texts (text) VALUES (?)", {text}));
    return {};
  }

  /// In the order in which they were written.
  std::vector<std::string> committed() {
    std::vector<std::string> texts;
    Result<sqlite::SqlStatement> all = other.prepare("SELECT text FROM texts ORDER BY rowid");
    while (all && all->step().value()) texts.push_back(all->text(0));
    return texts;
  }

  /// What comes of writes that are all there, in their order, before the first is begun.
  std::vector<std::future<Status>> come_together(const std::vector<GroupCommit::Write>& writes) {
    std::vector<std::future<Status>> outcomes;
    const std::lock_guard hold(mutex);  // whoever leads waits for it
    for (const GroupCommit::Write& write : writes) {
      outcomes.push_back(std::async(std::launch::async, [this, &write] { return commits.run(write); }));
      while (commits.waiting() < outcomes.size()) std::this_thread::yield();
    }
    return outcomes;
  }

  TemporaryFolder folder;
  std::mutex mutex;
  SqlDatabase database, other;
  GroupCommit commits{mutex, database};
};

TEST_F(TogetherInSqlite, ThoseWhoWaitAreWrittenByOneOfThemInTheirOrder) {
  std::set<std::thread::id> leaders;
  std::vector<GroupCommit::Write> writes;
  for (const char* text : {"a", "b", "c", "d"}) {
    writes.emplace_back([&, text] {
      leaders.insert(std::this_thread::get_id());
      EXPECT_TRUE(committed().empty()) << "one transaction for all";
      return insert(text);
    });
  }
  auto outcomes = come_together(writes);
  for (std::future<Status>& outcome : outcomes) EXPECT_EQ(code_of(outcome.get()), "ok");
  EXPECT_EQ(leaders.size(), 1u);
  EXPECT_EQ(committed(), (std::vector<std::string>{"a", "b", "c", "d"}));
}

TEST_F(TogetherInSqlite, NobodyIsToldBeforeTheDiskHasIt) {
  std::vector<std::optional<bool>> told(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < told.size(); ++i) {
    threads.emplace_back([&, i] {
      const std::string text = std::to_string(i);
      SqlDatabase mine = SqlDatabase::open(folder.path() + "/a.db").value();
      const Status kept = commits.run([&] { return insert(text); });
      sqlite::SqlStatement count = mine.prepare("SELECT count(*) FROM texts WHERE text = ?", {text}).value();
      told[i] = kept.ok() && count.step().value() && count.integer(0) == 1;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::optional<bool>& seen : told) EXPECT_EQ(seen, true);
}

TEST_F(TogetherInSqlite, OneThatFailsLeavesNoTraceAndTakesNobodyAlong) {
  const std::vector<GroupCommit::Write> writes{[&] { return insert("a"); },
                                               [&]() -> Status {
                                                 TRY(insert("half"));
                                                 return refusal();
                                               },
                                               [&] { return insert("a"); },  // it is there already
                                               [&]() -> Status {
                                                 TRY(insert("thrown"));
                                                 throw std::runtime_error("broken off");
                                               },
                                               [&] { return insert("b"); }};
  auto outcomes = come_together(writes);
  EXPECT_EQ(code_of(outcomes[0].get()), "ok");
  EXPECT_EQ(code_of(outcomes[1].get()), "test.refused");
  EXPECT_EQ(code_of(outcomes[2].get()), "store.failed");
  EXPECT_THROW((void)outcomes[3].get(), std::runtime_error);
  EXPECT_EQ(code_of(outcomes[4].get()), "ok");
  EXPECT_EQ(committed(), (std::vector<std::string>{"a", "b"}));
}

/// As SQLite ends a transaction by itself where the disk is full.
TEST_F(TogetherInSqlite, OneThatEndsTheTransactionTakesNobodyAlong) {
  int tries = 0;
  const std::vector<GroupCommit::Write> writes{
      [&] {
        ++tries;
        return insert("a");
      },
      [&]() -> Status {
        TRY(database.run_script("ROLLBACK"));
        return refusal();
      },
      [&] { return database.run_script("ROLLBACK"); },  // and says that all went well
      [&] { return insert("b"); }};
  auto outcomes = come_together(writes);
  EXPECT_EQ(code_of(outcomes[0].get()), "ok");
  EXPECT_EQ(code_of(outcomes[1].get()), "test.refused");
  EXPECT_EQ(code_of(outcomes[2].get()), "store.failed");
  EXPECT_EQ(code_of(outcomes[3].get()), "ok");
  EXPECT_EQ(tries, 3);
  EXPECT_EQ(committed(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(TogetherInSqlite, WhatCannotBeCommittedIsToldToAll) {
  ASSERT_TRUE(
      database.run_script("PRAGMA foreign_keys=ON; CREATE TABLE parents (id INTEGER PRIMARY KEY);"
                          "CREATE TABLE children (parent INTEGER REFERENCES parents (id)"
                          " DEFERRABLE INITIALLY DEFERRED)"));
  const std::vector<GroupCommit::Write> writes{
      [&] { return insert("a"); },
      [&] { return database.run_script("INSERT INTO children VALUES (1)"); }};  // found out at the commit
  auto outcomes = come_together(writes);
  EXPECT_EQ(code_of(outcomes[0].get()), "store.failed");
  EXPECT_EQ(code_of(outcomes[1].get()), "store.failed");
  EXPECT_TRUE(committed().empty());
  EXPECT_EQ(code_of(commits.run([&] { return insert("b"); })), "ok") << "the next ones fare better";
  EXPECT_EQ(committed(), std::vector<std::string>{"b"});
}

TEST_F(TogetherInSqlite, AnotherProcessThatHoldsTheFileIsToldToAll) {
  ASSERT_TRUE(database.run_script("PRAGMA busy_timeout=1"));
  ASSERT_TRUE(other.run_script("BEGIN IMMEDIATE"));
  const std::vector<GroupCommit::Write> writes{[&] { return insert("a"); }, [&] { return insert("b"); }};
  auto outcomes = come_together(writes);
  EXPECT_EQ(code_of(outcomes[0].get()), "store.busy");
  EXPECT_EQ(code_of(outcomes[1].get()), "store.busy");
  ASSERT_TRUE(other.run_script("ROLLBACK"));
  EXPECT_EQ(code_of(commits.run([&] { return insert("a"); })), "ok");
}

TEST_F(TogetherInSqlite, ManyFromManyThreadsAreAllThereOnce) {
  constexpr int kThreads = 8, kEach = 25;
  std::atomic<int> faults{0};
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      for (int i = 0; i < kEach; ++i) {
        const std::string text = std::to_string(thread) + " " + std::to_string(i);
        const bool refuses = i % 5 == 4;
        const Status kept = commits.run([&]() -> Status {
          TRY(insert(text));
          return refuses ? Status(refusal()) : Status();
        });
        faults += kept.ok() == refuses;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(faults, 0);
  const std::vector<std::string> texts = committed();
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(kThreads * kEach * 4 / 5));
  EXPECT_EQ(std::set<std::string>(texts.begin(), texts.end()).size(), texts.size());
}

}  // namespace
}  // namespace toile
