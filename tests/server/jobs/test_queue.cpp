#include "server/jobs/queue.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

std::string first(const jobs::JobQueue& queue) {
  return queue.first([](const std::string&) { return true; }).value_or("");
}

TEST(JobQueue, GivesTheOldestFirst) {
  jobs::JobQueue queue;
  queue.put("a", jobs::QueuePlace::kBack);
  queue.put("b", jobs::QueuePlace::kBack);
  EXPECT_EQ(first(queue), "a");
  queue.put("a", jobs::QueuePlace::kOut);
  EXPECT_EQ(first(queue), "b");
}

TEST(JobQueue, HoldsAJobOnlyOnce) {
  jobs::JobQueue queue;
  queue.put("a", jobs::QueuePlace::kBack);
  queue.put("b", jobs::QueuePlace::kBack);
  queue.put("b", jobs::QueuePlace::kFront);
  EXPECT_EQ(first(queue), "b");
  queue.put("b", jobs::QueuePlace::kOut);
  EXPECT_EQ(first(queue), "a");
  queue.put("a", jobs::QueuePlace::kOut);
  EXPECT_EQ(first(queue), "");
}

TEST(JobQueue, PassesOverWhatIsNotReady) {
  jobs::JobQueue queue;
  queue.put("a", jobs::QueuePlace::kBack);
  queue.put("b", jobs::QueuePlace::kBack);
  EXPECT_EQ(queue.first([](const std::string& id) { return id != "a"; }), "b");
}

}  // namespace
}  // namespace toile
