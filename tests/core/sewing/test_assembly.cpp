#include "core/sewing/assembly.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// Two triangles as panels, sewn along one edge, and a third sewn to both at one vertex.
mesh::PanelMeshes three_triangles() {
  mesh::PanelMesh mesh;
  mesh.rest = {{0, 0}, {0.1, 0}, {0, 0.1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.edge_vertices = {{0, 1}, {1, 2}, {2, 0}};
  mesh::PanelMeshes meshes;
  meshes.panels = {mesh, mesh, mesh};
  meshes.seams = {{0, {{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}}, 0.1, 0.1}, {1, {{{1, 1}, {2, 2}}}, 0.1, 0.1}};
  return meshes;
}

std::vector<sewing::Placement> apart() {
  return {sewing::RigidPlacement{}, sewing::RigidPlacement{{0, 0, 0.1}, {}, false},
          sewing::RigidPlacement{{0, 0, 0.2}, {}, false}};
}

TEST(Assembly, PanelsFollowEachOtherInOneVertexList) {
  const sewing::Assembly a = sewing::assemble(three_triangles(), apart(), {}).value();
  EXPECT_EQ(a.garment.vertex_count(), 9);
  EXPECT_EQ(a.garment.first_vertex, (std::vector<Index>{0, 3, 6, 9}));
  EXPECT_EQ(a.garment.triangles[1], (Tri{3, 4, 5}));
  EXPECT_EQ(a.garment.panel_of_vertex[5], 1);
  EXPECT_NEAR(a.positions[8].z, 0.2, 1e-7);
}

TEST(Assembly, SewnVerticesFormOneClassAcrossSeams) {
  const sewing::Assembly a = sewing::assemble(three_triangles(), apart(), {}).value();
  EXPECT_EQ(a.garment.sewn.size(), 3u);
  EXPECT_EQ(a.garment.weld, (std::vector<Index>{0, 1, 2, 1, 0, 5, 6, 7, 0}));
  EXPECT_EQ(a.garment.seam_of_sewn[2], 1);
}

TEST(Assembly, APairHoldsTheSeamHalfWayToItsNeighboursOnTheShorterSide) {
  sewing::GarmentMesh g;  // 40 mm gathered to 10 mm, in two steps of unlike length, and a stitch by itself
  g.rest = {{0, 0}, {0.01, 0}, {0.04, 0}, {0, 0}, {0.005, 0}, {0.01, 0}};
  g.panel_of_vertex = {0, 0, 0, 1, 1, 1};
  g.sewn = {{0, 3}, {1, 4}, {2, 5}, {0, 5}};
  g.seam_of_sewn = {0, 0, 0, 1};
  const std::vector<double> held = sewing::seam_held_by_pairs(g);
  ASSERT_EQ(held.size(), 4u);
  EXPECT_DOUBLE_EQ(held[0], 0.0025);
  EXPECT_DOUBLE_EQ(held[1], 0.005);
  EXPECT_DOUBLE_EQ(held[2], 0.0025);
  EXPECT_EQ(held[3], 0);
}

TEST(Assembly, AnAttachmentNamesTheVerticesOfItsEdgesOnce) {
  sewing::Attachment edges;
  edges.panel = 1;
  edges.edges = {0, 1};
  sewing::Attachment whole;
  whole.panel = 2;
  const sewing::Assembly a = sewing::assemble(three_triangles(), apart(), {edges, whole}).value();
  EXPECT_EQ(a.attached[0], (std::vector<Index>{3, 4, 5}));
  EXPECT_EQ(a.attached[1], (std::vector<Index>{6, 7, 8}));
}

TEST(Assembly, APlacementFarAwayOrNowhereIsRefused) {
  auto placements = apart();
  placements[1] = sewing::RigidPlacement{{std::nan(""), 0, 0}, {}, false};
  EXPECT_EQ(sewing::assemble(three_triangles(), placements, {}).error().code, "placement.not_finite");
  placements.pop_back();
  EXPECT_EQ(sewing::assemble(three_triangles(), placements, {}).error().code, "placement.count");
}

TEST(Assembly, TheStartStandsOnAGridSoThatItsBytesAreTheSameEverywhere) {
  const sewing::Assembly a =
      sewing::assemble(three_triangles(),
                       {sewing::WrappedPlacement{}, sewing::WrappedPlacement{}, sewing::WrappedPlacement{}},
                       {})
          .value();
  for (const Vec3& p : a.positions) EXPECT_EQ(p.x * 0x1p26, std::nearbyint(p.x * 0x1p26));
}

}  // namespace
}  // namespace toile
