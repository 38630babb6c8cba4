#include "tests/app/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

extern char** environ;

namespace toile {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

pid_t start(const std::vector<std::string>& arguments, const fs::path& out, const fs::path& err) {
  std::string program = std::string(TOILE_BINARY_DIR) + "/toile";
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{program.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t pid = -1;
  const int failure = posix_spawn(&pid, program.c_str(), &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  EXPECT_EQ(failure, 0) << "cannot start " << program;
  return failure == 0 ? pid : -1;
}

/// Whether the process has a handler of its own for SIGINT: before that the signal would just end it.
bool catches_interrupt(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/status");
  constexpr std::string_view kCaught = "SigCgt:";
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(kCaught)) continue;
    return (std::stoull(line.substr(kCaught.size()), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  }
  return false;
}

}  // namespace

Ran run_toile(const std::vector<std::string>& arguments, double allowed_s,
              const std::function<bool()>& interrupt_once) {
  const fs::path folder = fresh_folder("toile_run_output");
  Ran run;
  const Clock::time_point began = Clock::now();
  const pid_t pid = start(arguments, folder / "out", folder / "err");
  if (pid < 0) return run;
  int status = 0;
  bool interrupted = !interrupt_once;
  while (waitpid(pid, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (!interrupted && catches_interrupt(pid) && interrupt_once()) {
      kill(pid, SIGINT);
      interrupted = true;
    }
    if (seconds_since(began) > allowed_s) kill(pid, SIGKILL);
  }
  if (WIFEXITED(status)) run.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  run.out = text_of(folder / "out");
  run.err = text_of(folder / "err");
  fs::remove_all(folder);
  return run;
}

fs::path fresh_folder(const std::string& name) {
  // Tests run side by side, each in a process of its own.
  const fs::path folder = fs::path(testing::TempDir()) / (name + "_" + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

}  // namespace toile
