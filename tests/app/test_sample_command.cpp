#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "core/json/tree.h"
#include "core/project/project.h"
#include "tests/app/program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

std::set<std::string> listed() {
  const Ran run = run_toile({"sample", "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  const auto tree = json::parse_json(run.out);
  std::set<std::string> names;
  for (const json::JsonValue& one : *tree->find("samples")->array()) names.insert(*one.find("name")->text());
  return names;
}

TEST(SampleCommand, DraftsTheSamplesThatAreKept) {
  const fs::path kept = fs::path(TOILE_SOURCE_DIR) / "samples";
  for (const std::string& name : listed()) {
    const fs::path made = fresh_folder("toile_sample_" + name);
    const Ran run = run_toile({"sample", name, "--out", made});
    ASSERT_EQ(run.code, 0) << name << ": " << run.err;
    for (const auto& file : fs::directory_iterator(made)) {
      const fs::path other = kept / name / file.path().filename();
      EXPECT_TRUE(fs::exists(other)) << other << " (scripts/samples.sh writes it)";
      EXPECT_TRUE(text_of(other) == text_of(file.path()))
          << other << " is not what the program drafts; scripts/samples.sh writes it anew";
    }
    EXPECT_TRUE(fs::exists(kept / name / "picture.jpg")) << name;
  }
}

TEST(SampleCommand, DraftsToTheMeasuresOfAPreset) {
  const fs::path made = fresh_folder("toile_sample_measures");
  const Ran run =
      run_toile({"sample", "tshirt", "--preset", "m50", "--waist", "95", "--out", made, "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto tree = json::parse_json(run.out);
  for (const json::JsonValue& girth : *tree->find("girths")->array()) {
    const double wanted = *girth.find("place")->text() == "bust"    ? 1000
                          : *girth.find("place")->text() == "waist" ? 950
                                                                    : 1010;
    if (*girth.find("place")->text() == "hip") continue;  // it goes with the waist
    EXPECT_NEAR(*girth.find("body_mm")->number(), wanted, 15) << run.out;
    EXPECT_GT(*girth.find("ease_mm")->number(), 50);
  }
}

TEST(SampleCommand, DraftsForTheBodyOfAFileAndBringsItAlong) {
  const fs::path made = fresh_folder("toile_sample_body"), person = made / "person.obj";
  ASSERT_EQ(run_toile({"body", "make", "--preset", "child140", "--out", person}).code, 0);
  const Ran run = run_toile({"sample", "slacks", "--body", person, "--out", made / "slacks", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const project::Project p = project::parse_project(text_of(made / "slacks/project.json")).value();
  EXPECT_EQ(p.bodies.front().file, "body.obj");
  EXPECT_TRUE(fs::exists(made / "slacks/body.obj"));
  EXPECT_EQ(run_toile({"check", made / "slacks/project.json"}).code, 0);
}

TEST(SampleCommand, SaysWhatIsWrongWithWhatItWasAsked) {
  EXPECT_NE(
      run_toile({"sample", "toga", "--out", fresh_folder("toile_sample_none")}).err.find("usage.sample"),
      std::string::npos);
  EXPECT_NE(run_toile({"sample", "tshirt"}).err.find("--out"), std::string::npos);
  const Ran cloth =
      run_toile({"sample", "tshirt", "--cloth", "tweed", "--out", fresh_folder("toile_sample_cloth")});
  EXPECT_EQ(cloth.code, 2);
  EXPECT_NE(cloth.err.find("sample.cloth"), std::string::npos) << cloth.err;
}

}  // namespace
}  // namespace toile
