// `toile serve` and `toile submit` as a user runs them.

#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/json/tree.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"
#include "tests/core/image/pictures.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

std::string member(const std::string& json, const std::string& key) {
  const Result<json::JsonValue> tree = json::parse_json(json, {.depth = 64});
  const json::JsonValue* found = tree ? tree->find(key) : nullptr;
  return found && found->text() ? *found->text() : "";
}

std::set<std::string> job_ids(const Serving& server) {
  std::set<std::string> ids;
  const Result<json::JsonValue> tree =
      json::parse_json(server.get("/api/v1/jobs?limit=100").body, {.depth = 64});
  if (!tree || !tree->find("jobs")) return ids;
  for (const json::JsonValue& job : *tree->find("jobs")->array()) ids.insert(*job.find("id")->text());
  return ids;
}

class Serve : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_serve");
    fs::create_directories(folder / "empty");
  }
  void TearDown() override { fs::remove_all(folder); }
  /// Without the sample's drape, which would keep the processor busy.
  std::vector<std::string> plain() const { return {"--sample", folder / "empty", "--workers", "2"}; }
  /// The napkin as a project of the server; its id.
  std::string make_project(const Serving& server) {
    http::HttpClient::Request upload{.method = "POST",
                                     .target = "/api/v1/bodies?name=post.obj",
                                     .body = kPost,
                                     .content_type = "application/octet-stream",
                                     .headers = {}};
    const std::string asset = member(server.ask(upload).body, "id");
    return member(server
                      .post("/api/v1/projects", std::string("{\"document\": ") + kNapkin +
                                                    ", \"files\": {\"post.obj\": \"" + asset + "\"}}")
                      .body,
                  "id");
  }

  fs::path folder;
};

TEST_F(Serve, PrintsItsAddressAndEndsInGoodOrder) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Serving server(folder / "data", plain());
    ASSERT_TRUE(server.up()) << server.said();
    EXPECT_EQ(server.get("/readyz").status, 200);
    EXPECT_EQ(server.end(signal), 0) << server.said();
  }
}

/// Of the lines of JSON, those of an event.
std::vector<json::JsonValue> events(const std::string& lines, const std::string& event) {
  std::vector<json::JsonValue> found;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with('{')) continue;  // what is printed for people
    Result<json::JsonValue> read = json::parse_json(line);
    EXPECT_TRUE(read) << line;
    if (read && *read->find("event")->text() == event) found.push_back(std::move(*read));
  }
  return found;
}

TEST_F(Serve, TellsWhatBecameOfAJobInJsonWithItsRequestAndInALogOfItsOwn) {
  const fs::path napkin = napkin_folder("toile_logged");
  std::vector<std::string> options = plain();
  options.insert(options.end(), {"--log", "json"});
  Serving server(folder / "data", options);
  ASSERT_TRUE(server.up()) << server.said();
  const Ran afar =
      run_toile({"submit", napkin / "project.json", "--server", server.url(), "--watch", "--json"}, 240);
  ASSERT_EQ(afar.code, 0) << afar.err;
  const http::HttpReply jobs = server.get("/api/v1/jobs");
  const std::string id = *json::parse_json(jobs.body)->find("jobs")->array()->front().find("id")->text();
  const std::string own = server.get("/api/v1/jobs/" + id + "/log").body;
  for (const char* event : {"job queued", "job claimed", "phase", "job ended"}) {
    ASSERT_FALSE(events(own, event).empty()) << event << " is not in\n" << own;
    EXPECT_EQ(*events(own, event).front().find("job")->text(), id);
    EXPECT_TRUE(events(own, event).front().find("request")) << "whose request it was";
  }
  EXPECT_EQ(server.end(SIGTERM), 0);
  EXPECT_EQ(events(server.said(), "job ended").size(), 1u);
  EXPECT_TRUE(events(server.said(), "phase").empty()) << "light lines stand in the job's log only";
  fs::remove_all(napkin);
}

TEST_F(Serve, InAContainerListensOnEveryAddress) {
  std::vector<std::string> options = plain();
  options.insert(options.end(), {"--address", "0.0.0.0", "--container"});
  Serving server(folder / "data", options);
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(server.get("/readyz").status, 200);
}

TEST_F(Serve, TakesNoMoreThanAUserMayKeep) {
  std::vector<std::string> options = plain();
  options.insert(options.end(), {"--quota-mb", "0.0001"});
  Serving server(folder / "data", options);
  ASSERT_TRUE(server.up()) << server.said();
  const http::HttpReply refused = server.ask({.method = "POST",
                                              .target = "/api/v1/bodies?name=post.obj",
                                              .body = kPost,
                                              .content_type = "application/octet-stream",
                                              .headers = {}});
  EXPECT_EQ(refused.status, 507) << refused.body;
  EXPECT_EQ(member(refused.body, "code"), "quota.bytes");
}

TEST_F(Serve, BeginsWithTheSampleAndItsDrapeOnce) {
  const std::string skirt = std::string(TOILE_SOURCE_DIR) + "/samples/skirt";
  std::set<std::string> first;
  {
    Serving server(folder / "data", {"--sample", skirt, "--workers", "1"});
    ASSERT_TRUE(server.up()) << server.said();
    first = job_ids(server);
    EXPECT_EQ(first.size(), 1u) << server.said();
    EXPECT_NE(server.get("/api/v1/projects").body.find("skirt"), std::string::npos);
    EXPECT_EQ(server.end(SIGTERM, 60), 0);
  }
  Serving server(folder / "data", {"--sample", skirt, "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  EXPECT_EQ(job_ids(server), first);
}

TEST_F(Serve, RefusesOtherAddressesAndAFolderThatIsInUse) {
  const Ran open = run_toile({"serve", "--address", "0.0.0.0", "--port", "0", "--data", folder / "data"});
  EXPECT_EQ(open.code, 2);
  EXPECT_TRUE(open.err.starts_with("toile: server.address")) << open.err;
  Serving server(folder / "data", plain());
  ASSERT_TRUE(server.up());
  const Ran second = run_toile({"serve", "--port", "0", "--data", folder / "data"});
  EXPECT_EQ(second.signal, 0);
  EXPECT_NE(second.code, 0);
  EXPECT_NE(second.err.find("store."), std::string::npos) << second.err;
  const Ran taken = run_toile({"serve", "--port", std::to_string(server.port()), "--data", folder / "other"});
  EXPECT_TRUE(taken.err.starts_with("toile: server.port")) << taken.err;
}

TEST_F(Serve, ADrapeFromAfarLeavesWhatADrapeAtHomeLeaves) {
  const fs::path napkin =
      napkin_folder("toile_submit", R"("fabric": "cotton",)",
                    R"("texture": {"image": "checks.png", "scale_mm": 40}, "fabric": "cotton",)");
  const std::string checks = test::png_of(test::squares());
  write_text(napkin / "checks.png", checks);
  const Ran home = run_toile(
      {"drape", napkin / "project.json", "--out", folder / "home", "--check-data", "--no-stills"}, 120);
  ASSERT_EQ(home.code, 0) << home.err;
  Serving server(folder / "data", plain());
  ASSERT_TRUE(server.up());
  const Ran afar = run_toile({"submit", napkin / "project.json", "--server", server.url(), "--watch", "--out",
                              folder / "afar", "--json"},
                             240);
  EXPECT_EQ(afar.code, 0) << afar.err;
  EXPECT_EQ(afar.err, "");
  for (const char* name : {"final.obj", "final.glb", "rest.obj", "body.obj", "sewn.json"}) {
    EXPECT_GT(text_of(folder / "afar" / name).size(), 1u) << name;
    EXPECT_TRUE(text_of(folder / "afar" / name) == text_of(folder / "home" / name)) << name;
  }
  EXPECT_NE(text_of(folder / "afar" / "final.glb").find(checks), std::string::npos) << "with its picture";
  for (const char* name : {"report.json", "front.png", "back.png", "side.png", "three-quarter.png"}) {
    EXPECT_GT(text_of(folder / "afar" / name).size(), 100u) << name;
  }
  EXPECT_EQ(member(text_of(folder / "afar/report.json"), "hash"),
            member(text_of(folder / "home/report.json"), "hash"));
  EXPECT_EQ(member(afar.out, "hash"), member(text_of(folder / "home/report.json"), "hash"));
  fs::remove_all(napkin);
}

TEST_F(Serve, SubmitSaysByItsExitCodeHowItWent) {
  Serving server(folder / "data", plain());
  ASSERT_TRUE(server.up());
  const auto submit = [&](const fs::path& napkin, const std::function<bool()>& interrupt_once = {}) {
    const Ran run = run_toile(
        {"submit", napkin / "project.json", "--server", server.url(), "--watch", "--out", folder / "out"},
        300, interrupt_once);
    fs::remove_all(napkin);
    return run;
  };
  EXPECT_EQ(submit(napkin_folder("toile_submit", "\"max_time_s\": 8", "\"max_time_s\": 0.02")).code, 3);
  const Ran bad = submit(napkin_folder("toile_submit", "\"seams\"", "\"saems\""));
  EXPECT_EQ(bad.code, 2);
  EXPECT_TRUE(bad.err.starts_with("toile: project.unknown_key")) << bad.err;
  const Ran open = submit(napkin_folder("toile_submit", "[[0, 300], [0, 0]]", "[[0, 300], [0, 7]]"));
  EXPECT_EQ(open.code, 2) << "the server tells what is wrong";
  EXPECT_TRUE(open.err.starts_with("toile: pattern.open_outline")) << open.err;
  const Ran cancelled = submit(napkin_folder("toile_submit", "\"particle_distance_mm\": 25",
                                             "\"particle_distance_mm\": 5, \"settle_speed_mm_s\": 0.001"),
                               [] { return true; });
  EXPECT_EQ(cancelled.code, 4) << cancelled.err;
  const Ran nobody = run_toile({"submit", "nothing.json", "--server", "http://127.0.0.1:1"});
  EXPECT_EQ(nobody.code, 2);
  const fs::path napkin = napkin_folder("toile_submit");
  const Ran alone = run_toile({"submit", napkin / "project.json", "--server", "http://127.0.0.1:1"});
  EXPECT_EQ(alone.code, 1);
  EXPECT_TRUE(alone.err.starts_with("toile: client.unreachable")) << alone.err;
  EXPECT_EQ(run_toile({"submit", napkin / "project.json", "--server", "ftp://x"}).code, 2);
  fs::remove_all(napkin);
}

TEST_F(Serve, AfterAKillDuringSubmissionsEveryAcknowledgedJobIsThere) {
  std::set<std::string> acknowledged;
  std::string project;
  for (int round = 0; round < 3; ++round) {
    Serving server(folder / "data", plain());
    ASSERT_TRUE(server.up()) << server.said();
    if (project.empty()) project = make_project(server);
    ASSERT_FALSE(project.empty());
    std::mutex mutex;
    std::atomic<bool> stop{false};
    std::vector<std::thread> clients;
    for (int i = 0; i < 4; ++i) {
      clients.emplace_back([&, i] {
        for (int k = 0; k < 10 && !stop; ++k) {
          const std::string key = std::to_string(round) + "/" + std::to_string(i) + "/" + std::to_string(k);
          const http::HttpReply reply =
              server.post("/api/v1/jobs", "{\"project_id\": \"" + project + "\"}", key);
          const std::lock_guard lock(mutex);
          if (reply.status == 201) acknowledged.insert(member(reply.body, "id"));
        }
      });
    }
    for (int waited = 0; waited < 2000; ++waited) {  // in the middle of it
      {
        const std::lock_guard lock(mutex);
        if (acknowledged.size() >= static_cast<std::size_t>(10 * (round + 1))) break;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(server.end(SIGKILL), -SIGKILL);
    stop = true;
    for (std::thread& client : clients) client.join();
  }
  ASSERT_GE(acknowledged.size(), 30u);
  Serving server(folder / "data", plain());
  ASSERT_TRUE(server.up()) << server.said();
  const std::set<std::string> there = job_ids(server);
  for (const std::string& id : acknowledged) {
    EXPECT_TRUE(there.contains(id) || server.get("/api/v1/jobs/" + id).status == 200) << id << " is lost";
  }
}

}  // namespace
}  // namespace toile
