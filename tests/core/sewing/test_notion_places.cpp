#include "core/sewing/notion_places.h"

#include <gtest/gtest.h>

#include "core/sewing/assembly.h"

namespace toile {
namespace {

/// Two panels: a unit square of two triangles with a line along its diagonal, and another one.
mesh::PanelMeshes two_squares() {
  mesh::PanelMesh square;
  square.rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  square.edge_vertices = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  square.line_vertices = {{0, 2}};
  mesh::PanelMeshes meshes;
  meshes.panels = {square, square};
  return meshes;
}

Result<sewing::Assembly> assembled(const sewing::Notions& notions) {
  return sewing::assemble(
      two_squares(), {sewing::RigidPlacement{}, sewing::RigidPlacement{{0, 0, 1}, {}, false}}, {}, notions);
}

sewing::Notions button(Vec2 a, Vec2 b) {
  sewing::Notions notions;
  notions.buttons = {{"b", {0, a}, {1, b}, 0}};
  return notions;
}

TEST(NotionPlaces, AButtonsPointLiesOnTheTriangleAroundIt) {
  const sewing::Assembly a = assembled(button({0.7, 0.2}, {0.1, 0.9})).value();
  const auto& [first, second] = a.notions.buttons[0];
  EXPECT_LT(length(sewing::position_of(first, a.positions) - Vec3{0.7, 0.2, 0}), 1e-7);
  EXPECT_LT(length(sewing::position_of(second, a.positions) - Vec3{0.1, 0.9, 1}), 1e-7);
  for (const Index v : second.v) EXPECT_GE(v, 4) << "in the garment's vertices";
}

TEST(NotionPlaces, AButtonJustBesideTheMeshLiesOnItsBorder) {
  const sewing::Assembly a = assembled(button({0.5, -0.05}, {1.05, 1.05})).value();
  const auto& [first, second] = a.notions.buttons[0];
  EXPECT_LT(length(sewing::position_of(first, a.positions) - Vec3{0.5, 0, 0}), 1e-7);
  EXPECT_LT(length(sewing::position_of(second, a.positions) - Vec3{1, 1, 1}), 1e-7);
  for (const double share : first.share) EXPECT_GE(share, 0);
}

TEST(NotionPlaces, AButtonFarBesideIsRefusedWithItsSide) {
  const auto a = assembled(button({0.5, 0.5}, {0.5, 1.5}));
  ASSERT_FALSE(a.ok());
  EXPECT_EQ(a.error().code, "button.off_piece");
  EXPECT_EQ(a.error().where, "button b, side b");
}

TEST(NotionPlaces, ChainsAreInTheGarmentsVertices) {
  sewing::Notions notions;
  notions.elastics = {{"e", 1, {1, 2}, {0}, 0.8, 10}};
  notions.creases = {{"c", 1, {}, {0}, 1, 0.1}};
  const sewing::Assembly a = assembled(notions).value();
  EXPECT_EQ(a.notions.elastics[0], (sewing::VertexChains{{5, 6}, {6, 7}, {4, 6}}));
  EXPECT_EQ(a.notions.creases[0], (sewing::VertexChains{{4, 6}}));
}

}  // namespace
}  // namespace toile
