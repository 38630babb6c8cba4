#include "server/jobs/queue.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

std::string first(const JobQueue& queue) {
  return queue.first([](const std::string&) { return true; }).value_or("");
}

TEST(JobQueue, GivesTheOldestFirst) {
  JobQueue queue;
  queue.put("a", QueuePlace::kBack);
  queue.put("b", QueuePlace::kBack);
  EXPECT_EQ(first(queue), "a");
  queue.put("a", QueuePlace::kOut);
  EXPECT_EQ(first(queue), "b");
}

TEST(JobQueue, HoldsAJobOnlyOnce) {
  JobQueue queue;
  queue.put("a", QueuePlace::kBack);
  queue.put("b", QueuePlace::kBack);
  queue.put("b", QueuePlace::kFront);
  EXPECT_EQ(first(queue), "b");
  queue.put("b", QueuePlace::kOut);
  EXPECT_EQ(first(queue), "a");
  queue.put("a", QueuePlace::kOut);
  EXPECT_EQ(first(queue), "");
}

TEST(JobQueue, PassesOverWhatIsNotReady) {
  JobQueue queue;
  queue.put("a", QueuePlace::kBack);
  queue.put("b", QueuePlace::kBack);
  EXPECT_EQ(queue.first([](const std::string& id) { return id != "a"; }), "b");
}

}  // namespace
}  // namespace toile
