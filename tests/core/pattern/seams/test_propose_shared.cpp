// Seams that are proposed for garments from outside whose true seams are known. They are no part of the
// project: TOILE_SHARED names the folder that holds data/garmentcode.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/garmentcode/read.h"
#include "core/project/create/create.h"
#include "tests/core/pattern/seams/seam_score.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class LongProposeShared : public testing::Test {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("TOILE_SHARED");
    if (shared == nullptr)
      GTEST_SKIP() << "TOILE_SHARED is not set: no seams of outside garments were proposed";
    data_ = fs::path(shared) / "data" / "garmentcode";
    ASSERT_TRUE(fs::is_directory(data_)) << data_;
  }

  std::set<fs::path> files(const std::string& ending) const {
    std::set<fs::path> found;
    for (const auto& entry : fs::directory_iterator(data_))
      if (entry.path().string().ends_with(ending)) found.insert(entry.path());
    return found;
  }

  /// One row of the table, with what is wrong and missed.
  static test::SeamScore row(const std::string& name, const pattern::Pattern& pattern,
                             const seams::ProposalSettings& settings,
                             const std::vector<test::SewnPoints>& truth) {
    const test::SeamScore s = test::score_of(pattern, seams::propose_seams(pattern, settings), truth);
    std::printf("%-42s seams %2d proposed %2d right %2d wrong %2zu missed %2zu recall %.3f precision %.3f\n",
                name.c_str(), s.known, s.proposed, s.right, s.wrong.size(), s.missed.size(), s.recall(),
                s.precision());
    for (const std::string& seam : s.wrong) std::printf("  wrong  %s\n", seam.c_str());
    for (const std::string& seam : s.missed) std::printf("  missed %s\n", seam.c_str());
    return s;
  }

  static void expect_good(const test::SeamScore& sum) {
    std::printf("together: seams %d proposed %d recall %.3f precision %.3f\n", sum.known, sum.proposed,
                sum.recall(), sum.precision());
    EXPECT_GE(sum.precision(), 0.95);
    EXPECT_GE(sum.recall(), 0.85);
  }

  fs::path data_;
};

TEST_F(LongProposeShared, FindTheSeamsOfDrawingsWithoutTheirPlaces) {
  test::SeamScore sum;
  for (const fs::path& path : files(".dxf")) {
    const Result<test::TrueGarment> garment = test::read_true_garment(path);
    ASSERT_TRUE(garment.ok()) << path << ": " << to_string(garment.error());
    sum.add(row(path.filename(), garment->pattern, {false, garment->clockwise}, garment->truth));
  }
  ASSERT_GT(sum.known, 0);
  expect_good(sum);
}

TEST_F(LongProposeShared, FindTheSeamsOfSpecificationsWithoutTheirStitchesAndPlaces) {
  test::SeamScore sum;
  for (const fs::path& path : files("_specification.json")) {
    std::ifstream in(path, std::ios::binary);
    Result<garmentcode::GarmentCodeGarment> garment =
        garmentcode::read_garmentcode(std::string{std::istreambuf_iterator<char>(in), {}});
    ASSERT_TRUE(garment.ok()) << path << ": " << to_string(garment.error());
    pattern::Pattern& pattern = garment->pattern;
    std::vector<test::SewnPoints> truth;
    for (const pattern::Seam& seam : std::exchange(pattern.seams, {}))
      truth.push_back(test::points_of(pattern, seam));
    sum.add(row(path.filename(), pattern, {true, {}}, truth));
  }
  ASSERT_GT(sum.known, 0);
  expect_good(sum);
}

/// A design of another family, with its true seams: their edges as the drawing is read, "piece.edge" joined
/// by
/// +; derived from the pieces' names and shapes.
struct NamedGarment {
  std::string file;
  std::vector<std::pair<std::string, std::string>> seams;
};

const std::vector<NamedGarment>& freesewing() {
  static const std::vector<NamedGarment> garments{{"teagan-cisFemaleAdult34",
                                                   {{"back.e0", "front.e6"},
                                                    {"back.e6", "front.e0"},
                                                    {"back.e2", "front.e4"},
                                                    {"back.e4", "front.e2"},
                                                    {"sleeve.e1", "sleeve.e3"},
                                                    {"sleeve_mirrored.e1", "sleeve_mirrored.e3"},
                                                    {"back.e1+front.e5", "sleeve.e2"},
                                                    {"back.e5+front.e1", "sleeve_mirrored.e2"}}},
                                                  {"brian-cisMaleAdult38",
                                                   {{"back.e0", "front.e6"},
                                                    {"back.e6", "front.e0"},
                                                    {"back.e2", "front.e4"},
                                                    {"back.e4", "front.e2"},
                                                    {"sleeve.e0", "sleeve.e2"},
                                                    {"sleeve_mirrored.e0", "sleeve_mirrored.e2"},
                                                    {"back.e1+front.e5", "sleeve.e3"},
                                                    {"back.e5+front.e1", "sleeve_mirrored.e3"}}},
                                                  {"titan-cisMaleAdult38",
                                                   {{"back.e0", "front.e2"},
                                                    {"back_mirrored.e0", "front_mirrored.e2"},
                                                    {"back.e2", "front.e0"},
                                                    {"back_mirrored.e2", "front_mirrored.e0"},
                                                    {"front.e3", "front_mirrored.e3"},
                                                    {"back.e4", "back_mirrored.e4"}}},
                                                  {"penelope-cisFemaleAdult34",
                                                   {{"front.e0", "back_mirrored.e4"},
                                                    {"front.e14", "back.e4"},
                                                    {"back.e0", "back_mirrored.e0"},
                                                    {"front.e2", "front.e3"},
                                                    {"front.e5", "front.e6"},
                                                    {"front.e8", "front.e9"},
                                                    {"front.e11", "front.e12"},
                                                    {"back.e6", "back.e7"},
                                                    {"back.e9", "back.e10"},
                                                    {"back_mirrored.e6", "back_mirrored.e7"},
                                                    {"back_mirrored.e9", "back_mirrored.e10"}}}};
  return garments;
}

/// "piece.edge" of all edges of a side, in order of their names.
std::string name_of(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& side) {
  std::set<std::string> names;
  for (const pattern::SeamEdge& e : side)
    names.insert(pattern.panels[e.panel].id + "." + pattern::edges_of(pattern.panels[e.panel])[e.edge]->id);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "+") + name;
  return text;
}

TEST_F(LongProposeShared, FindTheSeamsOfDesignsOfAnotherFamily) {
  int known = 0, proposed = 0, right = 0;
  for (const NamedGarment& garment : freesewing()) {
    std::ifstream in(data_.parent_path() / "freesewing" / (garment.file + ".aama.dxf"), std::ios::binary);
    create::NewProjectSettings settings;
    settings.name = garment.file;
    const Result<create::NewProject> made =
        create::new_project(std::string{std::istreambuf_iterator<char>(in), {}}, settings);
    ASSERT_TRUE(made.ok()) << garment.file << ": " << to_string(made.error());
    std::set<std::pair<std::string, std::string>> truth;
    for (const auto& [a, b] : garment.seams) truth.insert(std::minmax(a, b));
    known += static_cast<int>(truth.size());
    for (const seams::SeamProposal& p : made->proposals) {
      if (p.confidence < 0.8) continue;
      const std::string a = name_of(made->pattern, p.seam.a), b = name_of(made->pattern, p.seam.b);
      const bool is_right = !p.seam.same_direction && truth.contains(std::minmax(a, b));
      ++proposed;
      right += is_right;
      if (!is_right) std::printf("  wrong  %s: %s to %s\n", garment.file.c_str(), a.c_str(), b.c_str());
    }
  }
  std::printf("other family: seams %d proposed %d right %d\n", known, proposed, right);
  EXPECT_GE(right, 0.95 * proposed);
  EXPECT_GE(right, 0.85 * known);
}

}  // namespace
}  // namespace toile
