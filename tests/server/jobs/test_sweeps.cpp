// Sweeps over the store that the server uses: drapes that are there are not draped again, and what a stop cut
// off is ended by the next server.

#include <unistd.h>

#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/jobs/service.h"
#include "server/store/sqlite/open.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
using test::kOwner;

class JobSweeps : public testing::Test {
 protected:
  JobSweeps() : folder_(fs::path(testing::TempDir()) / ("toile_sweeps_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    open();
  }
  ~JobSweeps() override {
    close();
    fs::remove_all(folder_);
  }
  void open() {
    store_ = sqlite::open_sqlite_store(folder_.string(), quotas_).value();
    documents_ = std::make_unique<documents::Documents>(*store_);
    settings_.still_width = 64;
    settings_.still_height = 80;
    settings_.engine = "engine";
    service_ = jobs::make_job_service(*documents_, publisher_, settings_);
    EXPECT_TRUE(service_->start().ok());
  }
  void close() {
    service_.reset();
    documents_.reset();
    store_.reset();
  }
  std::string project_of(double max_time) {
    const store::AssetRow block =
        documents::add_asset(*documents_, kOwner, "body", "block.obj", test::kBlock).value();
    const auto project = documents::create_project(*documents_, kOwner, test::cloth_over_block(200, max_time),
                                                   {{"block.obj", block.id}});
    EXPECT_TRUE(project.ok()) << to_string(project.error());
    return project->id;
  }
  static jobs::SweepWish of_fabrics(const std::string& project, const std::vector<std::string>& fabrics) {
    jobs::SweepWish wish;
    wish.project_id = project;
    wish.bodies.resize(1);
    for (const std::string& fabric : fabrics) wish.fabrics.push_back({"", fabric});
    return wish;
  }
  sweep::Table table_of(const std::string& id) {
    store::Sweeps& sweeps = *store::sweeps_of(*store_);
    return jobs::table_of(*service_, kOwner, *sweeps.sweep(kOwner, id), *sweeps.jobs_of_sweep(kOwner, id));
  }

  fs::path folder_;
  store::Quotas quotas_;
  jobs::JobServiceSettings settings_;
  test::Recorder publisher_;
  std::unique_ptr<store::Store> store_;
  std::unique_ptr<documents::Documents> documents_;
  std::unique_ptr<jobs::JobService> service_;
};

TEST_F(JobSweeps, DrapeEachCellOnce) {
  const std::string project = project_of(0.2);
  const auto plain = service_->submit(kOwner, project, "");
  ASSERT_TRUE(plain) << to_string(plain.error());
  ASSERT_TRUE(publisher_.wait_for_end(plain->id));
  const auto made = service_->submit_sweep(kOwner, of_fabrics(project, {"", "poplin"}), "");
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->jobs[0].state, store::JobState::kSucceeded) << "draped before, by itself";
  EXPECT_TRUE(made->jobs[0].document.empty());
  ASSERT_TRUE(publisher_.wait_for_end(made->jobs[1].id));
  const sweep::Table table = table_of(made->sweep.id);
  EXPECT_EQ(table.fabrics, (std::vector<std::string>{"cotton", "poplin"}));
  ASSERT_TRUE(table.cells[0].figures && table.cells[1].figures);
  EXPECT_NE(table.cells[0].figures->hash, table.cells[1].figures->hash) << "another cloth hangs otherwise";
  EXPECT_TRUE(table.cells[1].pictured);
  EXPECT_EQ(sweep::counts_of(table).fraction, 1);
  const auto again = service_->submit_sweep(kOwner, of_fabrics(project, {"", "poplin"}), "");
  EXPECT_EQ(sweep::counts_of(table_of(again->sweep.id)).succeeded, 2) << "answered at once";
  EXPECT_EQ(table_of(again->sweep.id).cells[1].figures->hash, table.cells[1].figures->hash);
  EXPECT_EQ(service_->counts().answered, 3);
  jobs::SweepWish anew = of_fabrics(project, {"poplin"});
  anew.manner.anew = true;
  EXPECT_FALSE(store::is_final(service_->submit_sweep(kOwner, anew, "")->jobs[0].state));
}

TEST_F(JobSweeps, GoOnAfterAStop) {
  const auto made =
      service_->submit_sweep(kOwner, of_fabrics(project_of(3), {"poplin", "twill", "felt"}), "key");
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_TRUE(publisher_.wait_for_frames(made->jobs[0].id, 2));
  close();
  open();
  for (const store::JobRow& job : made->jobs) {
    while (!store::is_final(store_->job(kOwner, job.id)->state)) {
      ASSERT_TRUE(publisher_.wait_for_end(job.id));
    }
  }
  EXPECT_EQ(sweep::counts_of(table_of(made->sweep.id)).succeeded, 3);
  const auto again = service_->submit_sweep(kOwner, of_fabrics(made->sweep.project_id, {"poplin"}), "key");
  EXPECT_FALSE(again->anew);
  EXPECT_EQ(again->sweep.id, made->sweep.id);
}

TEST_F(JobSweeps, AreCancelledAndRemovedWhileTheyAreDraped) {
  const auto made =
      service_->submit_sweep(kOwner, of_fabrics(project_of(test::kEndless), {"poplin", "twill", "felt"}), "");
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_TRUE(publisher_.wait_for_frames(made->jobs[0].id, 2));
  const std::string id = made->sweep.id;
  EXPECT_EQ(jobs::remove_sweep(*store_, *service_, kOwner, id).error().code, "jobs.state");
  ASSERT_TRUE(jobs::cancel_sweep(*store_, *service_, kOwner, id));
  for (const store::JobRow& job : made->jobs) ASSERT_TRUE(publisher_.wait_for_end(job.id));
  EXPECT_EQ(sweep::counts_of(table_of(id)).cancelled, 3);
  ASSERT_TRUE(jobs::remove_sweep(*store_, *service_, kOwner, id));
  EXPECT_FALSE(store::sweeps_of(*store_)->sweep(kOwner, id));
  EXPECT_EQ(store_->usage(kOwner)->jobs, 0);
}

TEST_F(JobSweeps, AreRefusedWhereThereIsNoRoomForAllOfThem) {
  close();
  settings_.max_queued = 2;
  settings_.workers = 0;
  open();
  const std::string project = project_of(1);
  const auto refused = service_->submit_sweep(kOwner, of_fabrics(project, {"poplin", "twill", "felt"}), "");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "jobs.queue_full");
  EXPECT_EQ(store_->usage(kOwner)->jobs, 0);
  EXPECT_TRUE(service_->submit_sweep(kOwner, of_fabrics(project, {"poplin", "twill"}), ""));
}

}  // namespace
}  // namespace toile
