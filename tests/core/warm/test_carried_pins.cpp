#include "core/warm/carried_pins.h"

#include <gtest/gtest.h>

#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"

namespace toile {
namespace {

/// Two sheets, the second `hem` mm longer than 400 at its lower end.
pattern::Pattern sheets(double hem = 0) {
  return {{test::polygon("first", {{0, 0}, {300, 0}, {300, 400}, {0, 400}}),
           test::polygon("second", {{0, -hem}, {300, -hem}, {300, 400}, {0, 400}})},
          {}};
}

mesh::PanelMeshes meshed(const pattern::Pattern& pattern, double distance = 0.02) {
  return mesh::make_panel_meshes(pattern, distance, {}).value();
}

warm::HungGarment pinned(const std::vector<warm::HungPin>& pins) {
  warm::HungGarment hung = warm::flat_pieces(sheets(), meshed(sheets()));
  hung.pins = pins;
  return hung;
}

/// Where a point of the garment is in its flat piece, m.
Vec2 flat(const warm::CarriedPin& pin, const mesh::PanelMeshes& meshes, std::size_t panel) {
  auto triangle = static_cast<std::size_t>(pin.triangle);
  for (std::size_t p = 0; p < panel; ++p) triangle -= meshes.panels[p].triangles.size();
  EXPECT_LT(triangle, meshes.panels[panel].triangles.size()) << "it is of another piece";
  Vec2 place;
  for (std::size_t k = 0; k < 3; ++k)
    place = place + meshes.panels[panel].rest[meshes.panels[panel].triangles[triangle][k]] * pin.share.at(k);
  return place;
}

void expect_at(Vec2 place, Vec2 wanted, double within) {
  EXPECT_NEAR(place.x, wanted.x, within);
  EXPECT_NEAR(place.y, wanted.y, within);
}

TEST(CarriedPins, StayWhereTheyWereInPiecesThatNobodyChanged) {
  const mesh::PanelMeshes meshes = meshed(sheets());
  const auto pins = warm::carried_pins(
      pinned({{"second", {0.11, 0.21}}, {"first", {0.07, 0.3}}, {"second", {0.3, 0.4}}}), sheets(), meshes);
  ASSERT_EQ(pins.size(), 3U);
  expect_at(flat(pins[0], meshes, 1), {0.11, 0.21}, 1e-12);
  expect_at(flat(pins[1], meshes, 0), {0.07, 0.3}, 1e-12);
  expect_at(flat(pins[2], meshes, 1), {0.3, 0.4}, 1e-12);
  for (const warm::CarriedPin& pin : pins) EXPECT_NEAR(pin.share[0] + pin.share[1] + pin.share[2], 1, 1e-12);
}

TEST(CarriedPins, StayWhereTheyWereInAFinerMesh) {
  const mesh::PanelMeshes meshes = meshed(sheets(), 0.013);
  const auto pins = warm::carried_pins(pinned({{"first", {0.11, 0.21}}}), sheets(), meshes);
  ASSERT_EQ(pins.size(), 1U);
  expect_at(flat(pins[0], meshes, 0), {0.11, 0.21}, 1e-3);
}

TEST(CarriedPins, GoWithTheClothOfAnEditedPiece) {
  const pattern::Pattern longer = sheets(100);  // the cloth of before is shared out over it
  const mesh::PanelMeshes meshes = meshed(longer);
  const auto pins =
      warm::carried_pins(pinned({{"second", {0.15, 0.2}}, {"first", {0.15, 0.2}}}), longer, meshes);
  ASSERT_EQ(pins.size(), 2U);
  expect_at(flat(pins[0], meshes, 1), {0.15, 0.15}, 6e-3);
  expect_at(flat(pins[1], meshes, 0), {0.15, 0.2}, 1e-12);
}

TEST(CarriedPins, AreGoneWithTheirCloth) {
  pattern::Pattern cut = sheets();
  cut.panels.pop_back();
  pattern::Loop hole = test::polygon("", {{100, 100}, {100, 200}, {200, 200}, {200, 100}}).outline;
  for (pattern::PanelEdge& edge : hole.edges) edge.id += " of the hole";
  cut.panels[0].holes.push_back(hole);
  const mesh::PanelMeshes meshes = meshed(cut);
  const auto pins = warm::carried_pins(
      pinned({{"second", {0.1, 0.1}}, {"first", {0.15, 0.15}}, {"first", {0.05, 0.3}}}), cut, meshes);
  ASSERT_EQ(pins.size(), 1U) << "of three: one of a piece that is gone, one where there is a hole now";
  expect_at(flat(pins[0], meshes, 0), {0.05, 0.3}, 5e-3);
}

}  // namespace
}  // namespace toile
