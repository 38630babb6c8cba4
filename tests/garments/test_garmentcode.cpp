// Garments that others drew, on a body that others scanned. The data lie outside the project (TOILE_SHARED).

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/analysis/report.h"
#include "core/drape/pipeline.h"
#include "core/project/resolve/resolve.h"
#include "tests/garmentcode/to_project.h"

namespace toile {
namespace {

TEST(GarmentCode, TheTwoPanelSkirtComesToRestOnItsBody) {
  const char* shared = std::getenv("TOILE_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: NO REAL GARMENT WAS DRAPED";
  const std::filesystem::path folder =
      std::filesystem::path(TOILE_BINARY_DIR) / "garmentcode" / "skirt_2panel";
  const Status written =
      test::write_garmentcode_project(std::filesystem::path(shared) / "data", "skirt_2panel",
                                      "garmentcode-mean_all.obj", {"wb_"}, 20, folder);
  ASSERT_TRUE(written.ok()) << to_string(written.error());
  const auto read = resolve::read_project(folder / "project.json");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const drape::DrapeInput& input = read->input;
  const auto result = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const analysis::Report r = analysis::make_report(input, *result);
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  EXPECT_EQ(r.worst_frame.cloth_body + r.worst_frame.cloth_cloth, 0);
  EXPECT_LE(r.seam_gap_max_mm, 0.5);
  EXPECT_GT(r.highest_m, 1.0) << "the waistband stayed up";
}

}  // namespace
}  // namespace toile
