// Lines through pieces: edges of the mesh lie on them.

#include <gtest/gtest.h>

#include <set>

#include "core/base/units.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/mesh/quality.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangulate.h"
#include "tests/core/mesh/shapes.h"

namespace toile {
namespace {

constexpr double kH = 0.015;

pattern::Pattern one_piece(std::vector<pattern::InnerLine> lines) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 202, 97)};
  pattern.panels[0].lines = std::move(lines);
  return pattern;
}

/// All steps of the line are edges with a triangle on both sides.
void expect_laid(const mesh::PanelMesh& mesh, std::size_t line) {
  std::set<std::array<Index, 2>> inner;
  for (const mesh::MeshEdge& e : mesh::edges_of(mesh.triangles, static_cast<Index>(mesh.rest.size()))) {
    if (e.t1 != kNone) inner.insert({std::min(e.v0, e.v1), std::max(e.v0, e.v1)});
  }
  const std::vector<Index>& v = mesh.line_vertices[line];
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    EXPECT_TRUE(inner.contains({std::min(v[i], v[i + 1]), std::max(v[i], v[i + 1])}));
  }
}

void expect_good_triangles(const mesh::PanelMesh& mesh, double area) {
  ASSERT_TRUE(mesh::check_manifold(mesh.triangles, static_cast<Index>(mesh.rest.size())));
  const mesh::MeshQuality q = mesh::quality_of(mesh.rest, mesh.triangles);
  EXPECT_EQ(q.inverted, 0);
  EXPECT_NEAR(q.area / area, 1, 1e-9);
  EXPECT_GE(degrees_from_radians(q.min_angle), 20);
  EXPECT_NEAR(q.mean_edge, kH, 0.15 * kH);
}

TEST(InnerLines, EdgesOfTheMeshLieOnALineFromSideToSide) {
  const pattern::Pattern pattern = one_piece({{"fold", {{0, 41}, {202, 53}}}});
  const auto meshes = mesh::make_panel_meshes(pattern, kH, {});
  ASSERT_TRUE(meshes) << to_string(meshes.error());
  const mesh::PanelMesh& mesh = meshes->panels[0];
  ASSERT_EQ(mesh.line_vertices.size(), 1u);
  expect_laid(mesh, 0);
  expect_good_triangles(mesh, 0.202 * 0.097);
  const std::vector<Index>& v = mesh.line_vertices[0];
  EXPECT_EQ(v.size(), 14u);
  for (const Index i : v) {
    EXPECT_NEAR(mesh.rest[i].y, 0.041 + 0.012 * mesh.rest[i].x / 0.202, 1e-6);
  }
  EXPECT_NEAR(mesh.rest[v.front()].x, 0, 1e-9) << "it reaches the outline";
  EXPECT_NEAR(mesh.rest[v.back()].x, 0.202, 1e-9);
  const auto& right = mesh.edge_vertices[1];
  EXPECT_NE(std::find(right.begin(), right.end(), v.back()), right.end()) << "in one of its points";
}

TEST(InnerLines, BentAndSlantedLinesInsideAreLaidToo) {
  const pattern::Pattern pattern = one_piece(
      {{"a", {{30, 20}, {90, 70}, {150, 25}}}, {"b", {{150, 25}, {170, 80}}}, {"c", {{20, 80}, {60, 81}}}});
  const auto meshes = mesh::make_panel_meshes(pattern, kH, {});
  ASSERT_TRUE(meshes) << to_string(meshes.error());
  const mesh::PanelMesh& mesh = meshes->panels[0];
  for (std::size_t line = 0; line < 3; ++line) expect_laid(mesh, line);
  expect_good_triangles(mesh, 0.202 * 0.097);
  EXPECT_EQ(mesh.line_vertices[0].back(), mesh.line_vertices[1].front()) << "they share a point";
}

TEST(InnerLines, TheMeshIsTheSameWhateverIsOnlyDrawn) {
  const pattern::Pattern bare = one_piece({{"fold", {{0, 41}, {202, 53}}}});
  const pattern::Pattern drawn = one_piece({{"mark", {{20, -50}, {20, 80}, {180, 80}}, true},
                                            {"fold", {{0, 41}, {202, 53}}},
                                            {"cross", {{20, 80}, {180, 30}}, true}});
  const mesh::PanelMesh a = mesh::make_panel_meshes(bare, kH, {})->panels[0];
  const mesh::PanelMesh b = mesh::make_panel_meshes(drawn, kH, {})->panels[0];
  EXPECT_EQ(a.rest, b.rest);
  EXPECT_EQ(a.triangles, b.triangles);
  ASSERT_EQ(b.line_vertices.size(), 3u);
  EXPECT_TRUE(b.line_vertices[0].empty() && b.line_vertices[2].empty());
  EXPECT_EQ(b.line_vertices[1], a.line_vertices[0]);
}

TEST(InnerLines, AnEndOnASewnEdgeMovesItsPartnerAlong) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 200, 100), rectangle_panel("back", 200, 150)};
  pattern.seams = {{"side", {{0, 1, false}}, {{1, 3, false}}, false}};
  pattern.panels[0].lines = {{"fold", {{100, 50}, {200, 54}}}};
  const auto meshes = mesh::make_panel_meshes(pattern, kH, {});
  ASSERT_TRUE(meshes) << to_string(meshes.error());
  const Index end = meshes->panels[0].line_vertices[0].back();
  EXPECT_NEAR(meshes->panels[0].rest[end].y, 0.054, 1e-9);
  bool found = false;
  for (const mesh::SewnPair& pair : meshes->seams[0].pairs) {
    if (pair.a.vertex != end) continue;
    found = true;
    EXPECT_NEAR(meshes->panels[1].rest[pair.b.vertex].y, 0.150 * 0.54, 1e-6) << "no cloth is crowded there";
  }
  EXPECT_TRUE(found);
}

TEST(InnerLines, LinesThatCrossOrLeaveThePieceAreRefusedWithThePlace) {
  const auto code = [](std::vector<pattern::InnerLine> lines) {
    const auto meshes = mesh::make_panel_meshes(one_piece(std::move(lines)), kH, {});
    return meshes ? std::string() : meshes.error().code;
  };
  EXPECT_EQ(code({{"a", {{20, 20}, {180, 80}}}, {"b", {{20, 80}, {180, 20}}}}), "mesh.line");
  EXPECT_EQ(code({{"a", {{20, 20}, {300, 80}}}}), "mesh.line");
  EXPECT_EQ(code({{"a", {{220, 20}, {300, 80}}}}), "mesh.line");
  EXPECT_EQ(code({{"a", {{0, 0}, {1e9, 80}}}}), "mesh.too_many_particles");
}

TEST(InnerLines, APieceWithoutLinesIsMeshedAsEver) {
  const auto loops = std::vector<mesh::Polygon>{sampled({{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, kH)};
  const auto plain = mesh::triangulate(loops, kH, {});
  const auto again = mesh::triangulate(loops, kH, {}, {});
  ASSERT_TRUE(plain && again);
  EXPECT_EQ(plain->points, again->points);
  EXPECT_TRUE(plain->lines.empty());
}

}  // namespace
}  // namespace toile
