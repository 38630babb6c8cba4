// A server that is killed while it drapes, and the next one.

#include <gtest/gtest.h>
#include <signal.h>

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

namespace toile {
namespace {

namespace fs = std::filesystem;

/// False after two minutes.
bool wait_for(const std::function<bool()>& holds) {
  for (int waited = 0; waited < 12000 && !holds(); ++waited) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return holds();
}

/// A member of a JSON object as text; numbers without digits after the point.
std::string member(const std::string& json, const std::string& key) {
  const Result<json::JsonValue> tree = json::parse_json(json, {.depth = 64});
  const json::JsonValue* found = tree ? tree->find(key) : nullptr;
  if (found && found->number()) return std::to_string(static_cast<int>(*found->number()));
  return found && found->text() ? *found->text() : "";
}

TEST(Recovery, ADrapeThatWasKilledTwiceEndsInTheBytesOfOneThatWasNot) {
  const fs::path folder = fresh_folder("toile_recovery");
  fs::create_directories(folder / "empty");
  const fs::path napkin = napkin_folder("toile_recovery_napkin", "\"particle_distance_mm\": 25",
                                        "\"particle_distance_mm\": 12, \"time_step_s\": 0.00025");
  const Ran home =
      run_toile({"drape", napkin / "project.json", "--out", folder / "home", "--no-stills"}, 120);
  ASSERT_EQ(home.signal, 0) << home.err;

  const auto newest = [&](const std::string& id) {  // checkpoint
    std::error_code none;
    return fs::last_write_time(folder / "data/checkpoints" / id, none);
  };
  std::string id, report;
  for (int kills = 0; kills <= 2; ++kills) {
    Serving server(folder / "data",
                   {"--sample", folder / "empty", "--workers", "1", "--checkpoint-every", "0.1"});
    ASSERT_TRUE(server.up()) << server.said();
    if (id.empty()) {
      const Ran sent = run_toile({"submit", napkin / "project.json", "--server", server.url()});
      ASSERT_EQ(sent.code, 0) << sent.err;
      id = sent.out.substr(0, sent.out.find('\n'));
    }
    const auto state = [&] { return member(server.get("/api/v1/jobs/" + id).body, "state"); };
    if (kills < 2) {
      const auto before = newest(id);
      ASSERT_TRUE(
          wait_for([&] { return newest(id) != before && fs::exists(folder / "data/checkpoints" / id); }));
      ASSERT_EQ(state(), "running") << "the drape must be longer for this test";
      EXPECT_EQ(server.end(SIGKILL), -SIGKILL);
    } else {
      ASSERT_TRUE(wait_for([&] { return state() == "succeeded" || state() == "failed"; })) << state();
      report = server.get("/api/v1/jobs/" + id + "/results/report.json").body;
      EXPECT_EQ(server.end(SIGTERM), 0);
    }
  }
  EXPECT_NE(member(report, "hash"), "");
  EXPECT_EQ(member(report, "hash"), member(text_of(folder / "home/report.json"), "hash"));
  EXPECT_EQ(member(report, "steps"), member(text_of(folder / "home/report.json"), "steps"));
  EXPECT_EQ(member(report, "resumed"), "2");
  EXPECT_FALSE(fs::exists(folder / "data/checkpoints" / id)) << "an ended job needs none";
  fs::remove_all(folder);
  fs::remove_all(napkin);
}

/// A server over a napkin that takes a while, and its job.
class KilledServer : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_killed");
    fs::create_directories(folder / "empty");
  }
  void TearDown() override { fs::remove_all(folder); }
  std::unique_ptr<Serving> serve() {
    return std::make_unique<Serving>(folder / "data",
                                     std::vector<std::string>{"--sample", folder / "empty", "--workers", "1",
                                                              "--checkpoint-every", "0.1"});
  }
  std::string submit(const Serving& server, const std::string& from, const std::string& to) {
    const fs::path napkin = napkin_folder("toile_killed_napkin", from, to);
    const Ran sent = run_toile({"submit", napkin / "project.json", "--server", server.url()});
    EXPECT_EQ(sent.code, 0) << sent.err;
    fs::remove_all(napkin);
    return sent.out.substr(0, sent.out.find('\n'));
  }
  static std::string job(const Serving& server, const std::string& id) {
    return server.get("/api/v1/jobs/" + id).body;
  }

  fs::path folder;
};

TEST_F(KilledServer, StartsAgainWithWhatWasPausedStillPaused) {
  auto server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  const std::string id = submit(*server, "\"particle_distance_mm\": 25",
                                "\"particle_distance_mm\": 12, \"time_step_s\": 0.00025");
  ASSERT_TRUE(wait_for([&] { return fs::exists(folder / "data/checkpoints" / id); }));
  ASSERT_EQ(server->post("/api/v1/jobs/" + id + "/pause", "").status, 200);
  for (const int signal : {SIGTERM, SIGKILL, SIGTERM}) {
    ASSERT_EQ(member(job(*server, id), "state"), "paused");
    EXPECT_EQ(server->end(signal), signal == SIGKILL ? -SIGKILL : 0);
    server = serve();
    ASSERT_TRUE(server->up()) << server->said();
  }
  EXPECT_EQ(member(job(*server, id), "state"), "paused");
  ASSERT_EQ(server->post("/api/v1/jobs/" + id + "/resume", "").status, 200);
  ASSERT_TRUE(wait_for([&] { return member(job(*server, id), "state") == "succeeded"; }));
}

TEST_F(KilledServer, EndsInTimeWhileAReaderOfAMeshHangs) {
  const auto server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  std::string mesh;  // large enough to be met at work
  for (int k = 0; k < 60'000; ++k) {
    const std::string x = std::to_string(k % 300), y = std::to_string(k / 300);
    mesh += "v " + x + " " + y + " 0\nv " + x + ".5 " + y + " 0\nv " + x + " " + y + ".5 0\nf -3 -2 -1\n";
  }
  const http::HttpClient::Request upload{.method = "POST",
                                         .target = "/api/v1/bodies?name=large.obj",
                                         .body = mesh,
                                         .content_type = "application/octet-stream",
                                         .headers = {}};
  std::jthread sending([&] { server->ask(upload); });
  ASSERT_TRUE(wait_for([&] { return !server->readers().empty(); }));
  for (const pid_t reader : server->readers()) kill(reader, SIGSTOP);
  EXPECT_EQ(server->end(SIGTERM, 30), 0) << "a reader may take 90 s";
}

TEST_F(KilledServer, KeepsAFinishedDrapeHoweverOftenItsPicturesAreCutOff) {
  std::string id;
  for (int kills = 0; kills < 5; ++kills) {
    const auto server = serve();
    ASSERT_TRUE(server->up()) << server->said();
    if (id.empty()) id = submit(*server, "\"max_time_s\": 8", "\"max_time_s\": 0.2");
    const auto drawing = [&] {
      const std::string now = job(*server, id);
      return now.find("\"phase\": \"stills\"") != std::string::npos || member(now, "state") == "succeeded";
    };
    ASSERT_TRUE(wait_for(drawing)) << job(*server, id);
    EXPECT_NE(member(job(*server, id), "state"), "failed");
    EXPECT_EQ(server->end(SIGKILL), -SIGKILL);
  }
  const auto server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  ASSERT_TRUE(wait_for([&] { return member(job(*server, id), "state") == "succeeded"; })) << job(*server, id);
  EXPECT_EQ(server->get("/api/v1/jobs/" + id + "/results/final.glb").status, 200);
  EXPECT_NE(member(server->get("/api/v1/jobs/" + id + "/results/report.json").body, "hash"), "");
}

}  // namespace
}  // namespace toile
