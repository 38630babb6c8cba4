// Jobs that workers take from the store through leases: the same whether the workers are the server's own
// threads or another process beside it (here another store over the same folder).

#include <unistd.h>

#include <chrono>
#include <thread>

#include "core/base/hash.h"
#include "core/json/tree.h"
#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/jobs/input.h"
#include "server/store/sqlite/open.h"
#include "tests/server/jobs/house.h"
#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

using store::JobState;
using test::kOwner;

/// False after two minutes.
bool wait_for(const std::function<bool()>& holds) {
  for (int waited = 0; waited < 12000; ++waited) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// A store with what works on it, as a process has them.
struct House {
  House(std::unique_ptr<store::Store> opened, jobs::JobServiceSettings settings) : store(std::move(opened)) {
    settings.still_width = 64;
    settings.still_height = 80;
    settings.checkpoint_every_s = 0.05;
    settings.heartbeat_s = 0.1;
    settings.lease_s = 60;
    service = jobs::make_job_service(documents, publisher, settings);
    EXPECT_TRUE(service->start());
  }

  std::unique_ptr<store::Store> store;
  documents::Documents documents{*store};
  test::Recorder publisher;
  std::unique_ptr<jobs::JobService> service;
};

jobs::JobServiceSettings with_workers(int workers) {
  jobs::JobServiceSettings settings;
  settings.workers = workers;
  return settings;
}

enum class Shape { kThreads, kProcess };

class Leases : public testing::TestWithParam<Shape> {
 protected:
  void SetUp() override {
    const bool threads = GetParam() == Shape::kThreads;
    server = std::make_unique<House>(opened(folder.path()), with_workers(threads ? 2 : 0));
    if (!threads) worker = join();
  }
  /// A process that works beside the server.
  std::unique_ptr<House> join() {
    return std::make_unique<House>(std::move(*sqlite::join_sqlite_store(folder.path())), with_workers(2));
  }
  House& whoever_works() { return worker ? *worker : *server; }

  std::string submit(double max_time, int size = 200) {
    const store::AssetRow block =
        documents::add_asset(server->documents, kOwner, "body", "block.obj", test::kBlock).value();
    const auto project = documents::create_project(
        server->documents, kOwner, test::cloth_over_block(size, max_time), {{"block.obj", block.id}});
    EXPECT_TRUE(project.ok()) << to_string(project.error());
    return server->service->submit(kOwner, project->id, "").value().id;
  }
  store::JobRow row(const std::string& id) { return server->store->job(kOwner, id).value(); }
  bool becomes(const std::string& id, JobState state) {
    return wait_for([&] { return row(id).state == state; });
  }
  std::string hash_of_alone(const std::string& id) {
    const store::JobRow job = row(id);
    const drape::DrapeInput input =
        jobs::drape_input_of(server->documents, kOwner, job.document, job.files).value();
    return hash_of(drape::drape(input, {}, nullptr).value().positions);
  }
  std::string hash_in(const std::string& id) {
    return *json::parse_json(row(id).report).value().find("hash")->text();
  }

  TemporaryFolder folder;
  std::unique_ptr<House> server, worker;
};

INSTANTIATE_TEST_SUITE_P(OverBothShapes, Leases, testing::Values(Shape::kThreads, Shape::kProcess),
                         [](const auto& shape) {
                           return shape.param == Shape::kThreads ? "Threads" : "Process";
                         });

TEST_P(Leases, GiveTheSameBytesAsADrapeAloneAndEndWithIt) {
  const std::string id = submit(1);
  ASSERT_TRUE(server->publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, JobState::kSucceeded) << row(id).reason;
  EXPECT_EQ(hash_in(id), hash_of_alone(id));
  EXPECT_EQ(row(id).lease.number, 1);
  EXPECT_EQ(row(id).lease.holder, "");
  EXPECT_EQ(row(id).results.size(), 15u);
  for (const auto& [name, file] : row(id).results) {
    EXPECT_TRUE(server->store->result_bytes(kOwner, id, name).ok()) << name;
  }
}

TEST_P(Leases, LetWhoeverAsksPauseResumeAndCancel) {
  const std::string id = submit(test::kEndless);
  ASSERT_TRUE(whoever_works().publisher.wait_for_frames(id, 2));
  ASSERT_TRUE(wait_for([&] { return server->service->pause(kOwner, id).ok(); }));
  EXPECT_EQ(row(id).state, JobState::kPaused);
  ASSERT_TRUE(server->service->resume(kOwner, id));
  ASSERT_TRUE(becomes(id, JobState::kRunning));
  ASSERT_TRUE(server->service->cancel(kOwner, id));
  ASSERT_TRUE(whoever_works().publisher.wait(id, [](const auto& log) {
    return !log.ended.empty() && log.ended.back().state == JobState::kCancelled;
  }));
  EXPECT_EQ(row(id).state, JobState::kCancelled);
  EXPECT_TRUE(wait_for([&] { return server->service->remove(kOwner, id).ok(); }));
}

TEST_P(Leases, GoBackWhenAWorkerStopsAndAnotherEndsItsDrapeInTheSameBytes) {
  const std::string id = submit(5);
  ASSERT_TRUE(whoever_works().publisher.wait_for_frames(id, 2));
  whoever_works().service->stop();
  EXPECT_EQ(row(id).state, JobState::kQueued);
  EXPECT_EQ(row(id).lease.holder, "");
  const std::unique_ptr<House> next = join();
  ASSERT_TRUE(becomes(id, JobState::kSucceeded)) << row(id).reason;
  EXPECT_EQ(hash_in(id), hash_of_alone(id));
  EXPECT_EQ(row(id).lease.number, 2);
  EXPECT_EQ(row(id).attempt, 1);
}

TEST_P(Leases, ShowTheServerHowFarADrapeIs) {
  const std::string id = submit(test::kEndless);
  EXPECT_TRUE(wait_for([&] { return server->service->progress(kOwner, id)->step > 0; }));
  EXPECT_EQ(server->service->progress(kOwner, id)->state, JobState::kRunning);
  EXPECT_EQ(server->service->counts().running, 1);
}

TEST_P(Leases, OfAProcessThatIsNoMoreAreTakenOverAtOnce) {
  const std::string id = submit(test::kEndless);
  ASSERT_TRUE(whoever_works().publisher.wait_for_frames(id, 2));
  whoever_works().service->stop();
  const auto left = server->store->change_job(kOwner, id, [](store::JobRow& job) -> Status {
    job.state = JobState::kRunning;
    job.started_ms = 1;
    job.lease = {"h_nobody", job.lease.number + 1, std::int64_t{1} << 60};
    return {};
  });
  ASSERT_TRUE(left);
  const std::unique_ptr<House> next = join();
  ASSERT_TRUE(wait_for([&] { return row(id).lease.number > left->lease.number; }));
  EXPECT_EQ(row(id).lease.holder, next->store->holder());
}

TEST_P(Leases, ThatWereLostStopADrapeAndItsEndIsNotKept) {
  const std::string id = submit(test::kEndless);
  ASSERT_TRUE(whoever_works().publisher.wait_for_frames(id, 2));
  ASSERT_TRUE(wait_for([&] { return server->store->checkpoint(kOwner, id).ok(); }));
  const std::unique_ptr<store::Store> other = std::move(*sqlite::join_sqlite_store(folder.path()));
  const auto taken = other->change_job(kOwner, id, [&](store::JobRow& job) -> Status {
    job.lease = {other->holder(), job.lease.number + 1, std::int64_t{1} << 60};
    return {};
  });
  ASSERT_TRUE(taken);
  // Whoever had it lets go, and touches nothing: no checkpoint of its own comes any more.
  ASSERT_TRUE(wait_for([&] {
    const std::size_t before = whoever_works().publisher.log(id).frames.size();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return whoever_works().publisher.log(id).frames.size() == before;
  }));
  EXPECT_EQ(row(id).lease, taken->lease);
  EXPECT_EQ(row(id).state, JobState::kRunning);
  store::RequestContext late = kOwner;
  late.lease = taken->lease.number - 1;
  EXPECT_EQ(code_of(other->put_result(late, id, "report.json", "{}")), "store.lease_lost");
  EXPECT_EQ(code_of(other->put_checkpoint(late, id, "late")), "store.lease_lost");
  EXPECT_NE(other->checkpoint(kOwner, id)->bytes, "late");
}

}  // namespace
}  // namespace toile
