#include "server/ws/job_message.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

JobRow row() {
  JobRow job;
  job.id = "j_1";
  job.state = JobState::kSucceeded;
  job.reason = "it lies \"still\"";
  job.created_ms = 1795229571125;
  job.document = "{}";
  job.results = {{"final.obj", 12}};
  return job;
}

TEST(JobMessage, BeginsWithItsTypeAndIsFlat) {
  const Result<JsonValue> hello = parse_json(job_message(row(), {}));
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->object()->front().key, "type");
  EXPECT_EQ(*hello->find("type")->text(), "job");
  EXPECT_EQ(*hello->find("id")->text(), "j_1");
  EXPECT_EQ(*hello->find("results")->find("final.obj")->number(), 12);
  EXPECT_TRUE(hello->find("progress")->object());
  EXPECT_FALSE(hello->find("document")) << "may be megabytes";
}

TEST(JobMessage, WritesTimesToTheMillisecond) {
  EXPECT_NE(job_message(row(), {}).find("\"created_ms\": 1795229571125,"), std::string::npos);
}

TEST(JobMessage, TellsAtTheEndBothTheFiguresAndTheJob) {
  JobProgress last;
  last.state = JobState::kSucceeded;
  last.step = 77;
  const Result<JsonValue> ended = parse_json(ended_message(row(), last));
  ASSERT_TRUE(ended);
  EXPECT_EQ(*ended->find("type")->text(), "ended");
  EXPECT_EQ(*ended->find("step")->number(), 77);
  EXPECT_EQ(*ended->find("job")->find("reason")->text(), "it lies \"still\"");
}

}  // namespace
}  // namespace toile
