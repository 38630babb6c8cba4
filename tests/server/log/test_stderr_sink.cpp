#include "server/log/stderr_sink.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace toile {
namespace {

TEST(StderrSink, WritesOneLineForEachCallWithLevelAndBoundFields) {
  testing::internal::CaptureStderr();
  {
    const auto sink = log::make_stderr_sink();
    const Log log = Log(*sink).with("owner", "ann");
    log.debug("not told");
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&log, t] {
        for (int i = 0; i < 50; ++i) log.with("thread", std::to_string(t)).warn("busy");
      });
    for (std::thread& thread : threads) thread.join();
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(text.find("not told"), std::string::npos);
  int lines = 0;
  for (std::size_t at = 0; (at = text.find("warning busy owner=ann thread=", at)) != std::string::npos; ++at)
    ++lines;
  EXPECT_EQ(lines, 200) << text.substr(0, 300);
}

TEST(StderrSink, WritesJsonWhereProgramsRead) {
  testing::internal::CaptureStderr();
  log::make_stderr_sink(log::LogFormat::kJson)->write(LogLevel::kError, "job ended", {}, {});
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(text.starts_with("{\"time\": \"2")) << text;
  EXPECT_TRUE(text.ends_with("\"level\": \"error\", \"event\": \"job ended\"}\n")) << text;
}

TEST(Log, IsSilentWithoutASink) {
  const Log log;
  log.with("job", "j_1").error("nobody hears this");
}

}  // namespace
}  // namespace toile
