// Starts that are broken on purpose: all found, none silent, those that can be repaired repaired.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/collision/crossings.h"
#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"
#include "tests/core/preflight/broken_starts.h"

namespace toile {
namespace {

std::string text_of(const preflight::Findings& findings) {
  std::string text;
  for (const preflight::Finding& f : findings) {
    text += std::string("  ") + preflight::name_of(f.severity) + " " +
            std::string(preflight::code_of(f.kind)) + (f.repaired ? " (repaired)" : "") + ": " + f.message +
            " [" + preflight::where_text(f) + " " + preflight::place_text(f.place) + "]\n";
  }
  return text;
}

int crossings_of(const drape::DrapeInput& input, const sewing::Assembly& assembly) {
  const sewing::GarmentMesh& g = assembly.garment;
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  std::size_t count = collision::self_crossings(surface, assembly.positions).size();
  for (const body::Body& body : input.bodies) {
    count += collision::body_crossings(surface, assembly.positions,
                                       collision::make_crossing_body(body.mesh.vertices, body.mesh.triangles))
                 .size();
  }
  return static_cast<int>(count);
}

TEST(BrokenStarts, AreAllFoundWithAPlaceAndWordsAndRepairedWhereExpected) {
  for (const test::BrokenStart& broken : test::broken_starts()) {
    SCOPED_TRACE(broken.name);
    const drape::DrapeInput input = broken.make();
    const auto start = drape::prepare_start(input, {});
    ASSERT_TRUE(start.ok()) << to_string(start.error());
    bool found = false, repaired = true;
    for (const preflight::Finding& f : start->findings) {
      EXPECT_FALSE(f.message.empty() || preflight::where_text(f).empty());
      EXPECT_TRUE(is_finite(f.place));
      EXPECT_LE(f.severity, preflight::traits_of(f.kind).gravest) << text_of(start->findings);
      EXPECT_LE(f.repaired, preflight::traits_of(f.kind).repairable) << text_of(start->findings);
      if (f.kind != broken.kind) continue;
      found = true;
      repaired &= f.repaired;
    }
    EXPECT_TRUE(found) << text_of(start->findings);
    EXPECT_EQ(found && repaired, broken.repaired) << text_of(start->findings);
    if (preflight::first_error(start->findings)) continue;
    EXPECT_EQ(crossings_of(input, start->assembly), 0) << text_of(start->findings);
  }
}

TEST(BrokenStarts, AreRepairedByHalfAtLeast) {
  const auto& all = test::broken_starts();
  const auto repaired = std::count_if(all.begin(), all.end(), [](const auto& b) { return b.repaired; });
  EXPECT_GE(all.size(), 20u);
  EXPECT_GE(2 * repaired, static_cast<std::ptrdiff_t>(all.size()));
}

TEST(BrokenStarts, SoundStartsHaveNoWarningAndStayAsPlaced) {
  for (const drape::DrapeInput& input : {test::tube(), test::tablecloth()}) {
    const auto start = drape::prepare_start(input, {}).value();
    for (const preflight::Finding& f : start.findings)
      EXPECT_EQ(f.severity, preflight::Severity::kNote) << text_of(start.findings);
    EXPECT_EQ(start.assembly.positions,
              sewing::assemble(start.meshes, input.placements, input.attachments)->positions);
  }
}

TEST(BrokenStarts, TheFirstErrorRefusesTheDrapeWithItsPlace) {
  for (const test::BrokenStart& broken : test::broken_starts()) {
    const drape::DrapeInput input = broken.make();
    const auto start = drape::prepare_start(input, {});
    const auto error = start.ok() ? preflight::first_error(start->findings) : std::nullopt;
    if (!error) continue;
    const auto run = drape::DrapeRun::start(input, {}, nullptr);
    ASSERT_FALSE(run.ok()) << broken.name;
    EXPECT_EQ(run.error().code, error->code);
    EXPECT_EQ(run.error().message, error->message);
    EXPECT_NE(run.error().where.find(") m"), std::string::npos) << run.error().where;
  }
}

TEST(LongBrokenStarts, DrapeWithoutACrossingOnceRepaired) {
  for (const test::BrokenStart& broken : test::broken_starts()) {
    if (!broken.repaired) continue;
    SCOPED_TRACE(broken.name);
    drape::DrapeInput input = broken.make();
    input.settings.max_time = 3;
    const auto result = drape::drape(input, {}, nullptr);
    ASSERT_TRUE(result.ok()) << to_string(result.error());
    EXPECT_EQ(result->worst.cloth_body + result->worst.cloth_cloth, 0);
    EXPECT_NE(result->stop_reason.kind, drape::Stop::kNotFinite);
    EXPECT_NE(result->stop_reason.kind, drape::Stop::kOpenSeam) << drape::to_string(result->stop_reason);
    EXPECT_GT(result->frames_checked, 20);
  }
}

}  // namespace
}  // namespace toile
