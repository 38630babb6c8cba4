// Buttons, elastic, creases and cushions in whole drapes, each with an answer that is known beforehand.

#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "core/drape/pipeline.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/solver/constraints/pressure.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

constexpr double kHalfTurn = 3.14159265358979;

/// Upright sheets without a body or weight, one behind the other.
drape::DrapeInput floating(double width, double height, std::vector<double> depths) {
  drape::DrapeInput input;
  input.name = "floating";
  for (std::size_t i = 0; i < depths.size(); ++i) {
    input.pattern.panels.push_back(test::rectangle("sheet" + std::to_string(i), width, height));
    input.placements.push_back(sewing::RigidPlacement{{0, 1, depths[i]}, {}, false});
    input.fabric_of_panel.push_back(0);
  }
  input.fabrics = {material::Fabric{}};
  input.settings.particle_distance = 0.015;
  input.settings.time_step = 1.0 / 2000;
  input.settings.gravity = 0;
  input.settings.sew_time = 0.4;
  return input;
}

Vec3 mean(std::span<const Vec3> of) {
  Vec3 sum;
  for (const Vec3& p : of) sum += p;
  return sum * (1.0 / static_cast<double>(of.size()));
}

void expect_clean(const drape::DrapeResult& r) {
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_GT(r.frames_checked, 10);
}

/// Where a flat point of a panel has come to.
Vec3 place_of(const drape::DrapeInput& input, const drape::DrapeResult& r, const sewing::PanelPoint& point) {
  const mesh::PanelMeshes meshes =
      mesh::make_panel_meshes(input.pattern, input.settings.particle_distance, {}).value();
  sewing::Notions notions;
  notions.buttons = {{"b", point, point, 0}};
  return sewing::position_of(sewing::locate_notions(notions, meshes, r.garment).value().buttons[0][0],
                             r.positions);
}

TEST(Notions, AButtonDrawsTwoSheetsTogetherAndHoldsThem) {
  drape::DrapeInput input = floating(100, 100, {0, 0.03});
  const sewing::Button button{"b", {0, {0.003, 0.052}}, {1, {-0.02, 0.031}}, 2e-3};
  input.notions.buttons = {button};
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kSettled);
  expect_clean(r);
  EXPECT_LT(length(place_of(input, r, button.a) - place_of(input, r, button.b)), 2.05e-3);
  const Index first = r.garment.first_vertex[1];
  const std::span all(r.positions);
  EXPECT_GT(mean(all.subspan(first)).z - mean(all.first(first)).z, 0.5e-3) << "and contact keeps them apart";
}

TEST(Notions, AButtonThatABodyKeepsOpenIsToldByName) {
  drape::DrapeInput input = floating(60, 60, {0.1, -0.1});
  input.bodies = {test::column(0.07, 0.8, 1.3)};
  for (const Index sheet : {0, 1}) {  // held by their lower edges, so that they cannot slide around it
    sewing::Attachment lower;
    lower.panel = sheet;
    lower.edges = {0};
    lower.hold = sewing::Attachment::Hold::kPlace;
    lower.release_after = -1;
    input.attachments.push_back(lower);
  }
  input.notions.buttons = {{"cuff", {0, {0, 0.03}}, {1, {0, 0.03}}, 2e-3}};
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(drape::to_string(r.stop_reason), "open button cuff");
  EXPECT_GT(r.stop_reason.gap, 3e-3) << "by how much it is open";
  expect_clean(r);
}

TEST(Notions, AButtonBesideItsPieceIsRefusedWithItsName) {
  drape::DrapeInput input = floating(100, 100, {0, 0.03});
  input.notions.buttons = {{"b", {0, {0.2, 0.05}}, {1, {0, 0.05}}, 2e-3}};
  const auto r = drape::drape(input, {}, nullptr);
  ASSERT_FALSE(r.ok());
  EXPECT_EQ(r.error().code, "button.off_piece");
  EXPECT_NE(r.error().where.find("button b"), std::string::npos);
}

/// Length of the ring that the top edges of a tube's two panels make, in chords over so many edges, m.
double ring_length(const drape::DrapeInput& input, const drape::DrapeResult& r, std::size_t stride) {
  const mesh::PanelMeshes meshes =
      mesh::make_panel_meshes(input.pattern, input.settings.particle_distance, {}).value();
  double sum = 0;
  for (std::size_t p = 0; p < 2; ++p) {
    const std::vector<Index>& top = meshes.panels[p].edge_vertices[2];
    const Index first = r.garment.first_vertex[p];
    const std::size_t edges = top.size() - 1, parts = (edges + stride / 2) / stride;
    for (std::size_t i = 0; i < parts; ++i)
      sum += length(r.positions[first + top[(i + 1) * edges / parts]] -
                    r.positions[first + top[i * edges / parts]]);
  }
  return sum;
}

/// 520 mm of cloth with a band of 364 mm on a column of 16 sides around 437 mm, from which it keeps 1 mm.
drape::DrapeInput banded_tube() {
  drape::DrapeInput input = test::tube();
  input.settings.particle_distance = 0.013;
  input.settings.sew_time = 0.5;
  input.notions.elastics = {{"front band", 0, {2}, {}, 0.7, 15}, {"back band", 1, {2}, {}, 0.7, 15}};
  return input;
}

const double kColumn = 2 * 16 * 0.07 * std::sin(kHalfTurn / 16) + 2 * kHalfTurn * 1e-3;  // m around

TEST(Notions, AnElasticWaistbandStretchesToTheGirthThatItIsOn) {
  // The band comes to rest there, 22 % longer than without load, where stiffness · 0.22 is its tension.
  drape::DrapeInput input = banded_tube();
  sewing::Attachment back = input.attachments[0];
  back.id = "top back";
  back.panel = 1;
  input.attachments.push_back(back);
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  expect_clean(r);
  EXPECT_NEAR(ring_length(input, r, 1) / kColumn, 1, 0.02);
}

TEST(Notions, AnElasticThatNothingElseHoldsGathersTheClothAndKeepsItUp) {
  drape::DrapeInput input = banded_tube();
  input.attachments.clear();
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  expect_clean(r);
  const double chords = std::sin(kHalfTurn / 10) / (kHalfTurn / 10);  // ten of them around a circle
  EXPECT_NEAR(ring_length(input, r, 4) / (kColumn * chords), 1, 0.02);
  EXPECT_NEAR(ring_length(input, r, 1) / 0.52, 1, 0.03) << "the cloth is gathered, and not squeezed";
  const auto top = [](const std::vector<Vec3>& x) {
    return std::max_element(x.begin(), x.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })->y;
  };
  input.notions.elastics.clear();
  const drape::DrapeResult loose = drape::drape(input, {}, nullptr).value();
  EXPECT_GT(top(r.positions), top(loose.positions) + 0.1) << "without it the tube falls";
}

TEST(Notions, WhatIsHeldUntilFrictionCarriesItIsGatheredAsWell) {
  drape::DrapeInput input = banded_tube();
  for (sewing::Attachment& attachment : input.attachments) attachment.release_after = 0.2;
  EXPECT_FALSE(input.hangs_by_hooks());
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  expect_clean(r);
  EXPECT_NEAR(ring_length(input, r, 1) / 0.52, 1, 0.03) << "in folds, not squeezed";
  input.attachments[0].release_after = -1;
  EXPECT_TRUE(input.hangs_by_hooks());
}

TEST(Notions, ACreaseAlongALineComesToRestAtItsAngle) {
  drape::DrapeInput input = floating(100, 60, {0});
  input.pattern.panels[0].lines = {{"fold", {{0, 0}, {0, 60}}}};
  input.notions.creases = {{"c", 0, {}, {0}, kHalfTurn / 2, 0.05}};
  input.settings.until_settled = false;
  input.settings.max_time = 2;  // nothing holds it: it may drift
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_LT(r.rms_speed, 0.005);
  expect_clean(r);
  const auto at = [&](Vec2 p) { return place_of(input, r, {0, p}); };
  const Vec3 left = normalized(at({0, 0.03}) - at({-0.05, 0.03}));
  const Vec3 right = normalized(at({0.05, 0.03}) - at({0, 0.03}));
  EXPECT_NEAR(std::acos(dot(left, right)) * 180 / kHalfTurn, 90, 5);
  EXPECT_LT(at({0.05, 0.03}).z, at({0, 0.03}).z) << "the side that is up in the flat piece stays outside";
}

TEST(Notions, ACreaseAlongASeamComesToRestAtItsAngleWhicheverPieceHasIt) {
  for (const Index piece : {0, 1}) {
    drape::DrapeInput input = floating(50, 60, {0, 0});
    input.placements[1] = sewing::RigidPlacement{{0.07, 1, 0}, {}, false};
    input.pattern.seams = {{"s", {{0, 1}}, {{1, 3}}, false}};
    input.notions.creases = {{"c", piece, {piece == 0 ? 1 : 3}, {}, -kHalfTurn / 2, 0.05}};
    input.settings.until_settled = false;
    input.settings.max_time = 2;
    const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
    EXPECT_LT(r.rms_speed, 0.005);
    expect_clean(r);
    const auto at = [&](Index panel, Vec2 p) { return place_of(input, r, {panel, p}); };
    const Vec3 left = normalized(at(0, {0.025, 0.03}) - at(0, {-0.025, 0.03}));
    const Vec3 right = normalized(at(1, {0.025, 0.03}) - at(1, {-0.025, 0.03}));
    EXPECT_NEAR(std::acos(dot(left, right)) * 180 / kHalfTurn, 90, 5) << piece;
    EXPECT_GT(cross(right, left).y, 0) << "the side that is up in the flat piece comes inside";
  }
}

constexpr double kWidth = 0.08, kLength = 0.32;  // m

/// Two long strips, one behind the other, sewn all round. Nothing holds it: it never counts as settled while
/// it turns slowly, so it takes its time.
drape::DrapeInput cushion(double pressure, double full_volume) {
  drape::DrapeInput input = floating(1e3 * kWidth, 1e3 * kLength, {0, -0.006});
  for (Index e = 0; e < 4; ++e) {
    input.pattern.seams.push_back({"s" + std::to_string(e), {{0, e, false}}, {{1, e, false}}, true});
  }
  input.notions.cushions = {{"bolster", {0, 1}, pressure, full_volume}};
  input.settings.particle_distance = 0.012;
  input.settings.time_step = 1.0 / 3000;
  input.settings.until_settled = false;
  input.settings.max_time = 2;
  return input;
}

double volume_inside(const drape::DrapeResult& r) {
  std::vector<Tri> joined;
  for (const auto& [a, b, c] : r.garment.triangles) {
    joined.push_back({r.garment.weld[a], r.garment.weld[b], r.garment.weld[c]});
  }
  return solver::constraints::volume_of(
      solver::constraints::make_chamber(joined, r.garment.vertex_count(), 0, 0), r.positions);
}

TEST(Notions, ALongCushionHoldsWhatAPaperBagHolds) {
  const drape::DrapeResult r = drape::drape(cushion(30, 0), {}, nullptr).value();
  expect_clean(r);
  EXPECT_EQ(r.seam_gap_max, 0);
  // A tube of the strips' girth, L w²/π, less what the flat ends cost: 0.142 w³ (1 − 10^(−L/w)), the paper
  // bag problem's usual approximation.
  const double w = kWidth, ends = 0.142 * w * w * w, bag = kLength * w * w / kHalfTurn - ends;
  EXPECT_NEAR(volume_inside(r) / bag, 1, 0.05);
  const Vec3 moved = mean(r.positions) - Vec3{0, 1 + kLength / 2, -0.003};
  EXPECT_LT(length(moved), 3e-3) << "the pressure's forces cancel: it stays where it was";
}

TEST(Notions, AFixedAmountOfAirFillsACushionAsItsPressureTimesVolumeSays) {
  const double pumped = volume_inside(drape::drape(cushion(30, 0), {}, nullptr).value());
  const double fixed = volume_inside(drape::drape(cushion(60, pumped / 2), {}, nullptr).value());
  EXPECT_NEAR(fixed / pumped, 1, 0.01) << "30 Pa in all of it are 60 Pa in half";
}

TEST(Notions, ADrapeWithAllOfThemGoesOnFromACheckpointInTheSameBytes) {
  drape::DrapeInput input = cushion(30, 0.1e-3);
  input.settings.max_time = 0.9;
  input.pattern.panels[0].lines = {{"fold", {{-20, 160}, {20, 160}}}};
  input.notions.buttons = {{"tuft", {0, {0, 0.2}}, {1, {0, 0.2}}, 2e-3}};
  input.notions.elastics = {{"band", 1, {1}, {}, 0.8, 5}};
  input.notions.creases = {{"c", 0, {}, {0}, kHalfTurn / 2, 0.05}};
  input.settings.air.density = 1.2;
  const drape::DrapeResult whole = drape::drape(input, {}, nullptr).value();
  auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  for (const int steps : {500, 1000, 800}) {  // while sewing, after the weld, and later
    run->advance(steps, {});
    run = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  }
  run->advance(100000, {});
  EXPECT_EQ(run->conclude().positions, whole.positions);
}

}  // namespace
}  // namespace toile
