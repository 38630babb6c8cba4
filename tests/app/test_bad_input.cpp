// What strangers hand to the program: each ends with exit code 2, an error code and a place, and soon.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/app/junk.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class BadInput : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder); }

  /// The napkin with the first place of `from` in its document changed to `to`.
  void change(const std::string& from, const std::string& to) {
    folder = napkin_folder("toile_bad_input", from, to);
  }
  /// The napkin with its outline from cut.dxf.
  void cut_from(const std::string& dxf) {
    std::string text = kNapkin;
    const std::size_t begin = text.find("\"outline\""), end = text.find("\"fabric\"");
    text.replace(begin, end - begin, R"("from": {"dxf": "cut.dxf", "piece": "FRONT", "units": "mm"}, )");
    folder = fresh_folder("toile_bad_input");
    write_text(folder / "project.json", text);
    write_text(folder / "post.obj", kPost);
    write_text(folder / "cut.dxf", dxf);
  }

  Ran drape() const {
    return run_toile({"drape", folder / "project.json", "--out", folder / "out", "--no-stills"});
  }

  /// The program refuses the folder: "toile: <code>…: <message> (…<place>…)" on one line of stderr.
  void expect_refused(const std::string& code, const std::string& place) const {
    const Ran run = drape();
    EXPECT_EQ(run.signal, 0) << "crashed or hung: " << run.err.substr(0, 2000);
    EXPECT_EQ(run.code, 2) << run.err.substr(0, 2000);
    EXPECT_TRUE(run.err.starts_with("toile: " + code)) << run.err.substr(0, 2000);
    EXPECT_NE(run.err.find(place), std::string::npos) << run.err.substr(0, 2000);
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err.substr(0, 2000);
    EXPECT_EQ(run.out, "");
    EXPECT_LT(run.err.size(), 3000u);
  }

  fs::path folder;
};

TEST_F(BadInput, TheFixtureItselfIsGood) {
  cut_from(square_dxf());
  const Ran run = run_toile({"check", folder / "project.json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("piece napkin: 100.0 x 100.0 mm"), std::string::npos) << run.out;
}

TEST_F(BadInput, AFileThatIsNoDxf) {
  cut_from("Dear Sir or Madam,\nplease find attached my best regards.\n");
  expect_refused("dxf.", "/pieces/0/from/dxf: cut.dxf");
}

TEST_F(BadInput, ADxfFileCutOffInTheMiddle) {
  const std::string whole = square_dxf();
  cut_from(whole.substr(0, whole.size() / 2));
  expect_refused("dxf.truncated", "line");
}

TEST_F(BadInput, ADxfFileCutOffBeforeItsOutlineEnds) {
  const std::string whole = square_dxf();
  for (std::size_t length = 0; length < whole.find("0\nTEXT"); length += 9) {
    cut_from(whole.substr(0, length));
    expect_refused("dxf.", "cut.dxf");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, ADxfFileCutOffBehindItsOutline) {
  const std::string whole = square_dxf();  // the text that names the piece is lost, its outline is not
  for (std::size_t length = whole.find("0\nTEXT"); length < whole.find("\nFRONT\n0\nENDSEC"); length += 9) {
    cut_from(whole.substr(0, length));
    expect_refused("project.unknown_piece", "cut.dxf");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, AnOpenOutlineInADxfFile) {
  cut_from(square_dxf("10\n0\n20\n0\n10\n100\n20\n0\n10\n100\n20\n100\n10\n0\n20\n100\n", "0"));
  expect_refused("dxf.open_outline", "line");
}

TEST_F(BadInput, AnOpenOutlineInTheDocument) {
  change("[[0, 300], [0, 0]]", "[[0, 300], [0, 7]]");
  expect_refused("pattern.open_outline", "/pieces/0/outline");
}

TEST_F(BadInput, APieceOfZeroAreaInADxfFile) {
  cut_from(square_dxf("10\n0\n20\n0\n10\n100\n20\n0\n10\n200\n20\n0\n10\n100\n20\n0\n"));
  expect_refused("dxf.", "cut.dxf");
}

TEST_F(BadInput, APieceOfZeroAreaInTheDocument) {
  change(
      "[[300, 0], [300, 300]]},\n       {\"id\": \"north\", \"points\": [[300, 300], [0, 300]]},\n       "
      "{\"id\": \"west\", \"points\": [[0, 300], [0, 0]]}]",
      "[[300, 0], [0, 0]]}]");
  expect_refused("pattern.zero_area", "/pieces/0");
}

TEST_F(BadInput, ACrossingOutlineInADxfFile) {
  cut_from(square_dxf("10\n0\n20\n0\n10\n100\n20\n100\n10\n150\n20\n0\n10\n0\n20\n100\n"));
  expect_refused("dxf.self_crossing", "cut.dxf");
}

TEST_F(BadInput, ACrossingOutlineInTheDocument) {
  change("[[300, 300], [0, 300]]", "[[300, 300], [150, -100], [0, 300]]");
  expect_refused("pattern.self_crossing", "/pieces/0");
}

TEST_F(BadInput, ASeamToAPieceThatIsNotThere) {
  change("\"seams\": []", R"("seams": [{"id": "s", "a": [{"piece": "napkin", "edge": "east"}],
                             "b": [{"piece": "sleeve", "edge": "west"}]}])");
  expect_refused("project.unknown_piece", "/seams/0/b/0/piece");
}

TEST_F(BadInput, ASeamToAnEdgeThatIsNotThere) {
  change("\"seams\": []", R"("seams": [{"id": "s", "a": [{"piece": "napkin", "edge": "east"}],
                             "b": [{"piece": "napkin", "edge": "wset"}]}])");
  expect_refused("project.unknown_edge", "/seams/0/b/0/edge");
}

TEST_F(BadInput, ABodyFileThatIsEmpty) {
  change("", "");
  write_text(folder / "post.obj", "");
  expect_refused("mesh.empty", "/bodies/0/file");
}

TEST_F(BadInput, ABodyFileOfNaN) {
  change("", "");
  write_text(folder / "post.obj", "v nan nan nan\nv nan 1 0\nv 0 nan 1\nf 1 2 3\n");
  expect_refused("mesh.", "/bodies/0/file");
}

TEST_F(BadInput, ABodyFileWithOneNumberThatIsNone) {
  change("", "");
  std::string post = kPost;
  write_text(folder / "post.obj", post.replace(post.find("0.5"), 3, "inf"));
  expect_refused("mesh.", "/bodies/0/file");
}

TEST_F(BadInput, ABodyFileCutOffInTheMiddle) {
  change("", "");
  write_text(folder / "post.obj", std::string(kPost).substr(0, 60));
  expect_refused("mesh.", "/bodies/0/file");
}

TEST_F(BadInput, AFileThatIsNotThere) {
  change("post.obj", "pots.obj");
  expect_refused("", "/bodies/0/file");
  fs::remove_all(folder);
  cut_from("");
  fs::remove(folder / "cut.dxf");
  expect_refused("project.file", "/pieces/0/from/dxf");
}

TEST_F(BadInput, APathOutOfTheFolder) {
  change("post.obj", "../../../etc/passwd");
  expect_refused("project.path", "/bodies/0/file");
}

TEST_F(BadInput, FiftyMegabytesAsTheDocument) {
  for (const char* filling : {" ", "[", "{\"a\":", "1,", "x"}) {
    change("", "");
    write_text(folder / "project.json", repeated(filling, kFiftyMegabytes));
    expect_refused("json.too_large", "project.json");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, FourMegabytesOfNearlyADocument) {
  constexpr std::size_t kJustAllowed = (std::size_t{4} << 20) - 1000;
  change("[[300, 300], [0, 300]]", "[" + repeated("[300, 300], ", kJustAllowed - 3000) + "[0, 300]]");
  expect_refused("project.out_of_range", "/pieces/0/outline/2/points");
  fs::remove_all(folder);
  change("\"toile\": 1", "\"toile\": 1, \"x\": [" + repeated("[],", kJustAllowed - 3000) + "[]]");
  expect_refused("project.unknown_key", "/x");
}

TEST_F(BadInput, FiftyMegabytesAsADxfFile) {
  const std::string head = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nFRONT\n70\n1\n";
  for (const std::string& dxf :
       {repeated("x", kFiftyMegabytes), repeated(std::string(1, '\0'), kFiftyMegabytes),
        repeated("0\nLINE\n", kFiftyMegabytes), repeated("\n", kFiftyMegabytes),
        head + repeated("10\n1.5\n20\n2.5\n", kFiftyMegabytes), repeated("0\nSECTION\n", kFiftyMegabytes)}) {
    cut_from(dxf);
    expect_refused("dxf.", "cut.dxf");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, FiftyMegabytesAsABody) {
  for (const std::string& obj :
       {repeated("x", kFiftyMegabytes), repeated(std::string(1, '\0'), kFiftyMegabytes),
        repeated("\n", kFiftyMegabytes), repeated("v 0 0 0\n", kFiftyMegabytes),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + repeated("f 1 2 3\n", kFiftyMegabytes)}) {
    change("", "");
    write_text(folder / "post.obj", obj);
    expect_refused("project.too_large", "/bodies/0/file");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, TwentyMegabytesOfNoBodyAtAll) {
  constexpr std::size_t kAllowedSize = 20'000'000;
  for (const std::string& obj : {repeated("x", kAllowedSize), repeated(std::string(1, '\0'), kAllowedSize),
                                 repeated("\n", kAllowedSize), repeated("v 0 0 0\n", kAllowedSize)}) {
    change("", "");
    write_text(folder / "post.obj", obj);
    expect_refused("mesh.", "/bodies/0/file");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, JsonNestedTenThousandDeep) {
  for (const char* level : {"[", "{\"a\":"}) {
    change("\"toile\": 1", "\"toile\": 1, \"x\": " + repeated(level, 10000 * std::string(level).size()));
    expect_refused("json.too_deep", "/x");
    fs::remove_all(folder);
  }
}

TEST_F(BadInput, AParticleDistanceThatWouldFillTheMemory) {
  change("\"particle_distance_mm\": 25", "\"particle_distance_mm\": 0.5");
  std::string text = text_of(folder / "project.json");
  for (std::size_t at = text.find("300"); at != std::string::npos; at = text.find("300", at + 5)) {
    text.replace(at, 3, "90000");
  }
  write_text(folder / "project.json", text);
  expect_refused("mesh.too_many_particles", "particle distance");
}

TEST_F(BadInput, AFolderForTheResultsThatCannotBeMade) {
  change("", "");
  const Ran run = run_toile({"drape", folder / "project.json", "--out", folder / "post.obj/out"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(run.err.starts_with("toile: usage.out")) << run.err;
}

TEST_F(BadInput, ErrorsComeAsJsonOnDemand) {
  change("\"seams\"", "\"saems\"");
  const Ran run = run_toile({"check", folder / "project.json", "--json"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(run.err.starts_with(R"({"error": {"code": "project.unknown_key", "message": ")")) << run.err;
  EXPECT_NE(run.err.find(R"(/saems"}})"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace toile
