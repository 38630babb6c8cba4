#include "server/ws/job_message.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

store::JobRow row() {
  store::JobRow job;
  job.id = "j_1";
  job.state = store::JobState::kSucceeded;
  job.reason = "it lies \"still\"";
  job.created_ms = 1795229571125;
  job.document = "{}";
  job.results = {{"final.obj", 12}};
  return job;
}

TEST(JobMessage, BeginsWithItsTypeAndIsFlat) {
  const Result<json::JsonValue> hello = json::parse_json(ws::job_message(row(), {}));
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->object()->front().key, "type");
  EXPECT_EQ(*hello->find("type")->text(), "job");
  EXPECT_EQ(*hello->find("id")->text(), "j_1");
  EXPECT_EQ(*hello->find("results")->find("final.obj")->number(), 12);
  EXPECT_TRUE(hello->find("progress")->object());
  EXPECT_FALSE(hello->find("document")) << "may be megabytes";
}

TEST(JobMessage, WritesTimesToTheMillisecond) {
  EXPECT_NE(ws::job_message(row(), {}).find("\"created_ms\": 1795229571125,"), std::string::npos);
}

TEST(JobMessage, TellsAtTheEndBothTheFiguresAndTheJob) {
  jobs::JobProgress last;
  last.state = store::JobState::kSucceeded;
  last.step = 77;
  const Result<json::JsonValue> ended = json::parse_json(ws::ended_message(row(), last));
  ASSERT_TRUE(ended);
  EXPECT_EQ(*ended->find("type")->text(), "ended");
  EXPECT_EQ(*ended->find("step")->number(), 77);
  EXPECT_EQ(*ended->find("job")->find("reason")->text(), "it lies \"still\"");
}

}  // namespace
}  // namespace toile
