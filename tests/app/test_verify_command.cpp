#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/json/tree.h"
#include "core/manifest/manifest.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// One drape for all of these tests; each works on a copy.
class VerifyCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    draped() = napkin_folder("toile_verify_draped", "\"max_time_s\": 8", "\"max_time_s\": 0.2");
    const Ran run = run_toile(
        {"drape", draped() / "project.json", "--out", draped() / "out", "--no-stills", "--check-data"});
    ASSERT_EQ(run.code, 3) << run.err;  // the time is over, and that is an end like any other
  }
  static void TearDownTestSuite() { fs::remove_all(draped()); }
  void SetUp() override {
    folder = fresh_folder("toile_verify");
    fs::copy(draped(), folder, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  void TearDown() override { fs::remove_all(folder); }

  Ran verified(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"verify", folder / "out"};
    words.insert(words.end(), more.begin(), more.end());
    return run_toile(words);
  }
  void change(const fs::path& path, const std::string& from, const std::string& to) const {
    std::string text = text_of(folder / path);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << path;
    write_text(folder / path, text.replace(at, from.size(), to));
  }
  static fs::path& draped() {
    static fs::path path;
    return path;
  }

  fs::path folder;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(VerifyCommand, ASecondDrapeHasTheSameBytes) {
  const Ran run = verified({"--json"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const auto tree = json::parse_json(run.out);
  ASSERT_TRUE(tree) << run.out;
  EXPECT_TRUE(*tree->find("same")->boolean());
  EXPECT_TRUE(*tree->find("same_program")->boolean());
  EXPECT_EQ(tree->find("inputs")->find("same")->array()->size(), 2u) << "the document and the body";
  EXPECT_EQ(tree->find("drape")->find("files")->find("same")->array()->size(), 8u);
  EXPECT_EQ(*tree->find("drape")->find("farthest_mm")->number(), 0);
}

TEST_F(VerifyCommand, ADocumentThatIsOnlyWrittenOtherwiseIsTheSame) {
  change("project.json", "{\n  \"toile\": 1,", "{ \"toile\": 1,");
  const Ran run = verified({"--files-only"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST_F(VerifyCommand, NamesTheInputThatChangedAndDoesNotDrape) {
  change("post.obj", "0.5", "0.51");
  const Ran run = verified();
  EXPECT_EQ(run.code, 6) << run.err;
  EXPECT_TRUE(has(run.out, "not the same")) << run.out;
  EXPECT_TRUE(has(run.out, "post.obj changed")) << run.out;
  EXPECT_TRUE(has(run.out, "not tried")) << run.out;
}

TEST_F(VerifyCommand, NamesTheResultThatWasTouchedAndTellsOfOneThatIsGone) {
  change("out/final.obj", "v ", "v  ");
  fs::remove(folder / "out" / "rest.obj");
  const Ran run = verified({"--files-only"});
  EXPECT_EQ(run.code, 6) << run.err;
  EXPECT_TRUE(has(run.out, "final.obj changed; rest.obj not there")) << run.out;
}

TEST_F(VerifyCommand, TellsADrapeThatComesOutOtherwise) {
  const std::string text = text_of(folder / "out" / manifest::kManifestFile);
  const auto read = manifest::parse_manifest(text);
  ASSERT_TRUE(read);
  manifest::Manifest other = *read;
  other.positions = std::string(32, '0');
  other.made_by.engine = 1;
  write_text(folder / "out" / manifest::kManifestFile, manifest::write_manifest(other));
  const Ran run = verified();
  EXPECT_EQ(run.code, 6) << run.err;
  EXPECT_TRUE(has(run.out, "then toile")) << run.out;
  EXPECT_TRUE(has(run.out, "0.0000 mm at most")) << "its cloth hangs the same: " << run.out;
}

TEST_F(VerifyCommand, SaysWhatIsMissingAndTheWayOut) {
  fs::rename(folder / "project.json", folder / "moved.json");
  const Ran lost = verified();
  EXPECT_EQ(lost.code, 2);
  EXPECT_TRUE(has(lost.err, "name it with --project")) << lost.err;
  const Ran told = verified({"--files-only", "--project", folder / "moved.json"});
  EXPECT_EQ(told.code, 0) << told.out << told.err;
  fs::remove(folder / "out" / manifest::kManifestFile);
  const Ran none = verified();
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(has(none.err, "manifest.file")) << none.err;
}

TEST_F(VerifyCommand, SaysWhereAManifestIsDamaged) {
  change("out/manifest.json", "\"steps\"", "\"stepz\"");
  const Ran run = verified();
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(has(run.err, "manifest.damaged: the key \"stepz\" is not known")) << run.err;
  write_text(folder / "out" / manifest::kManifestFile, "{\n");
  EXPECT_TRUE(has(verified().err, "manifest.json: line 2")) << verified().err;
}

TEST_F(VerifyCommand, LooksIntoNoOtherFolder) {
  change("out/manifest.json", "\"final.obj\"", "\"../project.json\"");
  const Ran run = verified({"--files-only"});
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_TRUE(has(run.out, "../project.json not there")) << run.out;
}

TEST_F(VerifyCommand, FollowsADrapeThatWentOnFromAnother) {
  const Ran on = run_toile(
      {"drape", folder / "project.json", "--out", folder / "on", "--no-stills", "--from", folder / "out"});
  ASSERT_NE(on.code, 2) << on.err;
  const Ran run = run_toile({"verify", folder / "on"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  fs::remove(folder / "out" / "final.hung");
  const Ran lost = run_toile({"verify", folder / "on"});
  EXPECT_EQ(lost.code, 2);
  EXPECT_TRUE(has(lost.err, "--from")) << lost.err;
}

TEST_F(VerifyCommand, LetsHandsDoAgainWhatTheyDid) {
  write_text(folder / "hands.log",
             R"({"toile_drape_log": 1, "touches": [
                 {"step": 100, "touch": "pull", "id": 1, "triangle": 5, "shares": [0.2, 0.3, 0.5], "to": [0.1, 1.5, 0.2]},
                 {"step": 300, "touch": "pin", "id": 1, "triangle": 9, "shares": [1, 0, 0]},
                 {"step": 400, "touch": "let_go", "id": 1}]})");
  const auto drape = [&](const char* out, const fs::path& log) {
    return run_toile(
        {"drape", folder / "project.json", "--out", folder / out, "--no-stills", "--replay", log});
  };
  const Ran held = drape("held", folder / "hands.log");
  ASSERT_EQ(held.code, 3) << held.err;
  const fs::path log = folder / "held" / "drape.log";
  ASSERT_TRUE(fs::exists(log));
  EXPECT_NE(text_of(folder / "held" / "final.obj"), text_of(folder / "out" / "final.obj")) << "they moved it";
  const Ran run = run_toile({"verify", folder / "held"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  ASSERT_EQ(drape("again", log).code, 3);
  EXPECT_EQ(text_of(folder / "again" / "drape.log"), text_of(log));
  EXPECT_EQ(text_of(folder / "again" / "final.hung"), text_of(folder / "held" / "final.hung"));

  change("held/drape.log", "\"step\": 400", "\"step\": 500");
  EXPECT_EQ(run_toile({"verify", folder / "held"}).code, 6) << "other hands, another drape";
  change("held/drape.log", "\"let_go\"", "\"let_fly\"");
  const Ran damaged = drape("damaged", log);
  EXPECT_EQ(damaged.code, 2);
  EXPECT_TRUE(has(damaged.err, "log.damaged")) << damaged.err;
  EXPECT_EQ(drape("none", folder / "no.log").code, 2);
}

TEST_F(VerifyCommand, AJobOfTheServiceHasTheBytesOfTheCommandLine) {
  Serving server(folder / "data", {"--no-sample", "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  const Ran sent = run_toile(
      {"submit", folder / "project.json", "--server", server.url(), "--watch", "--out", folder / "remote"});
  EXPECT_TRUE(fs::exists(folder / "remote" / manifest::kManifestFile)) << sent.out << sent.err;
  const Ran unnamed = run_toile({"verify", folder / "remote"});
  EXPECT_EQ(unnamed.code, 2) << "a store does not tell where a document stood";
  const Ran run = run_toile({"verify", folder / "remote", "--project", folder / "project.json"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(has(run.out, "8 files again in the same bytes")) << run.out;
}

}  // namespace
}  // namespace toile
