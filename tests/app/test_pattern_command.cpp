#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/json/tree.h"
#include "core/project/project.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A half front in two sizes with a mirror line and a notch, inches.
const std::string kGraded = [] {
  std::string blocks, inserts;
  for (const int size : {36, 38}) {
    const std::string name = "FRONT_" + std::to_string(size), width = std::to_string(size / 4);
    blocks +=
        "0\nBLOCK\n8\n0\n2\n" + name +
        "\n70\n64\n10\n0.0\n20\n0.0\n0\nTEXT\n8\n1\n10\n1\n20\n1\n1\nSIZE: " + std::to_string(size) +
        "\n0\nTEXT\n8\n1\n10\n1\n20\n1\n1\nPiece Name: FRONT\n"
        "0\nPOLYLINE\n8\n1\n66\n1\n70\n1\n0\nVERTEX\n8\n1\n10\n0\n20\n0\n0\nVERTEX\n8\n1\n10\n" +
        width + "\n20\n0\n0\nVERTEX\n8\n1\n10\n" + width +
        "\n20\n24\n0\nVERTEX\n8\n1\n10\n0\n20\n24\n0\nSEQEND\n8\n1\n"
        "0\nPOINT\n8\n4\n10\n" +
        width +
        "\n20\n12\n30\n0.25\n"
        "0\nLINE\n8\n6\n10\n0\n20\n0\n11\n0\n21\n24\n0\nLINE\n8\n7\n10\n2\n20\n3\n11\n2\n21\n9\n0\nENDBLK\n";
    inserts += "0\nINSERT\n8\n1\n2\n" + name + "\n10\n0.0\n20\n0.0\n";
  }
  return "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" + blocks +
         "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + inserts +
         "0\nTEXT\n8\n1\n10\n0\n20\n0\n1\nSample Size: 36\n0\nTEXT\n8\n1\n10\n0\n20\n0\n1\nUnits: ENGLISH\n"
         "0\nENDSEC\n0\nEOF\n";
}();

TEST(PatternCommand, ImportTellsPiecesUnitAndEveryEntity) {
  const fs::path folder = fresh_folder("toile_pattern");
  write_text(folder / "graded.dxf", kGraded);
  const Ran run = run_toile({"pattern", "import", folder / "graded.dxf", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto tree = json::parse_json(run.out);
  ASSERT_TRUE(tree) << run.out;
  EXPECT_EQ(*tree->find("unit")->find("name")->text(), "inch");
  EXPECT_GT(*tree->find("unit")->find("confidence")->number(), 0.9);
  EXPECT_FALSE(tree->find("unit")->find("evidence")->array()->empty());
  EXPECT_EQ(tree->find("sizes")->array()->size(), 2u);
  ASSERT_EQ(tree->find("pieces")->array()->size(), 1u);
  const json::JsonValue& piece = tree->find("pieces")->array()->front();
  EXPECT_EQ(*piece.find("name")->text(), "FRONT");
  EXPECT_EQ(*piece.find("size")->text(), "36");
  EXPECT_NEAR(*piece.find("width_mm")->number(), 18 * 25.4, 1e-3);
  EXPECT_NEAR(*piece.find("height_mm")->number(), 24 * 25.4, 1e-3);
  EXPECT_NEAR(*piece.find("area_mm2")->number(), 18 * 24 * 25.4 * 25.4, 1e-2);
  EXPECT_EQ(*piece.find("notches")->number(), 2);
  EXPECT_EQ(*piece.find("grain_deg")->number(), 90);
  EXPECT_TRUE(*piece.find("unfolded")->boolean());
  const json::JsonValue& counts = *tree->find("report")->find("counts");
  const auto count = [&](const char* key) { return *counts.find(key)->number(); };
  EXPECT_EQ(count("entities"), count("kept") + count("converted") + count("dropped"));
  EXPECT_EQ(count("entities"), 2 * 6 + 4);
  fs::remove_all(folder);
}

TEST(PatternCommand, ImportLeavesTheSeamsOutWhenAsked) {
  const fs::path folder = fresh_folder("toile_pattern");
  std::string pieces;
  for (const char* left : {"0", "500"}) {
    const std::string right = std::to_string(std::atoi(left) + 400);
    pieces += std::string("0\nLWPOLYLINE\n8\n1\n90\n4\n70\n1\n10\n") + left + "\n20\n0\n10\n" + right +
              "\n20\n0\n10\n" + right + "\n20\n600\n10\n" + left + "\n20\n600\n";
  }
  write_text(folder / "two.dxf", "0\nSECTION\n2\nENTITIES\n" + pieces + "0\nENDSEC\n0\nEOF\n");
  const auto seams_of = [](const Ran& run) {
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse_json(run.out)->find("seams")->array()->size();
  };
  EXPECT_GT(seams_of(run_toile({"pattern", "import", folder / "two.dxf", "--json"})), 0u);
  EXPECT_EQ(seams_of(run_toile({"pattern", "import", folder / "two.dxf", "--json", "--no-seams"})), 0u);
  EXPECT_EQ(run_toile({"pattern", "import", folder / "two.dxf", "--no-seams"}).code, 2) << "--json is needed";
  fs::remove_all(folder);
}

TEST(PatternCommand, ImportTakesTheSizeAndUnitAskedFor) {
  const fs::path folder = fresh_folder("toile_pattern");
  write_text(folder / "graded.dxf", kGraded);
  const Ran run = run_toile({"pattern", "import", folder / "graded.dxf", "--size", "38", "--unit", "cm"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(run.out, "piece FRONT: 180.0 x 240.0 mm")) << run.out;
  EXPECT_TRUE(has(run.out, "size 38 of 36, 38")) << run.out;
  const Ran none = run_toile({"pattern", "import", folder / "graded.dxf", "--size", "52"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(none.err.starts_with("toile: dxf.unknown_size: ")) << none.err;
  fs::remove_all(folder);
}

/// A square of 300 mm on layer 5, and a line in it on layer 1.
const std::string kOdd =
    "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n5\n90\n4\n70\n1\n10\n0\n20\n0\n10\n300\n20\n0\n10\n300\n20\n3"
    "00\n10\n0\n20\n"
    "300\n0\nLINE\n8\n1\n10\n20\n20\n20\n11\n20\n21\n70\n0\nENDSEC\n0\nEOF\n";

TEST(PatternCommand, LayersAreListedAndToldOtherwise) {
  const fs::path folder = fresh_folder("toile_pattern");
  const fs::path file = folder / "odd.dxf";
  write_text(file, kOdd);
  const Ran none = run_toile({"pattern", "import", file});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(none.err.starts_with("toile: dxf.open_outline: ")) << none.err;
  EXPECT_TRUE(has(none.err, "toile pattern layers " + file.string() + " lists")) << none.err;
  EXPECT_TRUE(has(none.err, "--layer NAME=cut")) << none.err;
  const Ran listed = run_toile({"pattern", "layers", file});
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_EQ(listed.out, "layer 1: 1 LINE, read as cut\nlayer 5: 1 LWPOLYLINE, read as grade\n");
  const Ran told =
      run_toile({"pattern", "import", "--layer", "5=cut", "--layer", "1=grain", "--unit", "mm", file});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(has(told.out, "300.0 x 300.0 mm")) << told.out;
  EXPECT_TRUE(has(told.out, "grain 90.0 deg")) << told.out;
  EXPECT_TRUE(has(told.out, "layer 5: 1 LWPOLYLINE, read as cut (as told)")) << told.out;
  const auto tree = json::parse_json(
      run_toile({"pattern", "import", file, "--layer", "5=cut", "--json", "--no-seams"}).out);
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->find("layers")->array()->size(), 2u);
  EXPECT_EQ(*tree->find("layers")->array()->back().find("read_as")->text(), "cut");
  fs::remove_all(folder);
}

TEST(PatternCommand, LayersThatAreToldWronglyAreRefused) {
  const fs::path folder = fresh_folder("toile_pattern");
  const fs::path file = folder / "odd.dxf";
  write_text(file, kOdd);
  const auto refused = [&](const char* layer) {
    return run_toile({"pattern", "layers", file, "--layer", layer});
  };
  for (const auto& [layer, start] :
       std::vector<std::pair<const char*, const char*>>{{"5", "toile: pattern.layer: "},
                                                        {"5=cutt", "toile: dxf.unknown_role: "},
                                                        {"6=cut", "toile: dxf.unknown_layer: "}}) {
    EXPECT_EQ(refused(layer).code, 2) << layer;
    EXPECT_TRUE(refused(layer).err.starts_with(start)) << refused(layer).err;
  }
  EXPECT_TRUE(has(refused("5=cutt").err, "(--layer 5=cutt)")) << refused("5=cutt").err;
  write_text(folder / "two.json", "{\"pattern\": {}}");
  EXPECT_TRUE(
      run_toile({"pattern", "layers", folder / "two.json"}).err.starts_with("toile: pattern.no_layers: "));
  fs::remove_all(folder);
}

TEST(PatternCommand, AProjectKeepsTheLayersThatItWasToldForTheNextReading) {
  const fs::path folder = fresh_folder("toile_pattern");
  write_text(folder / "odd.dxf", kOdd);
  write_text(folder / "post.obj", kPost);
  const Ran made =
      run_toile({"project", "new", "--pattern", folder / "odd.dxf", "--body", folder / "post.obj", "--layer",
                 "5=cut", "--layer", "1=grain", "--out", folder / "out" / "project.json"});
  ASSERT_EQ(made.code, 0) << made.err;
  const Ran out =
      run_toile({"pattern", "export", folder / "out" / "project.json", "--out", folder / "again.dxf"});
  EXPECT_EQ(out.code, 0) << out.err;
  EXPECT_TRUE(has(run_toile({"pattern", "import", folder / "again.dxf"}).out, "300.0 x 300.0 mm"));
  fs::remove_all(folder);
}

TEST(PatternCommand, ImportRefusesWhatIsNoFile) {
  EXPECT_TRUE(run_toile({"pattern", "import", "/nowhere/a.dxf"}).err.starts_with("toile: pattern.file: "));
  EXPECT_TRUE(run_toile({"pattern", "import", "/tmp"}).err.starts_with("toile: pattern.file: "));
  const Ran run = run_toile({"pattern", "import", "/dev/null", "--json"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(run.err.starts_with("{\"error\": {\"code\": \"pattern.file\"")) << run.err;
  EXPECT_EQ(run_toile({"pattern"}).code, 2);
  EXPECT_EQ(run_toile({"pattern", "import", "a.dxf", "--unit", "ell"}).code, 2);
}

TEST(PatternCommand, WhatIsExportedReadsBackAsItWas) {
  const fs::path folder =
      napkin_folder("toile_pattern_export", "\"fabric\": \"cotton\"", "\"fabric\": \"cotton\"");
  const Ran run = run_toile({"pattern", "export", folder / "project.json", "--out", folder / "x.dxf"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Ran back = run_toile({"pattern", "import", folder / "x.dxf"});
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_TRUE(has(back.out, "piece napkin: 300.0 x 300.0 mm, 900.0 cm2, 4 edges")) << back.out;
  EXPECT_TRUE(has(back.out, "unit mm")) << back.out;
  fs::remove_all(folder);
}

const char* const kSpecification = R"({"pattern": {"panels": {
    "front": {"translation": [0, 100, 20], "rotation": [0, 0, 0],
      "vertices": [[0, 0], [40, 0], [40, 60], [0, 60]],
      "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]},
    "back": {"translation": [0, 100, -20], "rotation": [0, 0, 0],
      "vertices": [[0, 0], [0, 60], [40, 60], [40, 0]],
      "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
    "stitches": [[{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],
                 [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}]]}})";

TEST(PatternCommand, APatternIsPrintedAsItsFileIsNamed) {
  const fs::path folder = fresh_folder("toile_pattern_print");
  const std::string project = std::string(TOILE_SOURCE_DIR) + "/samples/skirt/project.json";
  ASSERT_EQ(run_toile({"pattern", "export", project, "--out", folder / "a.pdf", "--paper", "a3"}).code, 0);
  EXPECT_TRUE(text_of(folder / "a.pdf").starts_with("%PDF-"));
  ASSERT_EQ(run_toile({"pattern", "export", project, "--out", folder / "a.SVG"}).code, 0);
  EXPECT_NE(text_of(folder / "a.SVG").find("<svg"), std::string::npos);
  EXPECT_EQ(run_toile({"pattern", "export", project, "--out", folder / "b.pdf", "--paper", "a9"}).code, 2);
  fs::remove_all(folder);
}

TEST(PatternCommand, ImportReadsASpecificationWithItsSeams) {
  const fs::path folder = fresh_folder("toile_specification");
  write_text(folder / "tube.json", kSpecification);
  const Ran run = run_toile({"pattern", "import", folder / "tube.json", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto tree = json::parse_json(run.out);
  ASSERT_TRUE(tree) << run.out;
  EXPECT_EQ(tree->find("pieces")->array()->size(), 2u);
  ASSERT_EQ(tree->find("seams")->array()->size(), 2u);
  const json::JsonValue& seam = tree->find("seams")->array()->front();
  EXPECT_EQ(*seam.find("confidence")->number(), 1);
  EXPECT_EQ(*seam.find("a")->array()->front().find("piece")->text(), "front");
  EXPECT_EQ(*seam.find("length_a_mm")->number(), 600);
  fs::remove_all(folder);
}

TEST(ProjectCommand, NewMakesAProjectThatChecks) {
  const fs::path folder = napkin_folder("toile_project_new");
  write_text(folder / "tube.json", kSpecification);
  const fs::path out = folder / "made" / "project.json";
  const Ran run = run_toile(
      {"project", "new", "--pattern", folder / "tube.json", "--body", folder / "post.obj", "--out", out});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(run.out, "2 pieces, 2 seams")) << run.out;
  EXPECT_TRUE(fs::exists(folder / "made" / "post.obj")) << "the document names files beside itself";
  const Ran check = run_toile({"check", out});
  EXPECT_TRUE(has(check.out, "piece front")) << check.out << check.err;
  fs::remove_all(folder);
}

TEST(ProjectCommand, NewReplacesItsFilesWithoutTouchingWhatOthersRead) {
  const fs::path folder = napkin_folder("toile_project_new_twice");
  write_text(folder / "tube.json", kSpecification);
  const fs::path out = folder / "made" / "project.json";
  const std::vector<std::string> words{
      "project", "new", "--pattern", folder / "tube.json", "--body", folder / "post.obj", "--out", out};
  ASSERT_EQ(run_toile(words).code, 0);
  std::ifstream reader(folder / "made" / "post.obj");  // another command, in the middle of its reading
  write_text(folder / "post.obj", "# anew\n" + std::string(kPost));
  ASSERT_EQ(run_toile(words).code, 0);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), kPost);
  EXPECT_EQ(text_of(folder / "made" / "post.obj"), "# anew\n" + std::string(kPost));
  fs::remove_all(folder);
}

TEST(ProjectCommand, NewArrangesADrawingThatItSews) {
  const fs::path folder = fresh_folder("toile_project_arranged");
  const fs::path sample = fs::path(TOILE_SOURCE_DIR) / "samples/skirt";
  const auto made_with = [&](const std::string& body, const std::string& name,
                             const std::vector<std::string>& more) {
    std::vector<std::string> words{"project", "new", "--pattern", sample / "skirt.dxf",
                                   "--body",  body,  "--out",     folder / name,
                                   "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Ran run = run_toile(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return std::pair{run, project::parse_project(text_of(folder / name)).value()};
  };
  const auto [run, sewn] = made_with(sample / "body.obj", "sewn.json", {});
  const auto [plain_run, plain] = made_with(sample / "body.obj", "plain.json", {"--no-seams"});
  EXPECT_FALSE(sewn.seams.empty());
  EXPECT_FALSE(sewn.attachments.empty()) << "a skirt is held at its waist";
  EXPECT_TRUE(plain.attachments.empty()) << "nothing tells where pieces go that are not sewn";
  EXPECT_FALSE(has(run.out, "stand in rows")) << run.out;
  EXPECT_EQ(run_toile({"check", folder / "sewn.json"}).code, 0);
  const fs::path post = napkin_folder("toile_project_rows") / "post.obj";
  const auto [rows_run, rows] = made_with(post, "rows.json", {});
  EXPECT_TRUE(has(rows_run.out, "the pieces stand in rows")) << rows_run.out;
  EXPECT_EQ(rows.seams.size(), sewn.seams.size());
  EXPECT_TRUE(rows.attachments.empty());
  fs::remove_all(post.parent_path());
  fs::remove_all(folder);
}

/// The sample's body, every vertex turned by `turn`.
std::string turned_body(const std::function<Vec3(Vec3)>& turn) {
  std::istringstream in(text_of(fs::path(TOILE_SOURCE_DIR) / "samples/skirt/body.obj"));
  std::ostringstream out;
  for (std::string line; std::getline(in, line);) {
    Vec3 p;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p.x, &p.y, &p.z) == 3) {
      p = turn(p);
      out << "v " << p.x << " " << p.y << " " << p.z << "\n";
    } else {
      out << line << "\n";
    }
  }
  return out.str();
}

TEST(ProjectCommand, NewSetsTheBodyUprightAndToTheFront) {
  const fs::path folder = fresh_folder("toile_project_turned");
  const fs::path sample = fs::path(TOILE_SOURCE_DIR) / "samples/skirt";
  const auto told = [&](const std::string& name, const std::function<Vec3(Vec3)>& turn) {
    write_text(folder / (name + ".obj"), turned_body(turn));
    const Ran run =
        run_toile({"project", "new", "--pattern", sample / "skirt.dxf", "--body", folder / (name + ".obj"),
                   "--out", folder / "made" / (name + ".json"), "--no-seams"});
    EXPECT_EQ(run.code, 0) << run.err;
    return std::pair{run.out, project::parse_project(text_of(folder / "made" / (name + ".json"))).value()};
  };
  const auto [plain_out, plain] = told("plain", [](Vec3 p) { return p; });
  const auto [back_out, back] = told("back", [](Vec3 p) { return Vec3{-p.x, p.y, -p.z}; });
  const auto [lying_out, lying] = told("lying", [](Vec3 p) { return Vec3{p.x, -p.z, p.y - 0.5} * 100; });
  EXPECT_FALSE(has(plain_out, "was turned")) << plain_out;
  EXPECT_EQ(plain.bodies[0].rotation, Vec3{});
  EXPECT_TRUE(has(back_out, "note: the body was turned: it looked to the back")) << back_out;
  EXPECT_EQ(back.bodies[0].rotation, (Vec3{0, 180, 0}));
  EXPECT_TRUE(has(lying_out, "z is up in its file")) << lying_out;
  EXPECT_EQ(lying.bodies[0].up, "z");
  EXPECT_EQ(lying.bodies[0].unit, "cm");
  EXPECT_NEAR(lying.bodies[0].translation.y, 0.5, 1e-3) << "its feet are on the floor";
  for (const project::Project* other : {&back, &lying}) {
    ASSERT_EQ(other->pieces.size(), plain.pieces.size());
    EXPECT_NEAR(other->pieces[0].placement.rigid->translation.z,
                plain.pieces[0].placement.rigid->translation.z, 1e-3);
  }
  fs::remove_all(folder);
}

TEST(ProjectCommand, NewTakesTheProposalsOfADrawingThatAreSure) {
  const fs::path folder = napkin_folder("toile_project_dxf");
  write_text(folder / "graded.dxf", kGraded);
  const fs::path out = folder / "project.json";
  const Ran run = run_toile({"project", "new", "--pattern", folder / "graded.dxf", "--body",
                             folder / "post.obj", "--out", out, "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto tree = json::parse_json(run.out);
  ASSERT_TRUE(tree) << run.out;
  EXPECT_EQ(*tree->find("pieces")->number(), 1);
  EXPECT_NE(tree->find("proposals"), nullptr);
  EXPECT_EQ(run_toile({"project", "new", "--pattern", "/nowhere/a.dxf", "--body", folder / "post.obj",
                       "--out", out})
                .code,
            2);
  EXPECT_EQ(run_toile({"project", "new", "--pattern", "a.dxf"}).code, 2);
  fs::remove_all(folder);
}

/// What is said of a file that stands where another is wanted, once it is refused as wrong arguments.
std::string refusal_of(const std::vector<std::string>& words) {
  const Ran run = run_toile(words);
  EXPECT_EQ(run.code, 2) << run.out;
  EXPECT_TRUE(run.err.starts_with("toile: usage.arguments: ")) << run.err;
  return run.err;
}

TEST(ProjectCommand, SaysWhichFileIsWantedInPlaceOfAnother) {
  for (const char* verb : {"drape", "check", "submit", "sweep"})
    EXPECT_TRUE(has(refusal_of({verb, "shirt.dxf"}), "this takes a project; toile project new")) << verb;
  EXPECT_TRUE(has(refusal_of({"drape", "body.obj"}), "is a mesh"));
  EXPECT_TRUE(has(refusal_of({"drape", "shirt.pdf"}), "is a picture"));
  const auto made_of = [](const std::string& pattern, const std::string& body) {
    return refusal_of({"project", "new", "--pattern", pattern, "--body", body, "--out", "p.json"});
  };
  EXPECT_TRUE(has(made_of("shirt.svg", "body.obj"), "patterns are read from DXF"));
  EXPECT_TRUE(has(made_of("body.obj", "shirt.dxf"), "--pattern: \"body.obj\" is a mesh"));
  EXPECT_TRUE(has(made_of("shirt.dxf", "other.dxf"), "--body: \"other.dxf\" is a pattern"));
  EXPECT_TRUE(has(made_of("shirt.dxf", "eu38"), "toile body make --preset eu38 --out eu38.obj"));
}

}  // namespace
}  // namespace toile
