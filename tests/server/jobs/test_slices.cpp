// Drapes in slices: who comes first, and that nobody's bytes depend on it.

#include <chrono>
#include <thread>

#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kEndless;
using test::kOwner;
using enum store::JobPriority;

const store::RequestContext kBob("bob");

class JobSlices : public test::JobHouse {
 protected:
  std::string submit_as(const store::RequestContext& who, const std::string& document,
                        store::JobPriority priority = kBatch) {
    store::AssetRow body;
    body.kind = "body";
    body.name = "block.obj";
    store::ProjectRow project;
    project.document = document;
    project.files = {{"block.obj", store.put_asset(who, body, test::kBlock).value().id}};
    const auto job = service->submit(who, store.create_project(who, project, "").value().id, "", priority);
    EXPECT_TRUE(job.ok());
    return job ? job->id : "";
  }
  store::JobState state(const std::string& id, const store::RequestContext& who = kOwner) {
    return store.job(who, id)->state;
  }
  std::size_t frames(const std::string& id) { return publisher.log(id).frames.size(); }
  /// On one worker alone.
  void start_one() {
    settings.express = 0;
    make(1);
    ASSERT_TRUE(service->start());
  }
};

TEST_F(JobSlices, AnInteractiveDrapeEndsWhileTwentyOfBatchRunOnTwoWorkers) {
  ASSERT_TRUE(service->start());
  std::vector<std::string> batch;
  for (int i = 0; i < 20; ++i) batch.push_back(submit_as(kOwner, cloth_over_block(180 + i, kEndless)));
  ASSERT_TRUE(publisher.wait_for_frames(batch[0], 2));
  ASSERT_TRUE(publisher.wait_for_frames(batch[1], 2));
  const auto before = std::chrono::steady_clock::now();
  const std::string id = submit_as(kOwner, cloth_over_block(200), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(id, 1));
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - before;
  std::printf("the first frame of an interactive drape among twenty of batch came after %.3f s\n",
              waited.count());
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(state(id), store::JobState::kSucceeded);
  EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
  for (const std::string& other : batch) EXPECT_FALSE(store::is_final(state(other)));
  const std::size_t had = frames(batch[0]);
  EXPECT_TRUE(publisher.wait_for_frames(batch[0], had + 3)) << "what made room goes on";
}

TEST_F(JobSlices, OneOwnersBatchWorkGoesOneByOne) {
  start_one();
  const std::string first = submit_as(kOwner, cloth_over_block(300)),
                    second = submit_as(kOwner, cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_frames(second, 1));
  EXPECT_TRUE(publisher.wait_for_end(first)) << "it was not cut for another of the same owner";
  EXPECT_EQ(publisher.log(first).progress.back().progress.phase, "stills");
  ASSERT_TRUE(publisher.wait_for_end(second));
}

TEST_F(JobSlices, TwoOwnersTakeTurnsAndEndInTheBytesOfOneGo) {
  start_one();
  const std::string ann = submit_as(kOwner, cloth_over_block(1000, 3)),
                    bob = submit_as(kBob, cloth_over_block(1000, 3));
  ASSERT_TRUE(publisher.wait_for_frames(ann, 1));
  ASSERT_TRUE(publisher.wait_for_frames(bob, 1));
  EXPECT_FALSE(store::is_final(state(ann))) << "bob did not wait for ann's end, after " << row(ann).worked_ms;
  ASSERT_TRUE(publisher.wait_for_end(ann));
  ASSERT_TRUE(publisher.wait_for_end(bob));
  EXPECT_EQ(hash_in(row(ann)), hash_of_alone(row(ann)));
  EXPECT_EQ(hash_in(*store.job(kBob, bob)), hash_in(row(ann))) << "the same cloth";
  EXPECT_EQ(publisher.log(ann).topologies.size(), 1u) << "nothing began anew";
  EXPECT_EQ(row(ann).attempt, 1);
}

TEST_F(JobSlices, WhatHasMadeRoomCanBePausedResumedAndCancelled) {
  start_one();
  const std::string batch = submit_as(kOwner, cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(batch, 2));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210, kEndless), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(urgent, 2));
  EXPECT_EQ(state(batch), store::JobState::kRunning);
  ASSERT_TRUE(service->pause(kOwner, batch));
  EXPECT_EQ(state(batch), store::JobState::kPaused);
  ASSERT_TRUE(service->resume(kOwner, batch));
  EXPECT_EQ(state(batch), store::JobState::kQueued);
  ASSERT_TRUE(service->cancel(kOwner, urgent));
  ASSERT_TRUE(publisher.wait_for_end(urgent));
  const std::size_t had = frames(batch);
  ASSERT_TRUE(publisher.wait_for_frames(batch, had + 2));
  const std::string next = submit_as(kOwner, cloth_over_block(210, kEndless), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(next, 2));
  ASSERT_TRUE(service->cancel(kOwner, batch));
  ASSERT_TRUE(publisher.wait_for_end(batch));
  EXPECT_EQ(state(batch), store::JobState::kCancelled);
  EXPECT_FALSE(store.checkpoint(kOwner, batch));
}

TEST_F(JobSlices, AStopKeepsWhatHasMadeRoomWhereItStands) {
  settings.checkpoint_every_s = 3600;
  start_one();
  const std::string batch = submit_as(kOwner, cloth_over_block(200, 1.5));
  ASSERT_TRUE(publisher.wait_for_frames(batch, 2));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210, kEndless), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(urgent, 2));
  service->stop();
  EXPECT_EQ(state(batch), store::JobState::kQueued);
  ASSERT_TRUE(store.checkpoint(kOwner, batch));
  make(1);
  ASSERT_TRUE(service->start());
  ASSERT_TRUE(service->cancel(kOwner, urgent));
  ASSERT_TRUE(publisher.wait_for_end(batch, 2));
  EXPECT_EQ(state(batch), store::JobState::kSucceeded);
  EXPECT_EQ(hash_in(row(batch)), hash_of_alone(row(batch)));
  EXPECT_GT(publisher.log(batch).ended.back().first_step, 0) << "it went on from where it stood";
}

TEST_F(JobSlices, WhereThereIsNoMemoryForAnotherADrapeMakesRoomByLeavingIt) {
  settings.max_parked = 0;
  settings.checkpoint_every_s = 3600;
  start_one();
  const std::string batch = submit_as(kOwner, cloth_over_block(200, 1.5));
  ASSERT_TRUE(publisher.wait_for_frames(batch, 1));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(urgent, 1));
  EXPECT_EQ(service->counts().in_memory, 1);
  EXPECT_EQ(state(batch), store::JobState::kRunning) << "for all who look";
  EXPECT_TRUE(store.checkpoint(kOwner, batch));
  ASSERT_TRUE(publisher.wait_for_end(urgent));
  ASSERT_TRUE(publisher.wait_for_end(batch));
  EXPECT_EQ(hash_in(row(batch)), hash_of_alone(row(batch)));
  EXPECT_EQ(hash_in(row(urgent)), hash_of_alone(row(urgent)));
  EXPECT_EQ(row(batch).attempt, 1);
  const auto log = publisher.log(batch);
  EXPECT_EQ(log.topologies.size(), 1U) << "its viewers have its triangles";
  for (std::size_t i = 1; i < log.frames.size(); ++i) {
    EXPECT_EQ(log.frames[i]->seq, log.frames[i - 1]->seq + 1);
    EXPECT_GT(log.frames[i]->step, log.frames[i - 1]->step) << "none is draped twice";
  }
}

TEST_F(JobSlices, MoreDrapesThanThereIsMemoryForTakeTurnsAndEndInTheBytesOfOneGo) {
  settings.max_parked = 1;
  start_one();
  std::vector<store::RequestContext> owners;
  std::vector<std::string> jobs;
  for (int i = 0; i < 5; ++i) {
    owners.emplace_back("owner" + std::to_string(i));
    jobs.push_back(submit_as(owners.back(), cloth_over_block(1000 + 10 * i, 3)));
  }
  for (const std::string& job : jobs) {
    ASSERT_TRUE(publisher.wait_for_frames(job, 1));
    EXPECT_LE(service->counts().in_memory, 2);
  }
  for (std::size_t i = 0; i < jobs.size(); ++i)
    EXPECT_FALSE(store::is_final(state(jobs[i], owners[i]))) << "all have begun before the first has ended";
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    ASSERT_TRUE(publisher.wait_for_end(jobs[i]));
    const store::JobRow ended = store.job(owners[i], jobs[i]).value();
    ASSERT_EQ(ended.state, store::JobState::kSucceeded) << ended.reason;
    const auto input = jobs::drape_input_of(documents, owners[i], ended.document, ended.files).value();
    EXPECT_EQ(hash_in(ended), hash_of(drape::drape(input, {}, nullptr).value().positions));
    EXPECT_EQ(publisher.log(jobs[i]).topologies.size(), 1U);
  }
}

TEST_F(JobSlices, WhatWasPutAsideCanBePausedResumedEditedAndCancelled) {
  settings.max_parked = 0;
  start_one();
  const std::string batch = submit_as(kOwner, cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(batch, 2));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210, kEndless), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(urgent, 1));
  ASSERT_TRUE(service->pause(kOwner, batch)) << "it takes no memory";
  ASSERT_TRUE(service->resume(kOwner, batch));
  ASSERT_TRUE(service->cancel(kOwner, urgent));
  const std::size_t had = frames(batch);
  ASSERT_TRUE(publisher.wait_for_frames(batch, had + 2)) << "it goes on";
  const std::string next = submit_as(kOwner, cloth_over_block(220, kEndless), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(next, 1));
  const auto edited = service->go_on(kOwner, batch, "");
  ASSERT_TRUE(edited) << to_string(edited.error());
  EXPECT_TRUE(row(edited->id).files.contains(jobs::kShapeFile)) << "from how it hung when it was put aside";
  EXPECT_EQ(state(batch), store::JobState::kCancelled);
  EXPECT_FALSE(store.checkpoint(kOwner, batch));
}

TEST_F(JobSlices, WhatTheStoreDoesNotTakeStaysInMemory) {
  settings.max_parked = 0;
  store.on_put_checkpoint = [](const std::string&) {
    return Error{"store.full", "the disk has no room", "", ErrorKind::kNoRoom};
  };
  start_one();
  const std::string batch = submit_as(kOwner, cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_frames(batch, 1));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(urgent, 1));
  EXPECT_EQ(state(batch), store::JobState::kSucceeded) << "it went on to its end";
}

TEST_F(JobSlices, AStopFindsWhatWasPutAsideWhereItStands) {
  settings.max_parked = 0;
  settings.checkpoint_every_s = 3600;
  start_one();
  const std::string batch = submit_as(kOwner, cloth_over_block(200, 1.5));
  ASSERT_TRUE(publisher.wait_for_frames(batch, 2));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210, kEndless), kInteractive);
  ASSERT_TRUE(publisher.wait_for_frames(urgent, 1));
  service->stop();
  EXPECT_EQ(state(batch), store::JobState::kQueued);
  make(1);
  ASSERT_TRUE(service->start());
  ASSERT_TRUE(service->cancel(kOwner, urgent));
  ASSERT_TRUE(publisher.wait_for_end(batch, 2));
  EXPECT_EQ(hash_in(row(batch)), hash_of_alone(row(batch)));
  EXPECT_GT(publisher.log(batch).ended.back().first_step, 0);
}

TEST_F(JobSlices, AnExpressWorkerBeginsWhatOthersHaveNoTimeFor) {
  settings.express = 1;
  make(1);
  ASSERT_TRUE(service->start());
  // One that makes no room, as none does while it meshes or waits for pictures.
  const std::string busy = submit_as(kOwner, cloth_over_block(200, kEndless), kInteractive);
  const std::string batch = submit_as(kOwner, cloth_over_block(205, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(busy, 1));
  const std::string urgent = submit_as(kOwner, cloth_over_block(210), kInteractive);
  ASSERT_TRUE(publisher.wait_for_end(urgent));
  EXPECT_EQ(state(urgent), store::JobState::kSucceeded);
  EXPECT_EQ(state(busy), store::JobState::kRunning);
  EXPECT_EQ(state(batch), store::JobState::kQueued) << "batch work is not for it";
}

}  // namespace
}  // namespace toile
