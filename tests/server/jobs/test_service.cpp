#include "server/jobs/service.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/json/tree.h"
#include "core/manifest/manifest.h"
#include "proto/cpp/frame_codec.h"
#include "tests/core/image/pictures.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kEndless;
using test::kOwner;
using Log = test::Recorder::JobLog;

class Jobs : public test::JobHouse {};

TEST_F(Jobs, FourAtOnceOnTwoWorkersEndAsEachDoesAlone) {
  ASSERT_TRUE(service->start().ok());
  std::vector<std::string> ids;
  for (const int size : {180, 190, 200, 210}) ids.push_back(submit(cloth_over_block(size)));
  for (const std::string& id : ids) {
    ASSERT_TRUE(publisher.wait_for_end(id));
    const store::JobRow job = row(id);
    EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason_code << ": " << job.reason;
    EXPECT_EQ(hash_in(job), hash_of_alone(job));
  }
  EXPECT_EQ(service->counts().succeeded, 4);
  EXPECT_GT(service->counts().steps, 4 * 1000);
}

TEST_F(Jobs, ALoneDrapeLeavesItsReportModelsCheckDataAndPictures) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded);
  EXPECT_EQ(job.reason_code, "time");
  EXPECT_EQ(job.attempt, 1);
  EXPECT_GT(job.started_ms, 0);
  EXPECT_GE(job.ended_ms, job.started_ms);
  for (const char* name : {"report.json", "final.glb", "final.hung", "drape.film", "final.obj", "rest.obj",
                           "body.obj", "sewn.json", "manifest.json", "front.png", "back.png", "side.png",
                           "three-quarter.png", "thumbnail.png", "maps.json"}) {
    ASSERT_TRUE(job.results.contains(name)) << name;
    const std::string bytes = store.result_bytes(kOwner, id, name).value();
    EXPECT_EQ(static_cast<std::int64_t>(bytes.size()), job.results.at(name).bytes) << name;
    EXPECT_FALSE(bytes.empty()) << name;
  }
  EXPECT_EQ(job.results.size(), 15u);
  EXPECT_EQ(store.result_bytes(kOwner, id, "report.json").value(), job.report);
  const auto manifest = manifest::parse_manifest(store.result_bytes(kOwner, id, "manifest.json").value());
  ASSERT_TRUE(manifest);
  EXPECT_NE(job.report.find(manifest->positions), std::string::npos) << "the report tells the same hash";
  EXPECT_EQ(manifest->results.size(), 8u);
  for (const manifest::FileMark& file : manifest->results)
    EXPECT_EQ(file.hash, job.results.at(file.name).hash);
  EXPECT_EQ(manifest->document.hash,
            manifest::mark_of("", project::parse_project(job.document).value()).hash);
  service->stop();
  for (const auto& entry : std::filesystem::directory_iterator(store.scratch_folder())) {
    EXPECT_TRUE(entry.is_regular_file()) << entry.path() << " is left over";
  }
}

TEST_F(Jobs, ShowThePicturesOnTheirPieces) {
  ASSERT_TRUE(service->start().ok());
  const std::string checks = test::png_of(test::squares());
  store::AssetRow asset;
  asset.kind = "image";
  asset.name = "checks.png";
  const std::string picture = store.put_asset(kOwner, asset, checks).value().id;
  std::string document = cloth_over_block(200, 0.1);
  const std::string cloth = R"("fabric": "cotton", "placement")";
  document.replace(document.find(cloth), cloth.size(),
                   R"("texture": {"image": "checks.png", "scale_mm": 40}, )" + cloth);
  const auto submit_with = [&](const std::map<std::string, std::string>& more) {
    store::ProjectRow project = store.project(kOwner, project_of(document)).value();
    project.files.insert(more.begin(), more.end());
    const std::string id = store.create_project(kOwner, project, "").value().id;
    const std::string job = service->submit(kOwner, id, "").value().id;
    EXPECT_TRUE(publisher.wait_for_end(job));
    return row(job);
  };
  const store::JobRow shown = submit_with({{"checks.png", picture}});
  EXPECT_EQ(shown.state, store::JobState::kSucceeded) << shown.reason;
  EXPECT_NE(store.result_bytes(kOwner, shown.id, "final.glb").value().find(checks), std::string::npos);
  const store::JobRow plain = submit_with({});
  EXPECT_EQ(plain.state, store::JobState::kSucceeded) << "a drape is worth keeping without its pictures";
  EXPECT_NE(plain.reason.find("checks.png"), std::string::npos) << plain.reason;
  EXPECT_EQ(hash_in(shown), hash_in(plain)) << "looks move no cloth";
}

TEST_F(Jobs, ViewersSeeTheTopologyFirstThenFramesWithoutGapsThatEndWhereTheReportDoes) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  const Log log = publisher.log(id);
  ASSERT_EQ(log.topologies.size(), 1u);
  EXPECT_LT(log.order.find('T'), log.order.find('F'));
  EXPECT_EQ(log.order.back(), 'e');
  const proto::DecodedTopology topology = proto::decode_topology(log.topologies[0]->bytes).value();
  EXPECT_EQ(topology.epoch, log.topologies[0]->epoch);
  ASSERT_EQ(topology.pieces.size(), 1u);
  EXPECT_EQ(topology.pieces[0].id, "cloth");

  ASSERT_GT(log.frames.size(), 20u);
  EXPECT_EQ(log.frames.front()->step, 0);
  std::vector<std::int16_t> before;
  for (std::size_t i = 0; i < log.frames.size(); ++i) {
    const jobs::StreamFrame& frame = *log.frames[i];
    ASSERT_EQ(frame.seq, i + 1);
    ASSERT_EQ(frame.epoch, topology.epoch);
    if (i == 0) {
      EXPECT_TRUE(frame.delta.empty());
    } else {
      const Result<proto::DecodedFrame> decoded = proto::decode_frame(frame.delta, before);
      ASSERT_TRUE(decoded.ok()) << to_string(decoded.error());
      ASSERT_EQ(decoded->grid, frame.grid);
      ASSERT_EQ(decoded->header.seq, frame.seq);
      ASSERT_EQ(decoded->header.step, frame.step);
    }
    if (i + 1 < log.frames.size()) {
      ASSERT_EQ(frame.step, static_cast<int>(i) * settings.stream_interval);
    }
    before = frame.grid;
  }

  const drape::DrapeResult end = alone(row(id));
  const std::vector<Vec3> shown = proto::dequantise(log.frames.back()->grid, topology.grid);
  EXPECT_EQ(log.frames.back()->step, end.steps);
  ASSERT_EQ(shown.size(), end.positions.size());
  for (std::size_t v = 0; v < shown.size(); ++v) {
    const Vec3 d = shown[v] - end.positions[v];
    for (const double off : {d.x, d.y, d.z}) ASSERT_LE(std::fabs(off), 0.05e-3 + 1e-12) << v;
  }
}

TEST_F(Jobs, ProgressIsToldWithFiguresAndNotMoreThanTenTimesASecond) {
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, 6));
  ASSERT_TRUE(publisher.wait_for_end(id));
  const Log log = publisher.log(id);
  ASSERT_GE(log.progress.size(), 4u);
  EXPECT_EQ(log.progress.front().progress.state, store::JobState::kQueued);
  EXPECT_EQ(log.progress.front().progress.phase, "queued");
  std::string phases;
  std::vector<test::Recorder::Clock::time_point> draping;
  for (std::size_t i = 1; i < log.progress.size(); ++i) {
    const jobs::JobProgress& now = log.progress[i].progress;
    EXPECT_EQ(now.state, store::JobState::kRunning);
    EXPECT_GE(now.step, log.progress[i - 1].progress.step);
    if (now.phase != log.progress[i - 1].progress.phase) phases += now.phase + " ";
    if (now.phase == "drape") draping.push_back(log.progress[i].at);
  }
  const double seconds = std::chrono::duration<double>(draping.back() - draping.front()).count();
  EXPECT_LE(static_cast<double>(draping.size()), 10 * seconds + 2);
  EXPECT_EQ(phases, "mesh drape stills ") << "a running job that has not begun is still in phase queued";
  ASSERT_EQ(log.ended.size(), 1u);
  const jobs::JobProgress& last = log.ended[0];
  EXPECT_EQ(last.state, store::JobState::kSucceeded);
  EXPECT_EQ(last.step, static_cast<int>(*json::parse_json(row(id).report).value().find("steps")->number()));
  EXPECT_NEAR(last.simulated_s, 6, 1e-3);
  EXPECT_GT(last.step_ms, 0);
  EXPECT_EQ(service->counts().steps, last.step);
  const jobs::JobProgress later = service->progress(kOwner, id).value();
  EXPECT_EQ(later.state, store::JobState::kSucceeded);
  EXPECT_EQ(later.step, last.step) << "from the row's report";
}

TEST_F(Jobs, APausedDrapeFreesItsWorkerAndEndsAsIfNothingHadHappened) {
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string first = submit(cloth_over_block(200, 8));
  ASSERT_TRUE(publisher.wait_for_frames(first, 3));
  const Result<store::JobRow> paused = service->pause(kOwner, first);
  ASSERT_TRUE(paused.ok()) << to_string(paused.error());
  EXPECT_EQ(paused->state, store::JobState::kPaused);
  EXPECT_EQ(row(first).state, store::JobState::kPaused);
  ASSERT_TRUE(publisher.wait_for_state(first, store::JobState::kPaused));
  EXPECT_EQ(service->counts().paused, 1);
  const std::size_t frames = publisher.log(first).frames.size();

  const std::string second = submit(cloth_over_block(190));
  ASSERT_TRUE(publisher.wait_for_end(second)) << "the only worker takes other work";
  EXPECT_EQ(publisher.log(first).frames.size(), frames) << "and does not touch the paused drape";

  EXPECT_EQ(service->resume(kOwner, first)->state, store::JobState::kQueued);
  ASSERT_TRUE(publisher.wait_for_end(first));
  const store::JobRow job = row(first);
  EXPECT_EQ(job.state, store::JobState::kSucceeded);
  EXPECT_EQ(job.attempt, 1) << "a pause is no new attempt";
  EXPECT_EQ(publisher.log(first).topologies.size(), 1u) << "and no new epoch";
  EXPECT_EQ(hash_in(job), hash_of_alone(job));
}

TEST_F(Jobs, APausedDrapesRowTellsAllWorkOnceItIsToldPaused) {
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(id, 3));
  ASSERT_TRUE(service->pause(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  double spent = 0;
  for (const auto& [phase, seconds] : service->counts().work_s) spent += seconds;
  EXPECT_GT(spent, 0);
  EXPECT_NEAR(static_cast<double>(row(id).worked_ms), 1000 * spent, 1) << "and no heartbeat came";
}

TEST_F(Jobs, AResumedDrapeGoesBeforeThoseThatWait) {
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string first = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(first, 2));
  ASSERT_TRUE(service->pause(kOwner, first).ok());
  const std::string second = submit(cloth_over_block(190, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(second, 1));
  const std::string third = submit(cloth_over_block(180));
  ASSERT_TRUE(service->resume(kOwner, first).ok());
  ASSERT_TRUE(service->cancel(kOwner, second).ok());
  const std::size_t had = publisher.log(first).frames.size();
  ASSERT_TRUE(publisher.wait_for_frames(first, had + 1));
  EXPECT_EQ(row(third).state, store::JobState::kQueued);
  ASSERT_TRUE(service->cancel(kOwner, first).ok());
  ASSERT_TRUE(publisher.wait_for_end(third));
}

TEST_F(Jobs, APauseIsUndoneAtOnceWithoutLosingTheDrape) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, 6));
  ASSERT_TRUE(publisher.wait_for_frames(id, 2));
  for (int i = 0; i < 20; ++i) {  // the worker may or may not have seen the pause when the job is resumed
    const Result<store::JobRow> paused = service->pause(kOwner, id);
    if (!paused) {
      EXPECT_EQ(paused.error().code, "jobs.state") << "only while it waits for its worker";
    }
    static_cast<void>(service->resume(kOwner, id).ok());
  }
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded);
  EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
}

TEST_F(Jobs, AQueuedJobIsPausedAndCancelledWithoutAWorker) {
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string busy = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(busy, 1));
  const std::string waiting = submit(cloth_over_block(190));
  EXPECT_EQ(service->counts().queued, 1);
  ASSERT_TRUE(service->pause(kOwner, waiting).ok());
  EXPECT_EQ(service->counts().queued, 0);
  EXPECT_EQ(service->counts().paused, 1);
  EXPECT_EQ(service->pause(kOwner, waiting).error().code, "jobs.state");
  EXPECT_EQ(service->resume(kOwner, waiting)->state, store::JobState::kQueued);
  const Result<store::JobRow> cancelled = service->cancel(kOwner, waiting);
  ASSERT_TRUE(cancelled.ok());
  EXPECT_EQ(cancelled->state, store::JobState::kCancelled);
  EXPECT_EQ(publisher.log(waiting).ended.at(0).state, store::JobState::kCancelled);
  EXPECT_EQ(row(waiting).reason_code, "cancelled");
  EXPECT_GT(row(waiting).ended_ms, 0);
  EXPECT_TRUE(publisher.log(waiting).topologies.empty());
  EXPECT_EQ(service->cancel(kOwner, waiting).error().code, "jobs.state") << "it has ended";
}

TEST_F(Jobs, ARunningDrapeThatIsCancelledSaysSoLast) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(id, 5));
  EXPECT_EQ(service->cancel(kOwner, id)->state, store::JobState::kCancelled);
  ASSERT_TRUE(publisher.wait_for_end(id));
  service->stop();
  EXPECT_EQ(publisher.log(id).ended.size(), 1u);
  EXPECT_EQ(publisher.log(id).ended[0].state, store::JobState::kCancelled);
  EXPECT_EQ(publisher.log(id).order.back(), 'e') << "nothing comes after the last word";
  EXPECT_EQ(row(id).state, store::JobState::kCancelled);
  EXPECT_TRUE(row(id).report.empty());
  EXPECT_EQ(service->counts().cancelled, 1);
  EXPECT_EQ(service->progress(kOwner, id)->state, store::JobState::kCancelled);
}

TEST_F(Jobs, ARunningDrapeSeesACancelWithinFiftyMilliseconds) {
  ASSERT_TRUE(service->start().ok());
  double quickest = 1e9;  // of a few: the machine may be busy with something else
  for (int i = 0; i < 5; ++i) {
    const std::string id = submit(cloth_over_block(200, kEndless));
    ASSERT_TRUE(publisher.wait_for_frames(id, 3));
    const auto asked = test::Recorder::Clock::now();
    ASSERT_TRUE(service->cancel(kOwner, id).ok());
    ASSERT_TRUE(publisher.wait_for_end(id));
    quickest =
        std::min(quickest, std::chrono::duration<double>(test::Recorder::Clock::now() - asked).count());
  }
  EXPECT_LT(quickest, 0.05);
}

TEST_F(Jobs, APausedDrapeIsCancelledAtOnce) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(id, 2));
  ASSERT_TRUE(service->pause(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  ASSERT_TRUE(service->cancel(kOwner, id).ok());
  EXPECT_EQ(publisher.log(id).ended.size(), 1u);
  EXPECT_EQ(service->counts().paused, 0);
  EXPECT_EQ(service->resume(kOwner, id).error().code, "jobs.state");
}

TEST_F(Jobs, NoMoreDrapesLiePausedThanThereIsRoomFor) {
  settings.max_parked = 1;
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string first = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(first, 1));
  ASSERT_TRUE(service->pause(kOwner, first).ok());
  const std::string second = submit(cloth_over_block(190, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(second, 1));
  EXPECT_EQ(service->pause(kOwner, second).error().code, "jobs.too_many_paused");
  ASSERT_TRUE(service->cancel(kOwner, first).ok());
  EXPECT_TRUE(service->pause(kOwner, second).ok());
}

TEST_F(Jobs, AFullQueueRefusesWhatComes) {
  settings.max_queued = 1;
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string busy = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(busy, 1));
  const std::string waiting = submit(cloth_over_block(190));
  const std::string project = project_of(cloth_over_block(180));
  EXPECT_EQ(service->submit(kOwner, project, "").error().code, "jobs.queue_full");
  ASSERT_TRUE(service->pause(kOwner, waiting).ok());
  EXPECT_EQ(service->submit(kOwner, project, "").error().code, "jobs.queue_full")
      << "what waits paused will come back";
}

TEST_F(Jobs, TheSameKeyGivesTheSameJob) {
  ASSERT_TRUE(service->start().ok());
  const std::string project = project_of(cloth_over_block(200));
  const std::string first = service->submit(kOwner, project, "once")->id;
  EXPECT_EQ(service->submit(kOwner, project, "once")->id, first);
  ASSERT_TRUE(publisher.wait_for_end(first));
  EXPECT_EQ(service->submit(kOwner, project, "once")->id, first);
  EXPECT_EQ(service->counts().queued + service->counts().running, 0) << "and it is not draped again";
  EXPECT_NE(service->submit(kOwner, project, "twice")->id, first);
}

TEST_F(Jobs, ARetryGivesTheJobOfThenWhateverBecameOfTheProjectAndTheQueue) {
  settings.max_queued = 1;
  make(1);
  ASSERT_TRUE(service->start());
  const std::string busy = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(busy, 1));
  const std::string project = project_of(cloth_over_block(200)), other = project_of(cloth_over_block(190));
  const auto first = service->submit(kOwner, project, "once");
  ASSERT_TRUE(first && first->anew);
  const auto refused = service->submit(kOwner, other, "");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "jobs.queue_full");
  store::ProjectRow edited = store.project(kOwner, project).value();
  edited.document = cloth_over_block(180);
  edited.revision = 2;
  ASSERT_TRUE(store.replace_project(kOwner, edited, 0));
  for (int i = 0; i < 2; ++i) {
    const auto retry = service->submit(kOwner, project, "once");
    ASSERT_TRUE(retry) << to_string(retry.error());
    EXPECT_EQ(retry->id, first->id);
    EXPECT_FALSE(retry->anew);
    EXPECT_TRUE(store.remove_project(kOwner, project, 0));
  }
  EXPECT_EQ(service->counts().queued, 1);
}

TEST_F(Jobs, BelongToTheirOwnerOnly) {
  ASSERT_TRUE(service->start().ok());
  const std::string project = project_of(cloth_over_block(200, kEndless));
  EXPECT_EQ(service->submit(store::RequestContext("bob"), project, "").error().code, "store.not_found");
  const std::string id = service->submit(kOwner, project, "")->id;
  EXPECT_EQ(service->cancel(store::RequestContext("bob"), id).error().code, "store.not_found");
  EXPECT_EQ(service->progress(store::RequestContext("bob"), id).error().code, "store.not_found");
  EXPECT_EQ(service->pause(kOwner, "j_none").error().code, "store.not_found");
  EXPECT_TRUE(service->cancel(kOwner, id).ok());
}

TEST_F(Jobs, AStopPutsRunningDrapesBackIntoTheQueueLeavesPausedOnesPausedAndANewStartGoesOn) {
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string parked = submit(cloth_over_block(190, 6));
  ASSERT_TRUE(publisher.wait_for_frames(parked, 2));
  ASSERT_TRUE(service->pause(kOwner, parked).ok());
  const std::string running = submit(cloth_over_block(200, 6));
  const std::string waiting = submit(cloth_over_block(180));
  ASSERT_TRUE(publisher.wait_for_frames(running, 2));
  service->stop();
  service->stop();
  for (const std::string& id : {parked, running, waiting}) {
    const store::JobState left = id == parked ? store::JobState::kPaused : store::JobState::kQueued;
    EXPECT_EQ(row(id).state, left);
    EXPECT_EQ(row(id).attempt, 0) << "an orderly stop is no attempt";
    ASSERT_EQ(publisher.log(id).ended.size(), 1u);
    EXPECT_EQ(publisher.log(id).ended[0].state, left);
    EXPECT_EQ(publisher.log(id).order.back(), 'e');
  }
  EXPECT_EQ(row(running).reason_code, "requeued");
  EXPECT_EQ(service->cancel(kOwner, running).error().code, "jobs.stopped");

  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(waiting, 2)) << "the last of the queue";
  EXPECT_EQ(row(parked).state, store::JobState::kPaused) << "until somebody resumes it";
  ASSERT_TRUE(service->resume(kOwner, parked).ok());
  for (const std::string& id : {parked, running, waiting}) {
    ASSERT_TRUE(publisher.wait_for_end(id, 2));
    const store::JobRow job = row(id);
    EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
    EXPECT_EQ(job.attempt, 1);
    EXPECT_EQ(hash_in(job), hash_of_alone(job));
  }
  const Log log = publisher.log(running);
  ASSERT_EQ(log.topologies.size(), 2u);
  EXPECT_GT(log.topologies[1]->epoch, log.topologies[0]->epoch)
      << "frames of both attempts cannot be mixed up";
}

TEST_F(Jobs, WhatIsSubmittedBeforeTheStartIsDrapedAfterIt) {
  const std::string id = submit(cloth_over_block(200));
  EXPECT_EQ(row(id).state, store::JobState::kQueued);
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded);
}

TEST_F(Jobs, ADrapeThatRanAloneInThreeCrashesFailsAndOneOfTwoIsTriedAgain) {
  const std::string again = submit(cloth_over_block(200));
  const std::string paused = submit(cloth_over_block(180));
  const auto cut_off = [&](const std::string& id, int attempt) {
    store.tamper(kOwner, id, [&](store::JobRow& row) {
      row.state = store::JobState::kRunning;
      row.attempt = attempt;
    });
  };
  store.tamper(kOwner, paused, [](store::JobRow& row) {
    row.state = store::JobState::kPaused;
    row.attempt = 3;
  });
  cut_off(again, 2);
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(again));
  EXPECT_EQ(row(again).state, store::JobState::kSucceeded);
  EXPECT_EQ(row(again).reason_code, "time");
  EXPECT_EQ(row(again).attempt, 1) << "counted anew since it was draped: pictures have tries of their own";
  service->stop();
  const std::string never = submit(cloth_over_block(190));  // now, so that it has come no way before
  cut_off(never, 3);
  ASSERT_TRUE(service->start().ok());
  EXPECT_EQ(row(never).state, store::JobState::kFailed);
  EXPECT_EQ(row(never).reason_code, "jobs.attempts");
  EXPECT_NE(row(never).reason.find("3 times"), std::string::npos) << row(never).reason;
  ASSERT_TRUE(service->resume(kOwner, paused).ok());
  ASSERT_TRUE(publisher.wait(paused, [](const Log& log) {
    return !log.ended.empty() && log.ended.back().state == store::JobState::kSucceeded;
  })) << "a pause breaks nothing down";
}

TEST_F(Jobs, ManyHandsAtOnceLeaveEveryJobWithOneLastWord) {
  ASSERT_TRUE(service->start().ok());
  std::vector<std::string> ids;
  for (int i = 0; i < 6; ++i) ids.push_back(submit(cloth_over_block(180 + i, 3)));
  const auto fiddle = [&](unsigned seed) {
    for (int i = 0; i < 200; ++i) {
      seed = seed * 1664525u + 1013904223u;
      const std::string& id = ids[(seed >> 16) % ids.size()];
      if ((seed >> 8) % 3 == 0) {
        static_cast<void>(service->pause(kOwner, id).ok());
      } else {
        static_cast<void>(service->resume(kOwner, id).ok());
      }
      EXPECT_TRUE(service->progress(kOwner, id).ok());
      EXPECT_LE(service->counts().running, settings.workers);
      if (i == 150 && seed % 2 == 0) static_cast<void>(service->cancel(kOwner, id).ok());
    }
  };
  {
    std::vector<std::jthread> hands;
    for (unsigned h = 1; h <= 4; ++h) hands.emplace_back(fiddle, h);
  }
  for (const std::string& id : ids) static_cast<void>(service->resume(kOwner, id).ok());
  for (const std::string& id : ids) {
    ASSERT_TRUE(publisher.wait_for_end(id)) << store::name_of(row(id).state);
    const Log log = publisher.log(id);
    EXPECT_EQ(log.ended.size(), 1u);
    EXPECT_EQ(log.order.back(), 'e');
    EXPECT_EQ(log.ended[0].state, row(id).state);
    EXPECT_TRUE(row(id).state == store::JobState::kSucceeded || row(id).state == store::JobState::kCancelled)
        << row(id).reason;
    if (row(id).state == store::JobState::kSucceeded) {
      EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
    }
  }
}

}  // namespace
}  // namespace toile
