#include "core/base/run_child.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>

namespace toile {
namespace {

using End = ChildOutcome::End;

ChildOutcome shell(const std::string& script, const ChildLimits& limits = {}) {
  return run_child({"/bin/sh", {"-c", script}, -1}, limits);
}

/// Does nothing but spend processor time.
constexpr const char* kSpin = "while :; do :; done";

TEST(RunChild, GivesBackOutputAndExitCode) {
  const ChildOutcome outcome = shell("printf 'a\\0b'; exit 3");
  EXPECT_EQ(outcome.end, End::kExited);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.output, std::string("a\0b", 3));
}

TEST(RunChild, LetsTheChildReadTheFileThatItIsGivenAndNoOther) {
  const int source = ::open("/proc/self/cmdline", O_RDONLY | O_CLOEXEC);
  const int open_without_cloexec = ::open("/dev/null", O_RDONLY);
  ASSERT_GE(source, 0);
  const ChildOutcome outcome =
      run_child({"/bin/sh", {"-c", "wc -c; ls /proc/$$/fd | wc -w; pwd; env"}, source}, {});
  ::close(source);
  ::close(open_without_cloexec);
  EXPECT_EQ(outcome.end, End::kExited);
  EXPECT_NE(outcome.output.substr(0, 2), "0\n");
  const std::string rest = outcome.output.substr(outcome.output.find('\n') + 1);
  EXPECT_LE(std::stoi(rest), 4) << "the three, and what ls itself opens: " << rest;
  EXPECT_NE(rest.find("\n/\n"), std::string::npos) << rest;
  EXPECT_EQ(rest.find("HOME="), std::string::npos) << rest;
}

TEST(RunChild, CannotWriteFiles) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "SKIPPED: ThreadSanitizer's own runtime writes files";
#endif
  const std::filesystem::path target = std::filesystem::temp_directory_path() / "toile_run_child_writes";
  std::filesystem::remove(target);
  shell("echo something > " + target.string());
  std::error_code none;
  EXPECT_FALSE(std::filesystem::exists(target) && std::filesystem::file_size(target, none) > 0);
  std::filesystem::remove(target);
}

TEST(RunChild, NamesTheSignalThatEndedIt) {
  const ChildOutcome outcome = shell("printf x; kill -SEGV $$");
  EXPECT_EQ(outcome.end, End::kKilledBySignal);
  EXPECT_EQ(outcome.code, SIGSEGV);
  EXPECT_EQ(outcome.output, "x");
}

TEST(RunChild, EndsAChildThatSleepsForEver) {
  ChildLimits limits;
  limits.wall_s = 0.3;
  // Left alone it would exit by itself, which is another end.
  EXPECT_EQ(shell("exec sleep 1000", limits).end, End::kTookTooLong);
}

TEST(RunChild, EndsAChildThatHasShutItsOutputAndSleeps) {
  ChildLimits limits;
  limits.wall_s = 0.3;
  EXPECT_EQ(shell("exec >&-; exec sleep 1000", limits).end, End::kTookTooLong);
}

TEST(LongRunChild, EndsAChildThatComputesForEverByItsProcessorTime) {
  ChildLimits limits;
  limits.cpu_s = 1;
  const ChildOutcome outcome = shell(kSpin, limits);
  EXPECT_EQ(outcome.end, End::kTookTooLong);
}

TEST(RunChild, KillsWhatTheChildHasLeftBehind) {
  const std::string mark = "91.827364" + std::to_string(::getpid());
  ChildLimits limits;
  limits.wall_s = 0.3;
  shell("sleep " + mark + " & exit 0", limits);
  const ChildOutcome left =
      shell("for f in /proc/[0-9]*/cmdline; do tr '\\0' ' ' < $f; echo; done 2>/dev/null");
  EXPECT_EQ(left.output.find("sleep " + mark), std::string::npos);
}

TEST(RunChild, StopsAFloodOfOutput) {
  ChildLimits limits;
  limits.output_bytes = 1 << 20;
  const ChildOutcome outcome = shell("exec cat /dev/zero", limits);
  EXPECT_EQ(outcome.end, End::kWroteTooMuch);
  EXPECT_LT(outcome.output.size(), std::size_t{2} << 20);
}

TEST(RunChild, KeepsTheChildWithinItsMemory) {
  ChildLimits limits;
  limits.memory_bytes = std::uint64_t{64} << 20;
  // A shell that doubles a string until it holds 2^40 characters.
  const ChildOutcome outcome =
      shell("x=aaaaaaaaaaaaaaaa; for i in $(seq 36); do x=$x$x; done; echo survived", limits);
  EXPECT_NE(outcome.end, End::kTookTooLong);
  EXPECT_EQ(outcome.output.find("survived"), std::string::npos);
  EXPECT_FALSE(outcome.end == End::kExited && outcome.code == 0);
}

TEST(RunChild, SaysThatAProgramIsMissing) {
  EXPECT_EQ(run_child({"/no/such/program", {}, -1}, {}).end, End::kNotStarted);
}

TEST(RunChild, LeavesNoFilesOpen) {
  const auto open_files = [] {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
      count += entry.exists() || true;
    return count;
  };
  const int before = open_files();
  for (int i = 0; i < 5; ++i) shell("exit 0");
  run_child({"/no/such/program", {}, -1}, {});
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace toile
