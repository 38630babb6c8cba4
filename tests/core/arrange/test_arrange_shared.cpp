// Garments that others drew, their places withheld, on a body that others scanned. The data lie outside the
// project (TOILE_SHARED).

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/arrange/arrange.h"
#include "core/body/mesh_import/load.h"
#include "core/drape/pipeline.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/project/resolve/resolve.h"
#include "tests/garmentcode/to_project.h"

namespace toile {
namespace {

/// The garment without its places, on garmentcode-mean_all.
drape::DrapeInput unplaced(const std::string& shared, const std::string& name) {
  const auto folder = std::filesystem::path(TOILE_BINARY_DIR) / "arranged" / name;
  const Status written = test::write_garmentcode_project(std::filesystem::path(shared) / "data", name,
                                                         "garmentcode-mean_all.obj", {}, 20, folder);
  EXPECT_TRUE(written.ok()) << to_string(written.error());
  drape::DrapeInput input = resolve::read_project(folder / "project.json").value().input;
  for (sewing::Placement& p : input.placements) p = sewing::RigidPlacement{};
  return input;
}

/// Gives the pieces their places; no finding may be an error, and no ring may go around nothing but a hood's.
void take_places(drape::DrapeInput& input, const std::string& name) {
  const mesh::PanelMeshes meshes =
      mesh::make_panel_meshes(input.pattern, input.settings.particle_distance, {}).value();
  const auto made = arrange::arrange({input.pattern, meshes, input.bodies});
  ASSERT_TRUE(made.ok()) << name << ": " << to_string(made.error());
  for (const preflight::Finding& f : made->findings) {
    EXPECT_NE(f.severity, preflight::Severity::kError)
        << name << ": " << preflight::code_of(f.kind) << " " << preflight::where_text(f) << ": " << f.message;
    EXPECT_FALSE(f.repaired) << name << ": " << preflight::code_of(f.kind) << " " << preflight::where_text(f);
    const bool open_hood = preflight::where_text(f).find("hood") != std::string::npos;
    EXPECT_TRUE(f.kind != preflight::FindingKind::kRingAroundNothing || open_hood)
        << name << ": " << preflight::where_text(f);
  }
  input.placements = made->placements;
  input.attachments = made->attachments;
}

const char* shared_folder() { return std::getenv("TOILE_SHARED"); }

TEST(ArrangeShared, SkirtAndTrousersStandClearWithTheirWaistsHeld) {
  if (shared_folder() == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: NO REAL GARMENT WAS ARRANGED";
  for (const char* name : {"skirt_2panel", "pants"}) {
    drape::DrapeInput input = unplaced(shared_folder(), name);
    take_places(input, name);
    EXPECT_EQ(input.attachments.size(), 2u) << name << ": both halves of the waistband";
  }
}

TEST(LongArrangeShared, TopsStandClearToo) {
  if (shared_folder() == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: NO REAL GARMENT WAS ARRANGED";
  for (const char* name : {"tshirt", "fitted_blouse_long", "hoody"}) {
    drape::DrapeInput input = unplaced(shared_folder(), name);
    take_places(input, name);
    EXPECT_TRUE(input.attachments.empty()) << name << ": shoulders carry it";
  }
}

TEST(LongArrangeShared, TheBlouseIsSewnAndComesToRestWhereItWasArranged) {
  if (shared_folder() == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: NO REAL GARMENT WAS DRAPED";
  for (const char* name : {"fitted_blouse_long", "pants"}) {
    drape::DrapeInput input = unplaced(shared_folder(), name);
    take_places(input, name);
    const auto result = drape::drape(input, {}, nullptr);
    ASSERT_TRUE(result.ok()) << name << ": " << to_string(result.error());
    EXPECT_TRUE(result->settled()) << name << ": " << drape::to_string(result->stop_reason);
    EXPECT_EQ(result->worst.cloth_body + result->worst.cloth_cloth, 0) << name;
    EXPECT_LE(result->seam_gap_max, 5e-4) << name;
  }
}

}  // namespace
}  // namespace toile
