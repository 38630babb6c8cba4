#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/json/tree.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/core/image/pictures.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CommandLine, HelpsEverywhereWithExamples) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"drape", "--help"}, {"check", "--help"}, {"body", "-h"}}) {
    const Ran run = run_toile(arguments);
    EXPECT_EQ(run.code, 0);
    EXPECT_TRUE(has(run.out, "Examples:\n  toile ")) << run.out;
    EXPECT_TRUE(has(run.out, "Exit codes: 0")) << run.out;
    EXPECT_EQ(run.err, "");
  }
}

TEST(CommandLine, SaysItsVersion) {
  const Ran run = run_toile({"--version"});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(run.out.starts_with("toile ")) << run.out;
  EXPECT_TRUE(has(text_of(std::string(TOILE_SOURCE_DIR) + "/CMakeLists.txt"),
                  "VERSION " + run.out.substr(6, run.out.size() - 7)))
      << run.out;
}

TEST(CommandLine, RefusesWrongArguments) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"fly"},
                                                    {"drape"},
                                                    {"drape", "project.json"},
                                                    {"check", "a", "b"},
                                                    {"drape", "p", "--out", "o", "--size", "12x"},
                                                    {"drape", "p", "--out", "o", "--size", "5000x100"},
                                                    {"drape", "p", "--out", "o", "--trace-every", "2"},
                                                    {"body", "--out", "b.obj", "--height", "tall"}}) {
    const Ran run = run_toile(arguments);
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_TRUE(run.err.starts_with("toile: usage.arguments: ")) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST(CommandLine, NamesTheOptionThatIsMeant) {
  const Ran drape = run_toile({"drape", "p.json", "--otu", "x"});
  EXPECT_EQ(drape.code, 2);
  EXPECT_TRUE(has(drape.err, "there is no option \"--otu\"; did you mean \"--out\"?")) << drape.err;
  const Ran layer = run_toile({"pattern", "import", "a.dxf", "--lyer=3=sew"});
  EXPECT_TRUE(has(layer.err, "there is no option \"--lyer\"; did you mean \"--layer\"?")) << layer.err;
  const Ran far = run_toile({"check", "p.json", "--colour"});
  EXPECT_TRUE(has(far.err, "there is no option \"--colour\"; see toile check --help")) << far.err;
}

TEST(CommandLine, WritesMannequinsAsObjAlone) {
  const fs::path folder = fresh_folder("toile_body_format");
  const Ran run = run_toile({"body", "make", "--out", folder / "body.stl"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(has(run.err, "export.format: a mannequin is written as OBJ")) << run.err;
  EXPECT_TRUE(fs::is_empty(folder));
  fs::remove_all(folder);
}

TEST(CommandLine, CheckSaysWhatAProjectHolds) {
  const fs::path folder = napkin_folder("toile_check");
  const Ran run = run_toile({"check", folder / "project.json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(run.out, "piece napkin: 300.0 x 300.0 mm, 900 cm2, cotton")) << run.out;
  EXPECT_TRUE(has(run.out, "east 300.0")) << run.out;
  EXPECT_TRUE(has(run.out, "body post: 12 triangles, 0.50 m high")) << run.out;
  fs::remove_all(folder);
}

TEST(CommandLine, CheckGivesBothLengthsOfASeam) {
  const fs::path folder =
      napkin_folder("toile_check", "\"seams\": []",
                    R"("seams": [{"id": "tube", "a": [{"piece": "napkin", "edge": "east"}],
                                           "b": [{"piece": "napkin", "edge": "north"},
                                                 {"piece": "napkin", "edge": "west"}]}])");
  const Ran human = run_toile({"check", folder / "project.json"});
  EXPECT_TRUE(has(human.out, "seam tube: 300.0 mm to 600.0 mm, 300.0 mm eased in")) << human.out << human.err;
  const Ran machine = run_toile({"check", folder / "project.json", "--json"});
  const auto tree = json::parse_json(machine.out);
  ASSERT_TRUE(tree) << machine.out;
  const json::JsonValue& seam = tree->find("seams")->array()->front();
  EXPECT_EQ(*seam.find("length_a_mm")->number(), 300);
  EXPECT_EQ(*seam.find("length_b_mm")->number(), 600);
  fs::remove_all(folder);
}

TEST(CommandLine, CheckTellsWhatIsWrongWithAStartAndRefusesIt) {
  const fs::path folder = napkin_folder("toile_check", "[-0.15, 0.52, 0.15]", "[-0.15, 0.3, 0.15]");
  const Ran human = run_toile({"check", folder / "project.json"});
  EXPECT_EQ(human.code, 2);
  EXPECT_TRUE(has(human.out, "error start.crosses_body: the piece passes through body post")) << human.out;
  EXPECT_TRUE(has(human.err, "move it clear of it (piece napkin at (")) << human.err;
  const Ran machine = run_toile({"check", folder / "project.json", "--json"});
  EXPECT_EQ(machine.code, 2);
  const auto tree = json::parse_json(machine.out);
  ASSERT_TRUE(tree) << machine.out;
  const json::JsonValue& finding = tree->find("findings")->array()->front();
  EXPECT_EQ(*finding.find("code")->text(), "start.crosses_body");
  EXPECT_EQ(*finding.find("severity")->text(), "error");
  EXPECT_EQ(finding.find("place")->array()->size(), 3u);
  const Ran drape = run_toile({"drape", folder / "project.json", "--out", folder / "out"});
  EXPECT_EQ(drape.code, 2);
  EXPECT_EQ(drape.err, human.err) << "a drape refuses in the same words";
  fs::remove_all(folder);
}

TEST(CommandLine, CheckTellsWhatADrapeRepairsByItself) {
  const fs::path folder = napkin_folder("toile_check", "[-0.15, 0.52, 0.15]", "[-0.15, 0.5, 0.15]");
  const Ran check = run_toile({"check", folder / "project.json"});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_TRUE(has(check.out, "repaired start.touches: the piece touches body post")) << check.out;
  const Ran drape =
      run_toile({"drape", folder / "project.json", "--out", folder / "out", "--no-stills", "--json"}, 120);
  EXPECT_EQ(drape.code, 0) << drape.err;
  const auto report = json::parse_json(drape.out);
  ASSERT_TRUE(report) << drape.out;
  const json::JsonValue& finding = report->find("findings")->array()->front();
  EXPECT_EQ(*finding.find("code")->text(), "start.touches");
  EXPECT_TRUE(*finding.find("repaired")->boolean());
  fs::remove_all(folder);
}

constexpr const char* kChecked =
    R"("texture": {"image": "cloth/checks.png", "scale_mm": 40}, "fabric": "cotton",)";

TEST(CommandLine, ADrapeShowsThePictureThatLiesBesideTheProject) {
  const fs::path folder = napkin_folder("toile_textured", R"("fabric": "cotton",)", kChecked);
  fs::create_directories(folder / "cloth");
  const std::string png = test::png_of(test::squares());
  write_text(folder / "cloth" / "checks.png", png);
  const Ran run = run_toile({"drape", folder / "project.json", "--out", folder / "out", "--no-stills"}, 120);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(text_of(folder / "out" / "final.glb"), png)) << "the model carries it";
  fs::remove_all(folder);
}

TEST(CommandLine, APictureThatIsMissingOrBrokenIsToldBeforeTheDrape) {
  const fs::path folder = napkin_folder("toile_textured", R"("fabric": "cotton",)", kChecked);
  for (const char* verb : {"check", "drape"}) {
    std::vector<std::string> arguments{verb, folder / "project.json"};
    if (verb == std::string("drape")) arguments.insert(arguments.end(), {"--out", folder / "out"});
    fs::remove_all(folder / "cloth");
    const Ran missing = run_toile(arguments);
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(has(missing.err, "project.file: ")) << missing.err;
    EXPECT_TRUE(has(missing.err, "/pieces/0/texture/image")) << missing.err;
    fs::create_directories(folder / "cloth");
    write_text(folder / "cloth" / "checks.png", "GIF89a");
    const Ran broken = run_toile(arguments);
    EXPECT_EQ(broken.code, 2);
    EXPECT_TRUE(has(broken.err, "image.format: ")) << broken.err;
  }
  EXPECT_FALSE(fs::exists(folder / "out"));
  fs::remove_all(folder);
}

TEST(CommandLine, BodyWritesAMannequin) {
  const fs::path folder = fresh_folder("toile_body");
  const Ran run = run_toile({"body", "make", "--out", folder / "tall.obj", "--height", "182", "--hip", "102",
                             "--triangles", "2000"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(run.out, "2000 triangles")) << run.out;
  const std::string obj = text_of(folder / "tall.obj");
  EXPECT_TRUE(has(obj, "v ")) << obj.substr(0, 200);
  EXPECT_TRUE(has(obj, "\nf ")) << obj.substr(0, 200);
  fs::remove_all(folder);
}

TEST(CommandLine, BodyMeasuresWhatItMadeAndSaysWhatWasAsked) {
  const fs::path folder = fresh_folder("toile_body_measure");
  const Ran made = run_toile({"body", "make", "--preset", "eu40", "--bust", "93", "--out", folder / "b.obj",
                              "--triangles", "3304", "--json"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(has(made.out, "\"asked_cm\": 93")) << made.out;
  EXPECT_TRUE(has(made.out, "\"inseam\"")) << made.out;
  const Ran measured = run_toile({"body", "measure", folder / "b.obj", "--json"});
  EXPECT_EQ(measured.code, 0) << measured.err;
  EXPECT_TRUE(has(measured.out, "\"underbust\"")) << measured.out;
  EXPECT_TRUE(has(measured.out, "\"unit_in_m\": 1")) << measured.out;
  fs::remove_all(folder);
}

TEST(CommandLine, BodyListsItsSizes) {
  const Ran run = run_toile({"body", "presets"});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* name : {"eu34", "eu48", "m44", "m58", "child116"}) EXPECT_TRUE(has(run.out, name)) << name;
  EXPECT_EQ(run_toile({"body", "make", "--preset", "xxl", "--out", "/tmp/never.obj"}).code, 2);
}

TEST(CommandLine, CheckTellsHowFineAMeshTheFabricWantsAndWhatItCosts) {
  const fs::path folder = napkin_folder("toile_finer");
  const Ran human = run_toile({"check", folder / "project.json"});
  EXPECT_TRUE(has(human.out, "mesh: triangles of ")) << human.out;
  const Ran machine = run_toile({"check", folder / "project.json", "--json"});
  const Result<json::JsonValue> told = json::parse_json(machine.out);
  ASSERT_TRUE(told);
  const json::JsonValue& mesh = *told->find("mesh");
  const double ratio = *mesh.find("particle_distance_mm")->number() / *mesh.find("fitting_mm")->number();
  EXPECT_GT(ratio, 1);
  EXPECT_NEAR(*mesh.find("times")->number(), ratio * ratio, 0.1 * ratio * ratio);
}

TEST(CommandLine, FabricsAreListedAndShownWithTheirSources) {
  const Ran list = run_toile({"fabric", "list"});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_TRUE(has(list.out, "\nsingle-jersey ")) << list.out;
  const Ran show = run_toile({"fabric", "show", "denim-10oz", "--json"});
  ASSERT_EQ(show.code, 0) << show.err;
  const Result<json::JsonValue> card = json::parse_json(show.out);
  ASSERT_TRUE(card);
  EXPECT_EQ(*card->find("areal_mass_g_m2")->number(), 339);
  EXPECT_NEAR(*card->find("derived")->find("bending_length_warp_mm")->number(), 31, 0.1);
  EXPECT_FALSE(card->find("sources")->array()->empty());
  const Ran unknown = run_toile({"fabric", "show", "denim-10os"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(has(unknown.err, "did you mean \"denim-10oz\"?")) << unknown.err;
}

TEST(CommandLine, AFabricIsTestedBesideWhatIsKnownOfIt) {
  const fs::path folder = fs::temp_directory_path() / "toile_fabric_test";
  fs::remove_all(folder);
  const Ran run = run_toile({"fabric", "test", "leather", "--drapes", "1", "--particle-distance", "20",
                             "--out", folder.string(), "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Result<json::JsonValue> trial = json::parse_json(run.out);
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->find("drape")->find("drapes")->array()->size(), 1u);
  EXPECT_GT(*trial->find("bending_length")->find("warp")->find("measured_mm")->number(), 20);
  EXPECT_NEAR(*trial->find("friction")->find("measured")->number(),
              *trial->find("friction")->find("known")->number(), 0.02);
  EXPECT_TRUE(text_of(folder / "leather.png").starts_with("\x89PNG")) << run.err;
  const std::string sheet = text_of(folder / "leather.svg");
  EXPECT_TRUE(sheet.starts_with("<svg ") && sheet.ends_with("</svg>\n"));
  EXPECT_TRUE(has(sheet, "Garment leather")) << sheet;
}

TEST(CommandLine, MissingFiguresOfAFabricAreFoundFromItsDrape) {
  const Ran run =
      run_toile({"fabric", "calibrate", "--mass", "0.3", "--drape", "0.85", "--kes-g", "2",
                 "--fast-e100-warp", "4", "--drapes", "1", "--particle-distance", "20", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Result<json::JsonValue> found = json::parse_json(run.out);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found->find("found")->text(), "bending");
  EXPECT_NEAR(*found->find("drape_percent")->number(), 85, 1);
  EXPECT_LE(*found->find("drapes")->number(), 20);
  EXPECT_FALSE(found->find("could_not_tell")->array()->empty());
  const Ran grams = run_toile({"fabric", "calibrate", "--mass", "300"});
  EXPECT_EQ(grams.code, 2);
  EXPECT_TRUE(has(grams.err, "look at its unit (mass)")) << grams.err;
}

TEST(CommandLine, AProjectMayAskForThePapersMethod) {
  const std::string settings = R"("settings": {)";
  const fs::path folder =
      napkin_folder("toile_by_paper", settings, settings + R"("solver": "paper", "paper": {"passes": 8}, )");
  const Ran run = run_toile({"drape", (folder / "project.json").string(), "--out", (folder / "out").string(),
                             "--no-stills", "--json"});
  EXPECT_TRUE(run.code == 0 || run.code == 3) << run.err;
  const Result<json::JsonValue> report = json::parse_json(run.out);
  ASSERT_TRUE(report) << run.out;
  EXPECT_LE(*report->find("steps")->number(), 4000) << "its steps are longer than our engine's";
  EXPECT_TRUE(report->find("intersections")->find("cloth_body")->number());
}

TEST(CommandLine, BodyRefusesMeasuresThatNobodyHas) {
  const Ran run = run_toile({"body", "make", "--out", "/tmp/never.obj", "--waist", "300"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(run.err.starts_with("toile: mannequin.")) << run.err;
}

/// One drape for the tests that look at what it leaves.
class Draped : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = napkin_folder("toile_draped");
    run = run_toile({"drape", folder / "project.json", "--out", folder / "out/deep", "--check-data", "--json",
                     "--size", "64x80", "--trace", folder / "frames.trace", "--trace-every", "5"},
                    300);
  }
  static void TearDownTestSuite() { fs::remove_all(folder); }

  static inline fs::path folder;
  static inline Ran run;
};

TEST_F(Draped, SettlesAndLeavesAllItsFiles) {
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "") << "a bar in a pipe?";
  for (const char* name :
       {"report.json", "final.obj", "final.glb", "front.png", "back.png", "side.png", "three-quarter.png",
        "report.html", "rest.obj", "body.obj", "sewn.json", "maps.json"}) {
    EXPECT_GT(text_of(folder / "out/deep" / name).size(), 1u) << name;
  }
  EXPECT_EQ(text_of(folder / "frames.trace").substr(0, 8), "TOILETRC");
}

TEST_F(Draped, IsGoneOnFromByAnother) {
  const fs::path before = folder / "out/deep", out = folder / "on";
  const Ran on = run_toile({"drape", folder / "project.json", "--out", out, "--no-stills", "--from", before});
  EXPECT_EQ(on.code, 0) << on.err;
  EXPECT_NE(text_of(out / "report.json").find("start.goes_on"), std::string::npos);
  const Ran again = run_toile(
      {"drape", folder / "project.json", "--out", out, "--no-stills", "--from", out / "report.json"});
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("hung.damaged"), std::string::npos) << again.err;
  const Ran none = run_toile({"drape", folder / "project.json", "--out", out, "--from", folder / "nowhere"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("usage.from"), std::string::npos) << none.err;
}

TEST_F(Draped, PrintsTheReportThatItWrites) { EXPECT_EQ(run.out, text_of(folder / "out/deep/report.json")); }

/// Checks a value against the few words of JSON Schema that report.schema.json uses.
void expect_fits(const json::JsonValue& value, const json::JsonValue& given, const json::JsonValue& root,
                 const std::string& at) {
  const json::JsonValue* reference = given.find("$ref");
  const json::JsonValue& schema = reference ? *root.find("$defs")->find(reference->text()->substr(8)) : given;
  const std::string& type = *schema.find("type")->text();
  const bool fits = (type == "object" && value.object()) || (type == "string" && value.text()) ||
                    (type == "array" && value.array()) || (type == "boolean" && value.boolean()) ||
                    ((type == "number" || type == "integer") && value.number());
  ASSERT_TRUE(fits) << at << " is no " << type;
  if (const json::JsonValue* least = schema.find("minimum")) {
    EXPECT_GE(*value.number(), *least->number()) << at;
  }
  if (type == "array") {
    for (const json::JsonValue& item : *value.array())
      expect_fits(item, *schema.find("items"), root, at + "/-");
  }
  const json::JsonValue* properties = schema.find("properties");
  if (!properties) return;
  for (const json::JsonValue& key : *schema.find("required")->array()) {
    EXPECT_TRUE(value.find(*key.text())) << at << " has no " << *key.text();
  }
  for (const json::JsonMember& member : *value.object()) {
    const json::JsonValue* known = properties->find(member.key);
    ASSERT_TRUE(known) << at << "/" << member.key << " is not in the schema";
    expect_fits(member.value, *known, root, at + "/" + member.key);
  }
}

TEST_F(Draped, TheReportFitsItsSchema) {
  const auto schema =
      json::parse_json(text_of(std::string(TOILE_SOURCE_DIR) + "/proto/schema/report.schema.json"));
  ASSERT_TRUE(schema) << to_string(schema.error());
  const auto report = json::parse_json(run.out);
  ASSERT_TRUE(report) << to_string(report.error());
  expect_fits(*report, *schema, *schema, "");
  EXPECT_TRUE(*report->find("settled")->boolean());
  EXPECT_EQ(report->find("hash")->text()->size(), 32u);
}

TEST_F(Draped, TwiceTheSameInputGivesTheSameHash) {
  const Ran again =
      run_toile({"drape", folder / "project.json", "--out", folder / "again", "--no-stills", "--json"}, 300);
  const auto first = json::parse_json(run.out), second = json::parse_json(again.out);
  ASSERT_TRUE(first);
  ASSERT_TRUE(second) << again.err;
  EXPECT_EQ(*first->find("hash")->text(), *second->find("hash")->text());
  EXPECT_FALSE(fs::exists(folder / "again/front.png"));
}

TEST(DrapeCommand, SaysByItsExitCodeThatTimeRanOut) {
  const fs::path folder = napkin_folder("toile_unsettled", "\"max_time_s\": 8", "\"max_time_s\": 0.02");
  const Ran run = run_toile({"drape", folder / "project.json", "--out", folder / "out", "--no-stills"}, 120);
  EXPECT_EQ(run.code, 3) << run.out << run.err;
  EXPECT_TRUE(has(run.out, "not settled")) << run.out;
  EXPECT_TRUE(fs::exists(folder / "out/report.json"));
  fs::remove_all(folder);
}

TEST(DrapeCommand, EndsInGoodOrderWhenInterrupted) {
  const fs::path folder = napkin_folder("toile_cancelled", "\"particle_distance_mm\": 25",
                                        "\"particle_distance_mm\": 4, \"settle_speed_mm_s\": 0.001");
  const fs::path trace = folder / "cloth.trace";
  const auto cloth_moves = [&trace] {
    std::error_code not_yet;
    const auto bytes = fs::file_size(trace, not_yet);
    return !not_yet && bytes > 0;
  };
  const Ran run =
      run_toile({"drape", folder / "project.json", "--out", folder / "out", "--no-stills", "--trace", trace},
                300, cloth_moves);
  EXPECT_EQ(run.signal, 0);
  EXPECT_EQ(run.code, 4) << run.out << run.err;
  EXPECT_TRUE(has(text_of(folder / "out/report.json"), "\"stop_reason\": \"cancelled\""));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace toile
