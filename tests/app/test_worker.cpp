// `toile worker` beside `toile serve --no-workers`, as processes that are killed and stopped.

#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/json/tree.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"

extern char** environ;

namespace toile {
namespace {

namespace fs = std::filesystem;

/// False after two minutes.
bool wait_for(const std::function<bool()>& holds) {
  for (int waited = 0; waited < 12000; ++waited) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// A member of a JSON object as text; numbers without digits after the point.
std::string member(const std::string& json, const std::string& key) {
  const Result<json::JsonValue> tree = json::parse_json(json, {.depth = 64});
  const json::JsonValue* found = tree ? tree->find(key) : nullptr;
  if (found && found->number()) return std::to_string(static_cast<int>(*found->number()));
  return found && found->text() ? *found->text() : "";
}

/// `toile worker` in a process of its own, one drape at a time.
class Working {
 public:
  explicit Working(const fs::path& store) {
    std::string program = std::string(TOILE_BINARY_DIR) + "/toile";
    std::vector<std::string> words{
        "worker", "--store", store.string(), "--workers", "1", "--checkpoint-every", "0.1"};
    std::vector<char*> argv{program.data()};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    if (posix_spawn(&pid_, program.c_str(), nullptr, nullptr, argv.data(), environ) != 0) pid_ = -1;
  }
  ~Working() {
    if (pid_ > 0) end(SIGKILL);
  }
  Working(const Working&) = delete;

  void send(int signal) const { kill(pid_, signal); }
  /// The exit code, or minus the signal that ended it.
  int end(int signal) {
    kill(pid_, signal);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t pid_ = -1;
};

class Workers : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_workers");
    fs::create_directories(folder / "empty");
    server = std::make_unique<Serving>(
        folder / "data", std::vector<std::string>{"--sample", folder / "empty", "--no-workers"});
    ASSERT_TRUE(server->up()) << server->said();
  }
  void TearDown() override {
    server.reset();
    fs::remove_all(folder);
  }
  /// A job of some seconds; each `step_s` its own.
  std::string submit(const std::string& step_s) {
    napkin = napkin_folder("toile_workers_napkin", "\"particle_distance_mm\": 25",
                           "\"particle_distance_mm\": 12, \"time_step_s\": " + step_s);
    const Ran sent = run_toile({"submit", napkin / "project.json", "--server", server->url()});
    EXPECT_EQ(sent.code, 0) << sent.err;
    return sent.out.substr(0, sent.out.find('\n'));
  }
  std::string state(const std::string& id) { return member(server->get("/api/v1/jobs/" + id).body, "state"); }
  std::string report(const std::string& id) {
    return server->get("/api/v1/jobs/" + id + "/results/report.json").body;
  }
  fs::path checkpoint(const std::string& id) const { return folder / "data/checkpoints" / id; }

  fs::path folder, napkin;
  std::unique_ptr<Serving> server;
};

TEST_F(Workers, OneThatIsKilledCostsItsJobsLastSecondsAndNobodyElses) {
  const std::string first = submit("0.00025");
  Working killed(folder / "data");
  ASSERT_TRUE(wait_for([&] { return fs::exists(checkpoint(first)); }));
  const Ran home =
      run_toile({"drape", napkin / "project.json", "--out", folder / "home", "--no-stills"}, 240);
  ASSERT_EQ(home.signal, 0) << home.err;
  const std::string second = submit("0.00026");
  Working other(folder / "data");
  ASSERT_TRUE(wait_for([&] { return state(second) == "running" || state(second) == "succeeded"; }));
  const bool was_running = state(first) == "running";
  EXPECT_EQ(killed.end(SIGKILL), -SIGKILL);
  EXPECT_TRUE(server->get("/api/v1/jobs").status == 200) << "the server is another process";
  for (const std::string& id : {first, second}) {
    ASSERT_TRUE(wait_for([&] { return state(id) == "succeeded" || state(id) == "failed"; })) << state(id);
    EXPECT_EQ(state(id), "succeeded");
  }
  EXPECT_EQ(member(report(first), "hash"), member(text_of(folder / "home/report.json"), "hash"));
  if (was_running) {
    EXPECT_EQ(member(report(first), "resumed"), "1");
  }
  EXPECT_EQ(member(report(second), "resumed"), "0") << "nobody else's drape was disturbed";
  EXPECT_EQ(other.end(SIGTERM), 0);
}

TEST_F(Workers, OneThatHangsPastItsLeaseLosesItAndComesTooLate) {
  const std::string id = submit("0.0001");
  Working hung(folder / "data");
  ASSERT_TRUE(wait_for([&] { return fs::exists(checkpoint(id)); }));
  hung.send(SIGSTOP);
  Working other(folder / "data");
  // Once the lease is over another goes on, whose first checkpoint is its own.
  const auto stopped_at = fs::last_write_time(checkpoint(id));
  ASSERT_TRUE(wait_for([&] {
    std::error_code none;
    return fs::last_write_time(checkpoint(id), none) != stopped_at && !none;
  }));
  hung.send(SIGCONT);
  ASSERT_TRUE(wait_for([&] { return state(id) == "succeeded" || state(id) == "failed"; }));
  EXPECT_EQ(state(id), "succeeded");
  EXPECT_EQ(member(report(id), "resumed"), "1") << "the one that hung has published nothing";
  EXPECT_EQ(server->get("/api/v1/jobs/" + id + "/results/final.glb").status, 200);
  EXPECT_EQ(hung.end(SIGTERM), 0);
  EXPECT_EQ(other.end(SIGTERM), 0);
}

TEST_F(Workers, GoOnWhileTheServerIsAway) {
  const std::string id = submit("0.00025");
  Working worker(folder / "data");
  ASSERT_TRUE(wait_for([&] { return fs::exists(checkpoint(id)); }));
  EXPECT_EQ(server->end(SIGKILL), -SIGKILL);
  server = std::make_unique<Serving>(folder / "data",
                                     std::vector<std::string>{"--sample", folder / "empty", "--no-workers"});
  ASSERT_TRUE(server->up()) << server->said();
  ASSERT_TRUE(wait_for([&] { return state(id) == "succeeded" || state(id) == "failed"; }));
  EXPECT_EQ(state(id), "succeeded");
  EXPECT_EQ(member(report(id), "resumed"), "0");
}

TEST_F(Workers, HaveNothingToDoWithoutAStore) {
  const Ran ran = run_toile({"worker", "--store", folder / "nothing"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("start the server first"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace toile
