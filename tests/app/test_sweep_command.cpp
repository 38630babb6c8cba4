// `toile sweep` as a user runs it, here and on a server.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/image/read_picture.h"
#include "core/json/tree.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class SweepCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_sweep");
    fs::create_directories(folder / "empty");
    napkin = napkin_folder("toile_sweep_napkin");
    write_text(napkin / "low.obj", low_post());
  }
  void TearDown() override {
    fs::remove_all(folder);
    fs::remove_all(napkin);
  }
  /// 10 cm less of it.
  static std::string low_post() {
    std::string text = kPost;
    for (std::size_t at = 0; (at = text.find(" 0.5 ", at)) != std::string::npos; at += 5)
      text.replace(at, 5, " 0.4 ");
    return text;
  }
  static long lines_of(const fs::path& file) {
    const std::string text = text_of(file);
    return std::count(text.begin(), text.end(), '\n');
  }
  static std::string hash_in(const fs::path& report) {
    const auto read = json::parse_json(text_of(report), {.depth = 64});
    const json::JsonValue* hash = read ? read->find("hash") : nullptr;
    return hash && hash->text() ? *hash->text() : "";
  }
  Ran sweep(std::vector<std::string> more, const std::string& out) {
    std::vector<std::string> words{"sweep", napkin / "project.json", "--out", folder / out};
    words.insert(words.end(), more.begin(), more.end());
    return run_toile(words, 600);
  }

  fs::path folder, napkin;
};

TEST_F(SweepCommand, LeavesATableASheetAndEachDrape) {
  const Ran ran = sweep({"--body", "own", napkin / "low.obj", "--fabric", "own", "silk-habotai"}, "here");
  ASSERT_EQ(ran.code, 0) << ran.err << ran.out;
  EXPECT_NE(ran.out.find("low.obj"), std::string::npos) << ran.out;
  EXPECT_EQ(lines_of(folder / "here/table.csv"), 5);
  const auto table = json::parse_json(text_of(folder / "here/table.json"), {.depth = 64});
  ASSERT_TRUE(table);
  ASSERT_EQ(table->find("cells")->array()->size(), 4u);
  EXPECT_EQ(*table->find("cells")->array()->front().find("fabric")->text(), "cotton");
  EXPECT_TRUE(image::read_picture(text_of(folder / "here/sheet.png"), {.shown_side = 4096}));
  for (const char* cell :
       {"post.obj_cotton", "post.obj_silk-habotai", "low.obj_cotton", "low.obj_silk-habotai"}) {
    EXPECT_TRUE(fs::exists(folder / "here" / cell / "front.png")) << cell;
    EXPECT_NE(hash_in(folder / "here" / cell / "report.json"), "") << cell;
  }
  const Ran plain =
      run_toile({"drape", napkin / "project.json", "--out", folder / "plain", "--no-stills"}, 300);
  ASSERT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(hash_in(folder / "here/post.obj_cotton/report.json"), hash_in(folder / "plain/report.json"))
      << "a cell is a drape as any other";
  EXPECT_NE(hash_in(folder / "here/low.obj_cotton/report.json"), hash_in(folder / "plain/report.json"));
  EXPECT_EQ(run_toile({"verify", folder / "here/low.obj_silk-habotai"}, 300).code, 0);
}

TEST_F(SweepCommand, OnAServerIsTheSame) {
  Serving server(folder / "data", {"--sample", folder / "empty", "--workers", "2"});
  ASSERT_TRUE(server.up()) << server.said();
  const std::vector<std::string> words{"--body", "own", napkin / "low.obj", "--fabric", "silk-habotai"};
  std::vector<std::string> afar = words;
  afar.insert(afar.end(), {"--server", server.url(), "--json"});
  const Ran there = sweep(afar, "afar"), here = sweep(words, "here");
  ASSERT_EQ(there.code, 0) << there.err << there.out;
  ASSERT_EQ(here.code, 0) << here.err;
  EXPECT_TRUE(json::parse_json(there.out, {.depth = 64})) << there.out;
  for (const char* cell : {"post.obj_silk-habotai", "low.obj_silk-habotai"}) {
    EXPECT_NE(hash_in(folder / "afar" / cell / "report.json"), "");
    EXPECT_EQ(hash_in(folder / "afar" / cell / "report.json"),
              hash_in(folder / "here" / cell / "report.json"));
  }
  EXPECT_EQ(lines_of(folder / "afar/table.csv"), 3);
  EXPECT_TRUE(fs::exists(folder / "afar/sheet.png"));
  const auto swept = json::parse_json(server.get("/api/v1/sweeps").body, {.depth = 64});
  const std::string id = *swept->find("sweeps")->array()->front().find("id")->text();
  fs::remove(folder / "afar/low.obj_silk-habotai/final.glb");
  const Ran again =
      run_toile({"sweep", "--sweep", id, "--server", server.url(), "--out", folder / "afar"}, 60);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(fs::exists(folder / "afar/low.obj_silk-habotai/final.glb")) << "what is missing is fetched";
}

TEST_F(SweepCommand, GoesOnOverAServerThatIsKilled) {
  const std::vector<std::string> options{"--sample", folder / "empty",     "--workers",
                                         "1",        "--checkpoint-every", "0.2"};
  auto server = std::make_unique<Serving>(folder / "data", options);
  ASSERT_TRUE(server->up()) << server->said();
  const int port = server->port();
  const std::vector<std::string> words{"--fabric", "own", "silk-habotai", "denim-10oz"};
  Ran there;
  std::thread client([&] {
    std::vector<std::string> afar = words;
    afar.insert(afar.end(), {"--server", "http://127.0.0.1:" + std::to_string(port), "--patience", "240"});
    there = sweep(afar, "afar");
  });
  const auto is_amidst = [&] {
    const std::string jobs = server->get("/api/v1/jobs").body;
    return jobs.find("\"succeeded\"") != std::string::npos && jobs.find("\"running\"") != std::string::npos;
  };
  for (int waited = 0; waited < 4000 && !is_amidst(); ++waited)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(is_amidst());
  EXPECT_EQ(server->end(SIGKILL), -SIGKILL);
  server = std::make_unique<Serving>(folder / "data", options, port);
  client.join();
  ASSERT_TRUE(server->up()) << server->said();
  ASSERT_EQ(there.code, 0) << there.err << there.out;
  const auto swept = json::parse_json(server->get("/api/v1/sweeps").body, {.depth = 64});
  ASSERT_EQ(swept->find("sweeps")->array()->size(), 1u) << "asked for once";
  EXPECT_EQ(*swept->find("sweeps")->array()->front().find("counts")->find("succeeded")->number(), 3);
  ASSERT_EQ(sweep(words, "here").code, 0);
  for (const char* cell : {"post.obj_cotton", "post.obj_silk-habotai", "post.obj_denim-10oz"})
    EXPECT_EQ(hash_in(folder / "afar" / cell / "report.json"),
              hash_in(folder / "here" / cell / "report.json"));
}

TEST_F(SweepCommand, SaysWhatIsWrongBeforeItDrapes) {
  const auto refused = [&](std::vector<std::string> more, const std::string& begins) {
    const Ran ran = sweep(std::move(more), "bad");
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("toile: " + begins)) << ran.err;
  };
  refused({"--fabric", "silk-habotay"}, "project.unknown_fabric");
  refused({"--fabric", "poplin", "poplin"}, "sweep.duplicate");
  refused({"--body", "eu39"}, "project.unknown_preset");
  refused({"--body", "eu40,waist=wide"}, "usage.body");
  refused({"--body", "eu40,waist=900"}, "project.");
  refused({"--body", "eu40,tall"}, "usage.body");
  EXPECT_FALSE(fs::exists(folder / "bad"));
  EXPECT_EQ(run_toile({"sweep", "--out", folder / "bad"}).code, 2);
  const Ran alone = sweep({"--server", "http://127.0.0.1:1"}, "bad");
  EXPECT_EQ(alone.code, 1);
  EXPECT_TRUE(alone.err.starts_with("toile: client.unreachable")) << alone.err;
}

TEST_F(SweepCommand, ExitsAsTheWorstOfItsDrapes) {
  std::string text = text_of(napkin / "project.json");
  text.replace(text.find("\"max_time_s\": 8"), 15, "\"max_time_s\": 0.02");
  write_text(napkin / "project.json", text);
  EXPECT_EQ(sweep({"--fabric", "poplin"}, "short").code, 3);
  EXPECT_NE(text_of(folder / "short/table.csv").find(",time,"), std::string::npos);
}

}  // namespace
}  // namespace toile
