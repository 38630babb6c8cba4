// Jobs that go on from where another's garment hung.

#include "server/jobs/input.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kOwner;

class GoingOnJobs : public test::JobHouse {
 protected:
  void SetUp() override { ASSERT_TRUE(service->start()); }
  store::JobRow ended(const std::string& project, const std::string& from = "") {
    jobs::JobWish wish;
    wish.from = from;
    const auto made = service->submit(kOwner, project, "", wish);
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    if (!made) return {};
    EXPECT_TRUE(publisher.wait_for_end(made->id));
    return row(made->id);
  }
};

TEST_F(GoingOnJobs, BeginWithTheClothAsItHungAndKeepItThoughTheOtherJobIsRemoved) {
  const std::string project = project_of(cloth_over_block(200, 0.3));
  const store::JobRow first = ended(project);
  const store::JobRow on = ended(project, first.id);
  EXPECT_NE(on.report.find("start.goes_on"), std::string::npos) << on.report;
  EXPECT_EQ(first.report.find("start.goes_on"), std::string::npos);
  EXPECT_EQ(on.files.at(jobs::kShapeFile).substr(0, 2), "a_");
  ASSERT_TRUE(service->remove(kOwner, first.id));
  EXPECT_TRUE(store.asset_bytes(kOwner, on.files.at(jobs::kShapeFile)));
}

TEST_F(GoingOnJobs, AreRefusedWhereThereIsNothingToGoOnFrom) {
  const std::string project = project_of(cloth_over_block(200, 0.2));
  jobs::JobWish wish;
  wish.from = "j_nobody";
  EXPECT_EQ(service->submit(kOwner, project, "", wish).error().code, "jobs.from");
  wish.from = service->submit(kOwner, project, "")->id;
  ASSERT_TRUE(service->pause(kOwner, wish.from));
  EXPECT_EQ(service->submit(kOwner, project, "", wish).error().code, "jobs.no_shape");
  const store::RequestContext stranger("stranger");
  EXPECT_FALSE(service->submit(stranger, project, "", wish));
}

}  // namespace
}  // namespace toile
