#include "server/jobs/roster.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace toile {
namespace {

using enum store::JobState;
using jobs::MakeRoom;
using jobs::WorkerKind;

jobs::LiveJobPtr job(const std::string& id, const store::OwnerId& owner = "a",
                     store::JobState state = kQueued) {
  auto job = std::make_shared<jobs::LiveJob>();
  job->id = id;
  job->context = store::RequestContext(owner);
  job->state = job->row.state = state;
  return job;
}

std::string next(const jobs::JobRoster& roster, WorkerKind kind = WorkerKind::kAny) {
  const jobs::LiveJobPtr job = roster.next(kind);
  return job ? job->id : "";
}

TEST(JobRoster, HoldsAJobOnlyOnceAndForgetsItWhenItLeaves) {
  jobs::JobRoster roster;
  EXPECT_TRUE(roster.enter(job("j")));
  EXPECT_FALSE(roster.enter(job("j")));
  EXPECT_EQ(roster.all().size(), 1U);
  roster.leave(*roster.find("j"));
  EXPECT_EQ(roster.find("j"), nullptr);
  EXPECT_EQ(next(roster), "");
  EXPECT_FALSE(roster.anybody_waits());
}

TEST(JobRoster, LetsNoPausedJobWaitNorOneThatAnotherProcessHas) {
  jobs::JobRoster roster;
  roster.enter(job("paused", "a", kPaused));
  const jobs::LiveJobPtr theirs = job("theirs");
  theirs->row.lease.holder = "another";
  roster.enter(theirs);
  EXPECT_EQ(next(roster), "");
  theirs->row.lease.holder.clear();
  roster.place(*theirs, false);
  EXPECT_EQ(next(roster), "theirs");
}

TEST(JobRoster, GivesTheTurnToTheOwnerWhoHasHadLeast) {
  jobs::JobRoster roster;
  const jobs::LiveJobPtr first = job("first", "a");
  roster.enter(first);
  roster.enter(job("second", "b"));
  EXPECT_EQ(next(roster), "first");
  roster.charge(*first, 5);
  EXPECT_EQ(next(roster), "second");
  EXPECT_EQ(roster.room_to_make(*first, 9), MakeRoom::kInMemory);
}

/// Owner a's drape runs, b's has made room in memory, c's has not begun.
class CrowdedRoster : public testing::Test {
 protected:
  CrowdedRoster() {
    for (const jobs::LiveJobPtr& each : {runs, begun}) {
      each->run = std::make_unique<jobs::JobRun>(jobs::RunPlace{}, each->context, each->id, 1);
      each->context.lease = 1;
      roster.enter(each);
    }
    roster.enter(fresh);
    roster.put(*begun, jobs::QueuePlace::kFront);
    runs->held = true;
  }

  jobs::JobRoster roster;
  const jobs::LiveJobPtr runs = job("runs", "a", kRunning), begun = job("begun", "b", kRunning),
                         fresh = job("fresh", "c");
};

TEST_F(CrowdedRoster, GivesTheTurnOfOneThatWouldBeOneTooManyForOneThatLeavesMemory) {
  roster.charge(*runs, 5);
  roster.charge(*begun, 5);
  EXPECT_EQ(next(roster), "fresh");
  EXPECT_EQ(roster.room_to_make(*runs, 3), MakeRoom::kInMemory);
  EXPECT_EQ(roster.room_to_make(*runs, 2), MakeRoom::kAside);
  EXPECT_EQ(roster.next(WorkerKind::kAny, 2)->id, "begun") << "while nobody has left";
  EXPECT_EQ(roster.begun(), 2);
  runs->held = false;
  runs->aside = true;
  EXPECT_EQ(roster.begun(), 1);
  EXPECT_EQ(roster.next(WorkerKind::kAny, 2)->id, "fresh");
}

TEST_F(CrowdedRoster, LeavesInMemoryWhatMakesRoomForOneThere) {
  roster.charge(*runs, 5);
  EXPECT_EQ(roster.room_to_make(*runs, 2), MakeRoom::kInMemory) << "for begun, which comes before fresh";
  EXPECT_EQ(roster.next(WorkerKind::kAny, 2)->id, "begun") << "and that is who comes";
  begun->held = true;
  EXPECT_EQ(roster.next(WorkerKind::kAny, 2)->id, "fresh") << "rather than that a worker does nothing";
}

TEST_F(CrowdedRoster, TakesUpWhatIsCostlyToTakeUpLessOften) {
  begun->aside = true;
  begun->loads_in_s = 0.5;
  fresh->row.lease.holder = "another";
  roster.place(*fresh, false);
  roster.charge(*runs, 4);
  EXPECT_EQ(roster.room_to_make(*runs, 1), MakeRoom::kNot);
  roster.charge(*runs, 1);
  EXPECT_EQ(roster.room_to_make(*runs, 1), MakeRoom::kAside);
  runs->loads_in_s = 0.1;
  EXPECT_EQ(roster.room_to_make(*runs, 1), MakeRoom::kNot) << "it will have to be taken up as well";
}

TEST_F(CrowdedRoster, CountsThePausedThatTakeMemory) {
  EXPECT_EQ(roster.parked(), 0);
  begun->state = fresh->state = kPaused;
  EXPECT_EQ(roster.parked(), 1);
  begun->aside = true;
  EXPECT_EQ(roster.parked(), 0);
}

TEST(JobRoster, LetsASuspectRunBeforeAllOthersAndAlone) {
  jobs::JobRoster roster;
  const jobs::LiveJobPtr plain = job("plain"), suspect = job("suspect");
  suspect->suspect = true;
  roster.enter(plain);
  roster.enter(suspect);
  plain->held = true;
  EXPECT_EQ(next(roster), "") << "another runs";
  EXPECT_EQ(roster.room_to_make(*plain, 9), MakeRoom::kNot) << "what runs goes on until it ends";
  plain->held = false;
  EXPECT_EQ(next(roster), "suspect");
  suspect->held = true;
  EXPECT_EQ(next(roster), "") << "nothing beside a suspect";
}

TEST(JobRoster, KeepsExpressWorkersForInteractiveDrapesThatHaveWaited) {
  jobs::JobRoster roster;
  const jobs::LiveJobPtr batch = job("batch"), eager = job("eager");
  eager->row.priority = store::JobPriority::kInteractive;
  eager->waits_since = batch->waits_since = std::chrono::steady_clock::now();
  roster.enter(batch);
  roster.enter(eager);
  EXPECT_EQ(next(roster, WorkerKind::kExpress), "");
  eager->waits_since = batch->waits_since -= 2 * jobs::kExpressAfter;
  EXPECT_EQ(next(roster, WorkerKind::kExpress), "eager");
}

TEST(JobRoster, CountsWhatWaitsRunsAndIsPaused) {
  jobs::JobRoster roster;
  const jobs::LiveJobPtr old = job("old");
  old->row.created_ms = 4000;
  const jobs::LiveJobPtr young = job("young");
  young->row.created_ms = 9000;
  for (const jobs::LiveJobPtr& each : {old, young, job("runs", "a", kRunning), job("paused", "a", kPaused)})
    roster.enter(each);
  jobs::JobService::Counts counts;
  roster.count(10'000, counts);
  EXPECT_EQ(counts.queued, 2);
  EXPECT_EQ(counts.running, 1);
  EXPECT_EQ(counts.paused, 1);
  EXPECT_EQ(counts.oldest_queued_s, 6);
}

}  // namespace
}  // namespace toile
