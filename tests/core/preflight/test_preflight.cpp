// Single checks and what a repair may not do.

#include "core/base/aabb.h"
#include "core/preflight/preflight.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/drape/pipeline.h"
#include "core/preflight/check_sides.h"
#include "core/preflight/triangle_gap.h"
#include "tests/core/drape/garments.h"
#include "tests/core/preflight/broken_starts.h"

namespace toile {
namespace {

drape::DrapeInput broken(const std::string& name) {
  const auto& all = test::broken_starts();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& b) { return b.name == name; });
  EXPECT_NE(found, all.end()) << name;
  return found->make();
}

const preflight::Finding* find(const preflight::Findings& findings, preflight::FindingKind kind) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const preflight::Finding& f) { return f.kind == kind; });
  return found == findings.end() ? nullptr : &*found;
}

/// Of the piece's box.
Vec3 centre_of(const sewing::Assembly& assembly, Index piece) {
  const auto& first = assembly.garment.first_vertex;
  Aabb3 box;
  for (Index v = first[piece]; v < first[piece + 1]; ++v) box.add(assembly.positions[v]);
  return box.middle();
}

TEST(Preflight, OverlappingMirrorImagesPartAndStayMirrorImages) {
  const drape::DrapeInput input = broken("left and right overlap in one plane");
  const auto start = drape::prepare_start(input, {}).value();
  const Vec3 left = centre_of(start.assembly, 2), right = centre_of(start.assembly, 3);
  EXPECT_NEAR(left.x, -right.x, 1e-5);
  EXPECT_NEAR(left.y, right.y, 1e-9);
  EXPECT_NEAR(left.z, right.z, 1e-9);
  EXPECT_GT(right.x - left.x, 0.060 + 0.001) << "60 mm wide each, and a millimetre between them";
  EXPECT_LT(right.x - left.x, 0.060 + 0.020) << "no farther than needed";
}

TEST(Preflight, ARepairMovesPiecesAsAWholeAndOnlyThoseConcerned) {
  const drape::DrapeInput input = broken("front 1 cm into the body");
  const auto start = drape::prepare_start(input, {}).value();
  const auto placed = sewing::assemble(start.meshes, input.placements, input.attachments)->positions;
  const Vec3 shift = start.assembly.positions[0] - placed[0];
  EXPECT_GE(shift.z, 0.0109);
  EXPECT_LE(length(shift), 0.05);
  for (Index v = 0; v < start.assembly.garment.vertex_count(); ++v) {
    const Vec3 moved = start.assembly.positions[v] - placed[v];
    const Vec3 expected = start.assembly.garment.panel_of_vertex[v] == 0 ? shift : Vec3{};
    EXPECT_LT(length(moved - expected), 1e-9);
  }
}

TEST(Preflight, AReversedSeamIsSewnAsIfItHadBeenRight) {
  const auto start = drape::prepare_start(broken("both seams reversed"), {}).value();
  const auto right = drape::prepare_start(test::tube(), {}).value();
  EXPECT_EQ(start.assembly.garment.sewn, right.assembly.garment.sewn);
  EXPECT_EQ(start.assembly.garment.weld, right.assembly.garment.weld);
  const preflight::Finding* f = find(start.findings, preflight::FindingKind::kTwisted);
  ASSERT_NE(f, nullptr);
  EXPECT_NE(f->message.find(" of thread in all, and "), std::string::npos) << f->message;
}

TEST(Preflight, ATurnedPieceComesToStandAsItShould) {
  const auto start = drape::prepare_start(broken("back turned left to right"), {}).value();
  const auto right = drape::prepare_start(test::tube(), {}).value();
  for (std::size_t i = 0; i < right.assembly.positions.size(); ++i) {
    EXPECT_LT(length(start.assembly.positions[i] - right.assembly.positions[i]), 1e-6);
  }
}

TEST(Preflight, APieceThatStandsOnItsHeadIsToldToBeInsideOut) {
  drape::DrapeInput input = test::tube();
  input.pattern.panels = {test::rectangle("left", 60, 120), test::rectangle("right", 60, 120)};
  input.pattern.seams = {{"middle", {{0, 1, false}}, {{1, 3, false}}, false}};
  input.placements = {sewing::RigidPlacement{{-0.035, 0.1, 0.1}, {}, false},
                      sewing::RigidPlacement{{0.035, 0.22, 0.1}, {3.14159265358979, 0, 0}, false}};
  const auto start = drape::prepare_start(input, {}).value();
  const preflight::Finding* f = find(start.findings, preflight::FindingKind::kInsideOut);
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(preflight::where_text(*f), "piece right");
  EXPECT_EQ(f->severity, preflight::Severity::kWarning);
}

/// Before the column stands a case of two pieces, sewn all around; a third one hangs from nothing.
TEST(Preflight, WhatIsClosedAllAroundHasNoSideForTheBody) {
  drape::DrapeInput input = test::tube();
  input.pattern.panels = {test::rectangle("front", 60, 60), test::rectangle("back", 60, 60)};
  input.placements = {sewing::RigidPlacement{{0, 0.15, 0.13}, {}, false},
                      sewing::RigidPlacement{{0, 0.15, 0.1}, {0, 3.14159265358979, 0}, false}};
  input.attachments.clear();
  input.pattern.seams.clear();
  const auto sewn = [&](const char* id, Index a, Index b) {
    input.pattern.seams.push_back({id, {{0, a, false}}, {{1, b, false}}, false});
  };
  sewn("bottom", 0, 0);
  sewn("right", 1, 3);
  sewn("top", 2, 2);
  const auto has_inside_out = [&] {
    const auto start = drape::prepare_start(input, {}).value();
    return find(start.findings, preflight::FindingKind::kInsideOut) != nullptr;
  };
  EXPECT_TRUE(has_inside_out()) << "it is open on one side: a bag that is worn has an inside";
  sewn("left", 3, 1);
  EXPECT_FALSE(has_inside_out());
}

TEST(Preflight, ASeamThatMakesAMobiusStripIsToldByName) {
  drape::DrapeInput input = test::tube();
  input.pattern.seams[1].same_direction = false;
  const auto start = drape::prepare_start(input, {}).value();
  const preflight::Finding* f = find(start.findings, preflight::FindingKind::kOneSided);
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(preflight::where_text(*f), "seam right");
}

TEST(Preflight, TheTightRingIsGivenWithBothGirths) {
  const auto start = drape::prepare_start(broken("girth under the body's"), {}).value();
  const preflight::Finding* f = find(start.findings, preflight::FindingKind::kTightRing);
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->severity, preflight::Severity::kWarning);
  EXPECT_NE(f->message.find("the ring of 400 mm"), std::string::npos) << f->message;
  EXPECT_NE(f->message.find("girth of 437 mm"), std::string::npos) << f->message;  // 32·70 mm·sin(π/16)
}

TEST(Preflight, ThreadsThroughTheMiddleAreRefusedAndThoseOverAShoulderAreNot) {
  const auto through = drape::prepare_start(broken("threads through the body"), {}).value();
  // The strips are 20 mm wide: one step aside a thread grazes the upright edges of the column.
  const auto over = drape::prepare_start(broken("threads over a shoulder"), {}).value();
  EXPECT_EQ(find(through.findings, preflight::FindingKind::kThreadThroughBody)->severity,
            preflight::Severity::kError);
  EXPECT_EQ(find(over.findings, preflight::FindingKind::kThreadThroughBody)->severity,
            preflight::Severity::kNote);
}

TEST(Preflight, AHeapOfPiecesInOnePlaceIsRefusedAndNotShuffled) {
  drape::DrapeInput input = test::tube();
  for (int i = 0; i < 20; ++i) {
    input.pattern.panels.push_back(test::rectangle("heaped" + std::to_string(i), 200, 200));
    input.placements.push_back(sewing::RigidPlacement{{0, 0.1, 0.3}, {}, false});
    input.fabric_of_panel.push_back(0);
  }
  const auto start = drape::prepare_start(input, {}).value();
  ASSERT_TRUE(preflight::first_error(start.findings));
  EXPECT_EQ(preflight::first_error(start.findings)->code, "start.touches");
  EXPECT_EQ(start.assembly.positions,
            sewing::assemble(start.meshes, input.placements, input.attachments)->positions);
}

TEST(Preflight, ShortThreadsBesideAThickBodyAreNearNoLimb) {
  drape::DrapeInput input = test::tube();
  input.bodies = {test::column(0.12, 0, 0.3)};
  for (std::size_t p : {0, 1}) {  // two half shells around the column, a few millimetres apart at their sides
    sewing::WrappedPlacement shell;
    shell.radius = 0.13;
    shell.height = 0.15;
    shell.angle = p == 0 ? 0 : 3.14159265358979;
    input.placements[p] = shell;
    input.pattern.panels[p] = test::rectangle(p == 0 ? "front" : "back", 400, 120);
  }
  input.pattern.seams = {{"left", {{0, 3, false}}, {{1, 1, false}}, false},
                         {"right", {{0, 1, false}}, {{1, 3, false}}, false}};
  const auto start = drape::prepare_start(input, {}).value();
  EXPECT_TRUE(start.findings.empty())
      << preflight::code_of(start.findings.front().kind) << ": " << start.findings.front().message;
}

TEST(Preflight, ABackThatIsCutAsItIsWornWindsLikeTheFront) {
  drape::DrapeInput input = test::tube();
  std::get<sewing::RigidPlacement>(input.placements[1]).rotation = {0, 3.14159265358979, 0};
  input.pattern.seams = {{"left", {{0, 3, false}}, {{1, 1, false}}, false},
                         {"right", {{0, 1, false}}, {{1, 3, false}}, false}};
  const auto start = drape::prepare_start(input, {}).value();
  EXPECT_EQ(find(start.findings, preflight::FindingKind::kWindsOtherWay), nullptr);
}

TEST(Preflight, ThreadsBesideAThirdPieceDoNotMeetIt) {
  drape::DrapeInput input = broken("threads through a third piece");
  std::get<sewing::RigidPlacement>(input.placements[2]).translation.x = 0.4;
  EXPECT_EQ(
      find(drape::prepare_start(input, {}).value().findings, preflight::FindingKind::kThreadThroughCloth),
      nullptr);
}

TEST(Preflight, AThreadThroughAPiecesRimIsNotedAndThroughItsMiddleIsAWarning) {
  drape::DrapeInput input = broken("threads through a third piece");
  EXPECT_EQ(
      find(drape::prepare_start(input, {}).value().findings, preflight::FindingKind::kThreadThroughCloth)
          ->severity,
      preflight::Severity::kWarning);
  std::get<sewing::RigidPlacement>(input.placements[2]).translation.x = 0.158;  // 2 mm of it are in the way
  const auto start = drape::prepare_start(input, {}).value();
  const preflight::Finding* rim = find(start.findings, preflight::FindingKind::kThreadThroughCloth);
  ASSERT_NE(rim, nullptr);
  EXPECT_EQ(rim->severity, preflight::Severity::kNote) << rim->message;
}

TEST(Preflight, HemsAboutTheTwoLegsOfAPairAreRight) {
  drape::DrapeInput input = broken("both hems about one leg");
  for (const std::size_t p : {2, 3})
    std::get<sewing::RigidPlacement>(input.placements[p]).translation.x = -0.2;
  EXPECT_EQ(find(drape::prepare_start(input, {}).value().findings, preflight::FindingKind::kRingOnWrongLimb),
            nullptr);
  std::get<sewing::RigidPlacement>(input.placements[2]).translation.y = 0.5;
  std::get<sewing::RigidPlacement>(input.placements[3]).translation.y = 0.5;
  EXPECT_NE(find(drape::prepare_start(input, {}).value().findings, preflight::FindingKind::kRingOnWrongLimb),
            nullptr)
      << "one low and one high are no pair";
}

TEST(Preflight, ASeamThatRunsStraightOnIsNoOpenRing) {
  EXPECT_EQ(
      find(drape::prepare_start(test::tube(), {}).value().findings, preflight::FindingKind::kOnOpenRing),
      nullptr);
}

TEST(Preflight, ErrorsComeFirstAndNotesLast) {
  for (const test::BrokenStart& b : test::broken_starts()) {
    const auto start = drape::prepare_start(b.make(), {}).value();
    EXPECT_TRUE(std::is_sorted(
        start.findings.begin(), start.findings.end(),
        [](const preflight::Finding& f, const preflight::Finding& g) { return f.severity > g.severity; }));
  }
}

TEST(TriangleGap, NeighboursHaveNoneAndCrossingTrianglesHaveZero) {
  const preflight::GapTriangle flat{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0, 1, 2}};
  const preflight::GapTriangle above{{{{0, 0, 0.25}, {1, 0, 0.25}, {0, 1, 0.25}}}, {3, 4, 5}};
  const preflight::GapTriangle through{{{{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.3, 2, 0}}}, {3, 4, 5}};
  preflight::GapTriangle neighbour = above;
  neighbour.type = {0, 1, 2};
  EXPECT_DOUBLE_EQ(preflight::triangle_gap(flat, above), 0.25);
  EXPECT_EQ(preflight::triangle_gap(flat, through), 0);
  EXPECT_TRUE(preflight::triangles_cross(flat, through));
  EXPECT_EQ(preflight::triangle_gap(flat, neighbour), 1);
  EXPECT_FALSE(preflight::triangles_cross(flat, above));
}

}  // namespace
}  // namespace toile
