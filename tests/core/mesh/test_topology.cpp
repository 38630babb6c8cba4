#include "core/mesh/topology.h"

#include <gtest/gtest.h>

#include <vector>

namespace toile {
namespace {

// Two triangles on a square: 0 1 / 2 3 counter-clockwise 0,1,3,2.
const std::vector<Tri> kSquare{{0, 1, 3}, {0, 3, 2}};

TEST(Topology, ListsEveryEdgeOnceInOrderOfItsVertices) {
  const auto edges = mesh::edges_of(kSquare, 4);
  ASSERT_EQ(edges.size(), 5u);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto key = [](const mesh::MeshEdge& e) {
      return std::array<Index, 2>{std::min(e.v0, e.v1), std::max(e.v0, e.v1)};
    };
    EXPECT_LT(key(edges[i - 1]), key(edges[i]));
  }
}

TEST(Topology, AnInnerEdgeKnowsBothTrianglesAndTheirFreeCorners) {
  const auto edges = mesh::edges_of(kSquare, 4);
  const mesh::MeshEdge diagonal{3, 0, 0, 1, 1, 2};  // runs 3 → 0 in triangle 0
  EXPECT_EQ(edges[2], diagonal);
  EXPECT_EQ(edges[0], (mesh::MeshEdge{0, 1, 0, kNone, 3, kNone}));
}

TEST(Topology, NeighboursStandOppositeTheirCorner) {
  const auto neighbours = mesh::neighbours_of(kSquare, mesh::edges_of(kSquare, 4));
  EXPECT_EQ(neighbours[0], (std::array<Index, 3>{kNone, 1, kNone}));
  EXPECT_EQ(neighbours[1], (std::array<Index, 3>{kNone, kNone, 0}));
}

TEST(Topology, FindsTheBorderWithTheSurfaceToItsLeft) {
  const auto loops = mesh::boundary_loops(mesh::edges_of(kSquare, 4));
  ASSERT_EQ(loops.count(), 1);
  EXPECT_EQ(loops.vertices, (std::vector<Index>{0, 1, 3, 2}));
}

TEST(Topology, ARingHasTwoBordersAndEulerCharacteristicZero) {
  // outer 0 1 2, inner 3 4 5
  const std::vector<Tri> ring{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  ASSERT_TRUE(mesh::check_manifold(ring, 6));
  const auto loops = mesh::boundary_loops(mesh::edges_of(ring, 6));
  ASSERT_EQ(loops.count(), 2);
  EXPECT_EQ(loops.vertices, (std::vector<Index>{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(loops.first, (std::vector<Index>{0, 3, 6}));
  EXPECT_EQ(mesh::euler_characteristic(ring, 6), 0);
}

TEST(Topology, LoopsThatTouchInAVertexArePartedThere) {
  const std::vector<Tri> bow_tie{{0, 1, 2}, {2, 3, 4}};
  const auto loops = mesh::boundary_loops(mesh::edges_of(bow_tie, 5));
  EXPECT_EQ(loops.vertices.size(), 6u);
  for (Index i = 0; i < loops.count(); ++i) EXPECT_GE(loops.first[i + 1] - loops.first[i], 3);
}

TEST(Topology, AClosedSurfaceHasNoBorder) {
  const std::vector<Tri> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(mesh::check_manifold(tetrahedron, 4));
  EXPECT_EQ(mesh::boundary_loops(mesh::edges_of(tetrahedron, 4)).count(), 0);
  EXPECT_EQ(mesh::euler_characteristic(tetrahedron, 4), 2);
}

TEST(Topology, AFinOnAnEdgeIsNotAManifold) {
  const std::vector<Tri> fin{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Status status = mesh::check_manifold(fin, 5);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, "mesh.non_manifold");
  EXPECT_EQ(status.error().where, "triangle 2");
  EXPECT_EQ(mesh::edges_of(fin, 5).size(), 8u);  // edge 0-1 twice: once shared, once as the fin's own border
}

TEST(Topology, NeighboursOfOppositeWindingAreRefused) {
  const std::vector<Tri> twisted{{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(mesh::check_manifold(twisted, 4).error().code, "mesh.winding");
}

TEST(Topology, ATriangleWithARepeatedOrMissingVertexIsRefused) {
  EXPECT_EQ(mesh::check_manifold(std::vector<Tri>{{0, 1, 1}}, 3).error().code, "mesh.degenerate_triangle");
  EXPECT_EQ(mesh::check_manifold(std::vector<Tri>{{0, 1, 3}}, 3).error().code, "mesh.index");
  EXPECT_EQ(mesh::check_manifold(std::vector<Tri>{{0, 1, kNone}}, 3).error().code, "mesh.index");
}

TEST(Topology, AnEmptyMeshHasNoEdges) { EXPECT_TRUE(mesh::edges_of({}, 0).empty()); }

}  // namespace
}  // namespace toile
