#include "server/log/job_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace toile {
namespace {

namespace fs = std::filesystem;

class Counter final : public LogSink {
 public:
  void write(LogLevel, std::string_view, std::span<const LogField>,
             std::span<const LogField>) noexcept override {
    ++lines;
  }
  std::atomic<int> lines{0};
};

class JobLogTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::string text_of(const std::string& job) const {
    std::ifstream in(folder / job, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const fs::path folder = fs::path(testing::TempDir()) / ("toile_job_log_" + std::to_string(::getpid()));
  Counter next;
  std::unique_ptr<LogSink> sink = log::make_job_log(next, folder);
};

TEST_F(JobLogTest, KeepsTheLinesOfAJobApartAndPassesAllOn) {
  const Log log(*sink);
  log.with("job", "j_1").debug("phase", {{"phase", "sew"}});
  log.info("job queued", {{"job", "j_2"}});
  log.info("answered");
  EXPECT_EQ(next.lines, 3);
  EXPECT_NE(text_of("j_1").find("\"event\": \"phase\""), std::string::npos) << "light lines as well";
  EXPECT_EQ(text_of("j_1").find("queued"), std::string::npos);
  EXPECT_NE(text_of("j_2").find("\"event\": \"job queued\""), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST_F(JobLogTest, WritesToNoFileThatAJobCannotHave) {
  const Log log(*sink);
  for (const char* name : {"../up", "", ".", "a/b", "J_1"}) log.info("job queued", {{"job", name}});
  EXPECT_EQ(next.lines, 5);
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_FALSE(fs::exists(folder.parent_path() / "up"));
}

TEST_F(JobLogTest, EndsBeforeAJobThatTalksTooMuchFillsTheDisk) {
  const Log log = Log(*sink).with("job", "j_1");
  const std::string long_words(1000, 'x');
  for (std::size_t i = 0; i < log::kMostJobLogBytes / 1000 + 20; ++i) log.info(long_words);
  const std::string text = text_of("j_1");
  EXPECT_LE(text.size(), log::kMostJobLogBytes);
  EXPECT_GT(text.size(), log::kMostJobLogBytes - 2000);
  EXPECT_EQ(text.back(), '\n') << "no line is cut";
}

TEST_F(JobLogTest, TakesWholeLinesOfManyThreads) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([this] {
      const Log log = Log(*sink).with("job", "j_1");
      for (int i = 0; i < 100; ++i) log.info("busy");
    });
  for (std::thread& thread : threads) thread.join();
  const std::string text = text_of("j_1");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 400);
}

}  // namespace
}  // namespace toile
