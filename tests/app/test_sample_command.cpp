#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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

/// Heights of one piece of a model, m.
struct Tops {
  double low = 1e9, high = -1e9;
  int count = 0;
};

Tops tops_of(const fs::path& obj, const std::string& piece) {
  std::ifstream in(obj);
  std::vector<double> heights;
  Tops tops;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      double x = 0, y = 0;
      words >> x >> y;
      heights.push_back(y);
    } else if (kind == "g" || kind == "o") {
      std::string name;
      words >> name;
      inside = name == piece;
    } else if (kind == "f" && inside) {
      for (std::string corner; words >> corner;) {
        const double y = heights[std::stoul(corner) - 1];
        tops.low = std::min(tops.low, y);
        tops.high = std::max(tops.high, y);
        ++tops.count;
      }
    }
  }
  return tops;
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

TEST(SampleCommand, TheJacketsTrunkStandsUprightOnEverySize) {
  for (const std::string size : {"eu34", "eu40", "eu46", "eu48"}) {
    const fs::path made = fresh_folder("toile_sample_jacket_" + size);
    ASSERT_EQ(run_toile({"sample", "jacket", "--preset", size, "--out", made}).code, 0) << size;
    const project::Project p = project::parse_project(text_of(made / "project.json")).value();
    for (const project::ProjectPiece& piece : p.pieces) {
      if (piece.id.find("sleeve") != std::string::npos) continue;
      ASSERT_TRUE(piece.placement.rigid) << size << ", " << piece.id;
      EXPECT_NEAR(piece.placement.rigid->rotation.z, 0, 0.1) << size << ", " << piece.id;
    }
  }
}

TEST(SampleCommand, TheJacketIsWornWithItsEaseAndItsCollarTurnedOver) {
  const fs::path kept = fs::path(TOILE_SOURCE_DIR) / "samples/jacket/project.json";
  const fs::path out = fresh_folder("toile_sample_jacket_worn");
  const Ran run = run_toile({"drape", kept, "--out", out});
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  const auto report = json::parse_json(text_of(out / "report.json"));
  EXPECT_EQ(*report->find("worn")->text(), "yes");
  EXPECT_EQ(*report->find("intersections")->find("worst_frame")->find("cloth_cloth")->number(), 0);
  EXPECT_EQ(*report->find("intersections")->find("worst_frame")->find("cloth_body")->number(), 0);
  for (const json::JsonValue& fit : *report->find("fit")->array()) {
    if (*fit.find("at")->text() == "waist") {
      EXPECT_NEAR(*fit.find("ease_mm")->number(), 90, 10);
    }
  }
  // What of the collar began highest, its outer edge, hangs below its roll line now: nothing reaches up as
  // far as stand and fall together would.
  const Tops collar = tops_of(out / "final.obj", "collar"), back = tops_of(out / "final.obj", "left_back");
  ASSERT_GT(collar.count, 100);
  EXPECT_LT(collar.high - back.high, 0.045);
  EXPECT_LT(collar.low, back.high) << "the fall covers the seam that holds the collar";
}

json::JsonValue drape_report(const fs::path& project, const fs::path& out) {
  const Ran run = run_toile({"drape", project, "--out", out});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const auto report = json::parse_json(text_of(out / "report.json"));
  const json::JsonValue* worst = report->find("intersections")->find("worst_frame");
  EXPECT_EQ(*worst->find("cloth_cloth")->number(), 0);
  EXPECT_EQ(*worst->find("cloth_body")->number(), 0);
  EXPECT_LT(*report->find("seam_gap_max_mm")->number(), 0.1);
  return *report;
}

TEST(SampleCommand, TheBlouseIsWornWithItsCollarAndCuffs) {
  const fs::path kept = fs::path(TOILE_SOURCE_DIR) / "samples/blouse/project.json";
  const fs::path out = fresh_folder("toile_sample_blouse_worn");
  const json::JsonValue report = drape_report(kept, out);
  EXPECT_EQ(*report.find("worn")->text(), "yes");
  const Tops fall = tops_of(out / "final.obj", "collar"), stand = tops_of(out / "final.obj", "collar_stand");
  ASSERT_GT(fall.count, 100);
  EXPECT_LT(fall.high, stand.high + 0.005) << "the collar is turned down";
  EXPECT_LT(fall.low, stand.low - 0.01) << "its points lie on the fronts";
}

TEST(SampleCommand, TheChairCoverFitsItsChair) {
  const fs::path out = fresh_folder("toile_sample_chair_cover");
  drape_report(fs::path(TOILE_SOURCE_DIR) / "samples/chair-cover/project.json", out);
  const Tops seat = tops_of(out / "final.obj", "seat"), top = tops_of(out / "final.obj", "top_boxing");
  ASSERT_GT(seat.count, 100);
  EXPECT_GT(seat.low, 0.465) << "its seams lie along the seat's edges";
  EXPECT_LT(seat.high, 0.490) << "it lies on the seat";
  EXPECT_GT(top.low, 0.990 - 0.004) << "the boxing lies over the back's top";
  for (const std::string side : {"front", "back", "left", "right"}) {
    const Tops skirt = tops_of(out / "final.obj", side + "_skirt");
    EXPECT_GT(skirt.low, 0.005) << side << ": the hem clears the floor";
    EXPECT_LT(skirt.low, 0.030) << side << ": and hangs down to it";
  }
}

TEST(SampleCommand, TheCurtainHangsLevelByItsHooks) {
  const fs::path folder = fresh_folder("toile_sample_curtain");
  fs::copy(fs::path(TOILE_SOURCE_DIR) / "samples/curtain", folder / "curtain");
  project::Project p = project::parse_project(text_of(folder / "curtain/project.json")).value();
  p.settings.particle_distance_mm = 30;  // as it hangs, in less time
  write_text(folder / "curtain/project.json", project::write_project(p));
  const json::JsonValue report = drape_report(folder / "curtain/project.json", folder / "out");
  int hooks = 0;
  for (const json::JsonValue& hook : *report.find("attachments")->array()) {
    EXPECT_LT(*hook.find("off_mm")->number(), 2) << *hook.find("id")->text();
    ++hooks;
  }
  EXPECT_EQ(hooks, 24);
  for (const std::string side : {"left", "right"}) {
    const Tops curtain = tops_of(folder / "out/final.obj", side + "_curtain");
    EXPECT_NEAR(curtain.low, 0.200, 0.015) << "the hem, 1.3 m below the tape at 1.5 m";
    const Tops heading = tops_of(folder / "out/final.obj", side + "_heading");
    EXPECT_GT(heading.high, 1.51) << "stands up above its tape";
  }
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

TEST(SampleCommand, RefusesAWearerOfWhatNobodyWears) {
  using Words = std::vector<std::string>;
  for (const std::string name : {"curtain", "chair-cover", "tablecloth"}) {
    for (const Words& asked : {Words{"--preset", "eu40"}, Words{"--body", "person.obj"},
                               Words{"--sex", "male"}, Words{"--arm-length", "60"}}) {
      const fs::path out = fresh_folder("toile_sample_wearer") / "made";
      const Ran run = run_toile({"sample", name, asked[0], asked[1], "--out", out});
      EXPECT_EQ(run.code, 2) << name << " " << asked[0];
      EXPECT_NE(run.err.find("usage.wearer"), std::string::npos) << run.err;
      EXPECT_NE(run.err.find("leave " + asked[0] + " out"), std::string::npos) << run.err;
      EXPECT_FALSE(fs::exists(out)) << "nothing is written";
    }
  }
}

}  // namespace
}  // namespace toile
