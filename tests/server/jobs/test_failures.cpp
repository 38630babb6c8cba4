// What goes wrong in a job fails that job with its reason, and nothing else.

#include <new>
#include <stdexcept>

#include "server/store/store.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kEndless;
using test::kOwner;

class JobFailures : public test::JobHouse {
 protected:
  std::string changed(std::string document, const std::string& from, const std::string& to) {
    const std::size_t at = document.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return document.replace(at, from.size(), to);
  }

  /// The service still works.
  void expect_alive() {
    const std::string id = submit(cloth_over_block(210));
    ASSERT_TRUE(publisher.wait_for_end(id));
    EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
  }
};

TEST_F(JobFailures, ABadDocumentIsRefusedAtSubmissionWithCodeAndPlace) {
  ASSERT_TRUE(service->start().ok());
  const std::string silk = changed(cloth_over_block(200), R"("fabric": "cotton")", R"("fabric": "silk")");
  const auto unknown = service->submit(kOwner, project_of(silk), "");
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, "project.unknown_fabric");
  EXPECT_EQ(unknown.error().where.rfind("/pieces/0/fabric", 0), 0u) << unknown.error().where;
  EXPECT_EQ(service->submit(kOwner, project_of("{"), "").error().code, "json.syntax");
  const std::string other = changed(cloth_over_block(200), "block.obj", "other.obj");
  EXPECT_EQ(service->submit(kOwner, project_of(other), "").error().code, "documents.missing_file");
}

TEST_F(JobFailures, ADocumentThatHasGoneBadInTheStoreFailsItsJobWithCodeAndPlace) {
  const std::string id = submit(cloth_over_block(200));
  store.tamper(kOwner, id, [&](store::JobRow& row) {
    row.document = changed(row.document, R"("fabric": "cotton")", R"("fabric": "silk")");
  });
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "project.unknown_fabric");
  EXPECT_EQ(row(id).reason_where.rfind("/pieces/0/fabric", 0), 0u) << row(id).reason_where;
  EXPECT_FALSE(row(id).reason.empty());
  EXPECT_EQ(publisher.log(id).ended.at(0).state, store::JobState::kFailed);
  EXPECT_EQ(service->counts().failed, 1);
  expect_alive();
}

TEST_F(JobFailures, AStartInsideTheBodyFailsWithThePiece) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, 1, "0.05"));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "start.crosses_body");
  EXPECT_NE(row(id).reason_where.find("piece cloth"), std::string::npos) << row(id).reason_where;
  EXPECT_TRUE(publisher.log(id).topologies.empty());
}

TEST_F(JobFailures, WhatIsThrownInADrapeFailsThatJobAloneAndCleanly) {
  ASSERT_TRUE(service->start().ok());
  std::string bad;
  publisher.on_frame = [&](const std::string& id) {
    if (publisher.log(id).frames.size() == 3 && publisher.log(id).topologies.size() == 1 && id == bad) {
      throw std::runtime_error("the wire is cut");
    }
  };
  const std::string project = project_of(cloth_over_block(200));
  service->stop();
  bad = service->submit(kOwner, project, "")->id;
  const std::string good = service->submit(kOwner, project, "")->id;
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(bad));
  ASSERT_TRUE(publisher.wait_for_end(good));
  EXPECT_EQ(row(bad).state, store::JobState::kFailed);
  EXPECT_EQ(row(bad).reason_code, "internal.exception");
  EXPECT_NE(row(bad).reason.find("the wire is cut"), std::string::npos) << row(bad).reason;
  EXPECT_EQ(row(good).state, store::JobState::kSucceeded);
}

TEST_F(JobFailures, TooLittleMemoryFailsTheJobAndNotTheServer) {
  store.on_put_result = [](const std::string&) -> Status { throw std::bad_alloc(); };
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "internal.memory");
  service->stop();
  store.on_put_result = {};
  ASSERT_TRUE(service->start().ok());
  expect_alive();
}

TEST_F(JobFailures, SomethingThatIsNoExceptionIsCaughtToo) {
  store.on_put_result = [](const std::string&) -> Status { throw 7; };
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).reason_code, "internal.unknown");
}

TEST_F(JobFailures, ResultsThatTheStoreDoesNotTakeFailTheJobWithItsReason) {
  store.on_put_result = [](const std::string& name) {
    return name == "final.obj" ? Status(Error{"store.full", "the disk is full", "", ErrorKind::kNoRoom})
                               : Status();
  };
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "store.full");
  EXPECT_TRUE(row(id).results.empty());
}

TEST_F(JobFailures, TheStateThatNamesTheResultsIsWrittenAfterAllOfThem) {
  std::string order;
  store.on_put_result = [&](const std::string&) {
    order += 'r';
    return Status();
  };
  store.on_update_job = [&](const store::JobRow& row) {
    order += row.state == store::JobState::kSucceeded ? 'S' : 's';
    return Status();
  };
  make(1);
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(order, "srrrrrrrrrrsrrrrrS")
      << "a claim, models, maps, film, manifest and report, the drape, pictures, the end: one write each";
}

TEST_F(JobFailures, AChangeThatTheStoreRefusesHasNotHappened) {
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(id, 2));
  std::atomic<bool> full{true};
  service->stop();
  store.on_update_job = [&](const store::JobRow& row) {
    return full && row.state == store::JobState::kPaused
               ? Status(Error{"store.full", "the disk is full", "", ErrorKind::kNoRoom})
               : Status();
  };
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_frames(id, publisher.log(id).frames.size() + 2));
  EXPECT_EQ(service->pause(kOwner, id).error().code, "store.full");
  EXPECT_EQ(service->progress(kOwner, id)->state, store::JobState::kRunning);
  full = false;
  EXPECT_TRUE(service->pause(kOwner, id).ok());
}

TEST_F(JobFailures, AnEndThatTheStoreRefusesIsAFailureWithTheStoresReason) {
  store.on_update_job = [](const store::JobRow& row) {
    return row.state == store::JobState::kSucceeded
               ? Status(Error{"store.full", "the disk is full", "", ErrorKind::kNoRoom})
               : Status();
  };
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "store.full");
}

TEST_F(JobFailures, ASeamThatCannotCloseIsNamedAndTheRestIsAResult) {
  // A tube of two pieces around a block that is too wide for it.
  const std::string document = std::string(R"({"toile": 1, "name": "Narrow", "pieces": [
    {"id": "front", "outline": [
      {"id": "hem", "points": [[0, 0], [80, 0]]}, {"id": "right", "points": [[80, 0], [80, 60]]},
      {"id": "top", "points": [[80, 60], [0, 60]]}, {"id": "left", "points": [[0, 60], [0, 0]]}],
     "fabric": "cotton", "placement": {"rigid": {"translation": [-0.04, 0.02, 0.07]}}},
    {"id": "back", "outline": [
      {"id": "hem", "points": [[0, 0], [80, 0]]}, {"id": "right", "points": [[80, 0], [80, 60]]},
      {"id": "top", "points": [[80, 60], [0, 60]]}, {"id": "left", "points": [[0, 60], [0, 0]]}],
     "fabric": "cotton", "placement": {"rigid": {"translation": [0.04, 0.02, -0.07], "rotation": [0, 180, 0]}}}],
    "fabrics": [)") + test::kCotton +
                               R"(],
    "seams": [{"id": "side", "a": [{"piece": "front", "edge": "right"}], "b": [{"piece": "back", "edge": "left"}]},
              {"id": "other", "a": [{"piece": "front", "edge": "left"}], "b": [{"piece": "back", "edge": "right"}]}],
    "bodies": [{"id": "block", "file": "block.obj", "unit": "m"}],
    "settings": {"particle_distance_mm": 20, "sew_time_s": 0.2, "max_time_s": 4}})";
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(document);
  ASSERT_TRUE(publisher.wait_for_end(id));
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded);
  EXPECT_EQ(job.reason_code, "open_seam") << job.reason << " " << job.reason_where;
  EXPECT_TRUE(job.reason_where == "seam side" || job.reason_where == "seam other") << job.reason_where;
  EXPECT_FALSE(job.report.empty());
  EXPECT_TRUE(job.results.contains("final.glb"));
}

TEST_F(JobFailures, ACancelWhileResultsAreKeptLeavesNone) {
  std::string id;
  store.on_put_result = [&](const std::string& name) -> Status {
    if (name == "thumbnail.png") {  // the last of them
      EXPECT_GT(store.kept_results(kOwner, id), 5u);
      EXPECT_TRUE(service->cancel(kOwner, id));
    }
    return {};
  };
  id = submit(cloth_over_block(200));
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(id));
  service->stop();
  EXPECT_EQ(row(id).state, store::JobState::kCancelled);
  EXPECT_TRUE(row(id).results.empty());
  EXPECT_EQ(store.kept_results(kOwner, id), 0u);
}

TEST_F(JobFailures, ADiskThatFillsUpWhileResultsAreKeptLeavesNone) {
  store.on_put_result = [](const std::string& name) -> Status {
    return name == "report.json" ? Status(Error{"store.full", "the disk has no room", "", ErrorKind::kNoRoom})
                                 : Status();
  };
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait_for_end(id));
  service->stop();
  EXPECT_EQ(row(id).reason_code, "store.full");
  EXPECT_EQ(store.kept_results(kOwner, id), 0u);
}

}  // namespace
}  // namespace toile
