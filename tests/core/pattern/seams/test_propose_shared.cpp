// Seams that are proposed for garments from outside whose true seams are known. They are no part of the
// project: TOILE_SHARED names the folder that holds data/garmentcode.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "core/pattern/garmentcode/read.h"
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

}  // namespace
}  // namespace toile
