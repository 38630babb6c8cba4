#include "core/mesh/vertex_normals.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-12) << a.x << " " << a.y << " " << a.z; }

/// Two triangles that meet at a right angle along the y axis, each with its own vertices, as sewn pieces
/// have.
const std::vector<Vec3> kRoof{{0, 0, 0}, {0, 1, 0}, {-1, 0.5, -1}, {0, 0, 0}, {0, 1, 0}, {1, 0.5, -1}};
const std::vector<Tri> kRoofTriangles{{0, 1, 2}, {4, 3, 5}};

TEST(VertexNormals, OfAFlatPieceAreItsRightSide) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const Vec3 n : mesh::vertex_normals(square, std::vector<Tri>{{0, 1, 2}, {0, 2, 3}}))
    expect_near(n, {0, 0, 1});
}

TEST(VertexNormals, RunSmoothlyAcrossASeam) {
  const std::vector<Index> weld{0, 1, 2, 0, 1, 5};
  const std::vector<Vec3> joint = mesh::vertex_normals(kRoof, kRoofTriangles, weld);
  expect_near(joint[0], joint[3]);
  expect_near(joint[0], {0, 0, 1});
  EXPECT_LT(joint[2].x, -0.5);
  EXPECT_GT(joint[5].x, 0.5);
}

TEST(VertexNormals, BreakWherePiecesAreNotSewn) {
  const std::vector<Vec3> apart = mesh::vertex_normals(kRoof, kRoofTriangles);
  EXPECT_LT(apart[0].x, -0.5);
  EXPECT_GT(apart[3].x, 0.5);
}

TEST(VertexNormals, DoNotDependOnHowAFaceIsCut) {
  // A cube's corner: one of its three faces is cut into two triangles that both reach the corner.
  const std::vector<Vec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}};
  const std::vector<Tri> faces{{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {4, 5, 3}, {0, 1, 4}, {1, 6, 4}};
  expect_near(mesh::vertex_normals(cube, faces)[0], normalized(Vec3{-1, -1, -1}));
}

TEST(VertexNormals, KeepThePiecesOwnWhereASeamJoinsRightToWrongSide) {
  const std::vector<Tri> against{{0, 1, 2}, {3, 4, 5}};  // the second piece turned over
  const std::vector<Vec3> normals =
      mesh::vertex_normals(kRoof, against, std::vector<Index>{0, 1, 2, 0, 1, 5});
  const std::vector<Vec3> own = mesh::vertex_normals(kRoof, against);
  EXPECT_GT(dot(normals[0], own[0]), 0.2);
  EXPECT_GT(dot(normals[3], own[3]), 0.2);
}

TEST(VertexNormals, AreFiniteWithoutArea) {
  const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {7, 7, 7}};
  for (const Vec3 n : mesh::vertex_normals(line, std::vector<Tri>{{0, 1, 2}})) expect_near(n, {0, 0, 1});
}

}  // namespace
}  // namespace toile
