// The job service over the store that the server uses.

#include <unistd.h>

#include "core/json/tree.h"
#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/jobs/service.h"
#include "server/store/sqlite/open.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
using test::kOwner;

class JobsInSqlite : public testing::Test {
 protected:
  JobsInSqlite()
      : folder_(fs::path(testing::TempDir()) / ("toile_jobs_in_sqlite_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    open();
  }
  ~JobsInSqlite() override {
    close();
    fs::remove_all(folder_);
  }

  void open() {
    store_ = sqlite::open_sqlite_store(folder_.string()).value();
    documents_ = std::make_unique<documents::Documents>(*store_);
    jobs::JobServiceSettings settings;
    settings.still_width = 64;
    settings.still_height = 80;
    service_ = jobs::make_job_service(*documents_, publisher_, settings);
    EXPECT_TRUE(service_->start().ok());
  }
  void close() {
    service_.reset();
    documents_.reset();
    store_.reset();
  }

  std::string submit(double max_time) {
    const store::AssetRow block =
        documents::add_asset(*documents_, kOwner, "body", "block.obj", test::kBlock).value();
    const auto project = documents::create_project(*documents_, kOwner, test::cloth_over_block(200, max_time),
                                                   {{"block.obj", block.id}});
    EXPECT_TRUE(project.ok()) << to_string(project.error());
    return service_->submit(kOwner, project->id, "").value().id;
  }

  fs::path folder_;
  test::Recorder publisher_;
  std::unique_ptr<store::Store> store_;
  std::unique_ptr<documents::Documents> documents_;
  std::unique_ptr<jobs::JobService> service_;
};

TEST_F(JobsInSqlite, ADrapeAndItsResultsAreThereAfterARestart) {
  const std::string id = submit(1);
  ASSERT_TRUE(publisher_.wait_for_end(id));
  close();
  open();
  const store::JobRow job = store_->job(kOwner, id).value();
  EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  EXPECT_EQ(job.results.size(), 15u);
  for (const auto& [name, file] : job.results) {
    EXPECT_EQ(static_cast<std::int64_t>(store_->result_bytes(kOwner, id, name).value().size()), file.bytes);
  }
  EXPECT_EQ(service_->progress(kOwner, id)->step,
            static_cast<int>(*json::parse_json(job.report).value().find("steps")->number()));
}

TEST_F(JobsInSqlite, ADrapeThatAStopCutOffIsEndedByTheNextServer) {
  const std::string id = submit(5);
  ASSERT_TRUE(publisher_.wait_for_frames(id, 2));
  close();
  ASSERT_EQ(publisher_.log(id).ended.size(), 1u);
  EXPECT_EQ(publisher_.log(id).ended[0].state, store::JobState::kQueued);
  open();
  ASSERT_TRUE(publisher_.wait_for_end(id, 2));
  const store::JobRow job = store_->job(kOwner, id).value();
  EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  EXPECT_EQ(job.attempt, 1);
}

}  // namespace
}  // namespace toile
