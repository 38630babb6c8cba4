// `toile submit` over a line that breaks and to a server that crashes: nothing is done twice, nothing is
// lost.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "core/json/tree.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class BrokenLine : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_broken_line");
    fs::create_directories(folder / "empty");
    napkin = napkin_folder("toile_broken_napkin");
  }
  void TearDown() override {
    fs::remove_all(folder);
    fs::remove_all(napkin);
  }
  /// Without a drape of its own; at `port` when it is not 0.
  std::unique_ptr<Serving> serve(int port = 0) {
    std::vector<std::string> options{"--sample", folder / "empty",     "--workers",
                                     "1",        "--checkpoint-every", "0.2"};
    return std::make_unique<Serving>(folder / "data", options, port);
  }
  static std::size_t count(const Serving& server, const std::string& what) {
    const auto tree = json::parse_json(server.get("/api/v1/" + what).body, {.depth = 64});
    const json::JsonValue* list = tree ? tree->find(what) : nullptr;
    return list && list->array() ? list->array()->size() : 0;
  }
  static std::string newest_job(const Serving& server) {
    const auto tree = json::parse_json(server.get("/api/v1/jobs").body, {.depth = 64});
    const std::vector<json::JsonValue>& jobs = *tree->find("jobs")->array();
    return jobs.empty() ? "" : *jobs.front().find("id")->text();
  }
  static std::string hash_in(const fs::path& report) {
    const auto read = json::parse_json(text_of(report), {.depth = 64});
    const json::JsonValue* hash = read ? read->find("hash") : nullptr;
    return hash && hash->text() ? *hash->text() : "";
  }

  fs::path folder, napkin;
};

TEST_F(BrokenLine, AServerThatCrashesIsWaitedForAndGoesOn) {
  std::string text = text_of(napkin / "project.json");
  text.replace(text.find("\"particle_distance_mm\": 25"), 26, "\"particle_distance_mm\": 12");
  write_text(napkin / "project.json", text);
  std::unique_ptr<Serving> server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  const int port = server->port();
  Ran ran;
  std::thread client([&] {
    ran =
        run_toile({"submit", napkin / "project.json", "--server", "http://127.0.0.1:" + std::to_string(port),
                   "--watch", "--out", folder / "out", "--patience", "240"},
                  600);
  });
  const auto runs = [&] {
    return server->get("/api/v1/jobs?state=running").body.find("\"phase\": \"drape\"") != std::string::npos;
  };
  for (int waited = 0; waited < 4000 && !runs(); ++waited)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(server->end(SIGKILL), -SIGKILL);
  server = serve(port);
  client.join();
  ASSERT_TRUE(server->up()) << server->said();
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(count(*server, "jobs"), 1u) << "asked for once";
  EXPECT_EQ(count(*server, "projects"), 1u);
  const Ran here =
      run_toile({"drape", napkin / "project.json", "--out", folder / "here", "--no-stills"}, 300);
  ASSERT_EQ(here.code, 0) << here.err;
  EXPECT_EQ(hash_in(folder / "out/report.json"), hash_in(folder / "here/report.json"));
}

TEST_F(BrokenLine, WhatTheServerHasIsNotSentAgain) {
  const std::unique_ptr<Serving> server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  const std::vector<std::string> words{"submit", napkin / "project.json", "--server", server->url()};
  ASSERT_EQ(run_toile(words).code, 0);
  const auto uploads = [&] {
    const std::string said = server->said();
    std::size_t found = 0;
    for (std::size_t at = 0; (at = said.find("POST", at)) != std::string::npos; at += 4)
      found += said.substr(at, 120).find("/api/v1/assets") != std::string::npos;
    return found;
  };
  EXPECT_EQ(uploads(), 1u) << server->said();
  ASSERT_EQ(run_toile(words).code, 0);
  EXPECT_EQ(uploads(), 1u) << "the post is there";
  write_text(napkin / "post.obj", std::string(kPost) + "# longer\n");
  ASSERT_EQ(run_toile(words).code, 0);
  EXPECT_EQ(uploads(), 2u);
  EXPECT_EQ(count(*server, "projects"), 3u);
}

TEST_F(BrokenLine, ADrapeIsTakenUpAgainAndOnlyWhatIsMissingIsFetched) {
  const std::unique_ptr<Serving> server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  ASSERT_EQ(run_toile({"submit", napkin / "project.json", "--server", server->url()}).code, 0);
  const std::vector<std::string> words{"submit",  "--job", newest_job(*server), "--server", server->url(),
                                       "--watch", "--out", folder / "out"};
  ASSERT_EQ(run_toile(words, 300).code, 0);
  const std::string cloth = text_of(folder / "out/final.obj");
  EXPECT_FALSE(cloth.empty());
  write_text(folder / "out/final.obj", cloth.substr(0, cloth.size() / 2));
  const fs::file_time_type before = fs::last_write_time(folder / "out/final.glb");
  ASSERT_EQ(run_toile(words, 300).code, 0);
  EXPECT_EQ(text_of(folder / "out/final.obj"), cloth) << "what a break has cut off is fetched again";
  EXPECT_EQ(fs::last_write_time(folder / "out/final.glb"), before) << "and nothing else";
  EXPECT_EQ(run_toile({"verify", folder / "out", "--files-only", "--project", napkin / "project.json"}).code,
            0);
}

TEST_F(BrokenLine, SaysWhereTheDrapeGoesOnWhenItsPatienceEnds) {
  std::string text = text_of(napkin / "project.json");
  text.replace(text.find("\"particle_distance_mm\": 25"), 26,
               "\"particle_distance_mm\": 5, \"settle_speed_mm_s\": 0.001");
  write_text(napkin / "project.json", text);
  const std::unique_ptr<Serving> server = serve();
  ASSERT_TRUE(server->up()) << server->said();
  Ran ran;
  std::thread client([&] {
    ran = run_toile(
        {"submit", napkin / "project.json", "--server", server->url(), "--watch", "--patience", "1"}, 300);
  });
  // Long after the answer that tells the client which job its request made.
  const auto drapes = [&] {
    return server->get("/api/v1/jobs?state=running").body.find("\"phase\": \"drape\"") != std::string::npos;
  };
  for (int waited = 0; waited < 4000 && !drapes(); ++waited)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const std::string job = newest_job(*server);
  EXPECT_EQ(server->end(SIGKILL), -SIGKILL);
  client.join();
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(job, "");
  EXPECT_NE(ran.err.find("toile submit --job " + job), std::string::npos) << ran.err;
}

TEST_F(BrokenLine, WantsAProjectOrADrape) {
  EXPECT_EQ(run_toile({"submit"}).code, 2);
  EXPECT_EQ(run_toile({"submit", napkin / "project.json", "--job", "j_1"}).code, 2);
  const Ran bare = run_toile({});
  EXPECT_EQ(bare.code, 2);
  EXPECT_NE(bare.err.find("drape"), std::string::npos) << "it says what there is: " << bare.err;
}

}  // namespace
}  // namespace toile
