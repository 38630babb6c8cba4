#include "core/mesh/make_panel_meshes.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/units.h"
#include "core/mesh/quality.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangulate.h"
#include "tests/core/mesh/shapes.h"

namespace toile {
namespace {

constexpr double kH = 0.015;

mesh::PanelMeshes meshed(const pattern::Pattern& pattern, double h = kH) {
  Result<mesh::PanelMeshes> meshes = mesh::make_panel_meshes(pattern, h, {});
  EXPECT_TRUE(meshes.ok()) << (meshes.ok() ? "" : to_string(meshes.error()));
  return meshes.ok() ? *meshes : mesh::PanelMeshes{};
}

std::string code_of(const pattern::Pattern& pattern, double h = kH) {
  const Result<mesh::PanelMeshes> meshes = mesh::make_panel_meshes(pattern, h, {});
  return meshes.ok() ? "" : meshes.error().code;
}

Vec2 place(const mesh::PanelMeshes& meshes, mesh::PanelVertex v) {
  return meshes.panels[v.panel].rest[v.vertex];
}

/// Along the edge from its start, as a share of its length; for straight edges.
std::vector<double> shares(const mesh::PanelMesh& mesh, Index edge) {
  const auto& v = mesh.edge_vertices[edge];
  const Vec2 start = mesh.rest[v.front()], end = mesh.rest[v.back()];
  std::vector<double> all;
  for (const Index i : v) all.push_back(length(mesh.rest[i] - start) / length(end - start));
  return all;
}

void expect_evenly_spaced(const mesh::PanelMesh& mesh, Index edge) {
  const auto all = shares(mesh, edge);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(all[i], double(i) / double(all.size() - 1), 1e-9);
}

TEST(MakePanelMeshes, AnUnsewnEdgeHasSegmentsNearestToTheParticleDistance) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 202, 97)};
  const mesh::PanelMeshes meshes = meshed(pattern);
  const mesh::PanelMesh& mesh = meshes.panels[0];
  ASSERT_EQ(mesh.edge_vertices.size(), 4u);
  EXPECT_EQ(mesh.edge_vertices[0].size(), 14u);  // 202 / 15 = 13.5
  EXPECT_EQ(mesh.edge_vertices[1].size(), 7u);   // 97 / 15 = 6.5 → 6
  for (Index e = 0; e < 4; ++e) {
    expect_evenly_spaced(mesh, e);
    EXPECT_EQ(mesh.edge_vertices[e].back(), mesh.edge_vertices[(e + 1) % 4].front());
  }
  EXPECT_EQ(mesh.rest[mesh.edge_vertices[2].front()], (Vec2{0.202, 0.097}));
}

TEST(MakePanelMeshes, VerticesAreMetresAndTheWarpIsTheGrain) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 300, 200)};
  pattern.panels[0].grain = {3, 4};
  const mesh::PanelMeshes meshes = meshed(pattern);
  EXPECT_NEAR(mesh::quality_of(meshes.panels[0].rest, meshes.panels[0].triangles).area, 0.06, 1e-10);
  EXPECT_NEAR(meshes.panels[0].warp.x, 0.6, 1e-15);
}

pattern::Pattern two_rectangles(double height_a, double height_b, bool reversed_b, bool same_direction) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("a", 200, height_a), rectangle_panel("b", 200, height_b)};
  pattern.seams = {{"side", {{0, 1, false}}, {{1, 3, reversed_b}}, same_direction}};
  return pattern;
}

TEST(MakePanelMeshes, ASeamOfEqualSidesPairsTheirPointsOneToOne) {
  const mesh::PanelMeshes meshes = meshed(two_rectangles(300, 300, false, false));
  const mesh::MatchedSeam& seam = meshes.seams[0];
  ASSERT_EQ(seam.pairs.size(), 21u);
  EXPECT_NEAR(seam.length_a, 0.3, 1e-12);
  for (std::size_t i = 0; i < seam.pairs.size(); ++i) {
    // a runs up, b runs down and is met from its end: both at the same height.
    EXPECT_NEAR(place(meshes, seam.pairs[i].a).y, 0.015 * double(i), 1e-9);
    EXPECT_NEAR(place(meshes, seam.pairs[i].b).y, 0.015 * double(i), 1e-9);
    EXPECT_EQ(place(meshes, seam.pairs[i].b).x, 0);
  }
}

TEST(MakePanelMeshes, ReversedAndSameDirectionEachTurnSideBRound) {
  for (const bool reversed_b : {false, true}) {
    for (const bool same_direction : {false, true}) {
      const mesh::PanelMeshes meshes = meshed(two_rectangles(300, 300, reversed_b, same_direction));
      const auto& pairs = meshes.seams[0].pairs;
      ASSERT_EQ(pairs.size(), 21u);
      const double first_b = reversed_b != same_direction ? 0.3 : 0.0;
      EXPECT_NEAR(place(meshes, pairs.front().b).y, first_b, 1e-12) << reversed_b << same_direction;
      EXPECT_NEAR(place(meshes, pairs.back().b).y, 0.3 - first_b, 1e-12);
    }
  }
}

TEST(MakePanelMeshes, SidesOfDifferentLengthStillMatchOneToOne) {
  for (const auto& [a, b] : {std::pair{452.0, 588.0}, std::pair{200.0, 600.0}, std::pair{600.0, 200.0}}) {
    const mesh::PanelMeshes meshes = meshed(two_rectangles(a, b, false, false));
    const mesh::MatchedSeam& seam = meshes.seams[0];
    EXPECT_EQ(seam.pairs.size(), std::size_t(std::round(std::max(a, b) / 15)) + 1);
    EXPECT_EQ(meshes.panels[0].edge_vertices[1].size(), meshes.panels[1].edge_vertices[3].size());
    expect_evenly_spaced(meshes.panels[0], 1);
    expect_evenly_spaced(meshes.panels[1], 3);
    EXPECT_NEAR(seam.length_b, b / 1000, 1e-12);
    for (const mesh::PanelMesh& mesh : meshes.panels) {
      EXPECT_GT(degrees_from_radians(mesh::quality_of(mesh.rest, mesh.triangles).min_angle), 20);
    }
  }
}

/// Front and back tops sewn to the lower edge of a waistband.
pattern::Pattern waistband(double front, double back, double band) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", front, 300), rectangle_panel("back", back, 300),
                    rectangle_panel("band", band, 30)};
  pattern.seams = {{"waist", {{1, 2, false}, {0, 2, false}}, {{2, 0, false}}, false}};
  return pattern;
}

TEST(MakePanelMeshes, AWaistbandIsCutWhereFrontMeetsBack) {
  const mesh::PanelMeshes meshes = meshed(waistband(240, 300, 500));
  const auto& pairs = meshes.seams[0].pairs;
  const auto& band = meshes.panels[2].edge_vertices[0];
  ASSERT_EQ(band.size(), 37u);               // 540 / 15 segments
  ASSERT_EQ(pairs.size(), band.size() + 1);  // the cut has two partners
  // Tops run from right to left: the path starts at the back's right, the band's path is run against.
  for (std::size_t i = 0; i <= 20; ++i) {
    EXPECT_EQ(pairs[i].a, (mesh::PanelVertex{1, meshes.panels[1].edge_vertices[2][i]}));
    EXPECT_EQ(pairs[i].b, (mesh::PanelVertex{2, band[36 - i]}));
  }
  for (std::size_t i = 0; i <= 16; ++i) {
    EXPECT_EQ(pairs[21 + i].a, (mesh::PanelVertex{0, meshes.panels[0].edge_vertices[2][i]}));
    EXPECT_EQ(pairs[21 + i].b, (mesh::PanelVertex{2, band[16 - i]}));
  }
  EXPECT_NEAR(shares(meshes.panels[2], 0)[16], 240.0 / 540, 1e-9);
}

TEST(MakePanelMeshes, TwoEdgesAgainstThreeCutEachOther) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("a0", 200, 100), rectangle_panel("a1", 400, 100),
                    rectangle_panel("b0", 150, 100), rectangle_panel("b1", 253, 100),
                    rectangle_panel("b2", 197, 100)};
  // b is walked backwards: b2, b1, b0 from a's start. Its corner at 197 meets a's at 200; that at 450 does
  // not.
  pattern.seams = {
      {"s", {{0, 0, false}, {1, 0, false}}, {{2, 0, false}, {3, 0, false}, {4, 0, false}}, false}};
  const mesh::PanelMeshes meshes = meshed(pattern);
  const auto count = [&](Index p) { return meshes.panels[p].edge_vertices[0].size() - 1; };
  EXPECT_EQ(count(0), count(4));
  EXPECT_EQ(count(1), count(3) + count(2));
  std::map<std::pair<Index, Index>, int> partners;
  for (const mesh::SewnPair& p : meshes.seams[0].pairs) ++partners[{p.a.panel, p.b.panel}];
  EXPECT_EQ(partners.size(), 3u);
  const std::pair<Index, Index> expected[]{{0, 4}, {1, 3}, {1, 2}};
  const Index b_of[]{4, 3, 2};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(partners[expected[i]], static_cast<int>(count(b_of[i])) + 1);
}

TEST(MakePanelMeshes, EverySampleOfASewnEdgeIsInExactlyOnePairOfItsNeighbourhood) {
  const mesh::PanelMeshes meshes = meshed(waistband(310, 207, 530));
  std::map<Index, int> seen;
  for (const mesh::SewnPair& p : meshes.seams[0].pairs) ++seen[p.b.vertex];
  int doubled = 0;
  for (const Index v : meshes.panels[2].edge_vertices[0]) {
    EXPECT_GE(seen[v], 1);
    doubled += seen[v] == 2;
  }
  EXPECT_EQ(doubled, 1);
}

TEST(MakePanelMeshes, NoSegmentIsShorterThanHalfTheParticleDistance) {
  for (const double front : {233.0, 238.0, 241.0, 247.0}) {
    const mesh::PanelMeshes meshes = meshed(waistband(front, 251, 489));
    for (const mesh::PanelMesh& mesh : meshes.panels) {
      for (const auto& edge : mesh.edge_vertices) {
        for (std::size_t i = 1; i < edge.size(); ++i) {
          EXPECT_GE(length(mesh.rest[edge[i]] - mesh.rest[edge[i - 1]]), 0.5 * kH);
        }
      }
    }
  }
}

TEST(MakePanelMeshes, ADartsTipIsNotSewnToItself) {
  pattern::Pattern pattern;
  pattern.panels = {
      straight_panel("bodice", {{0, 0}, {300, 0}, {300, 250}, {170, 250}, {150, 150}, {130, 250}, {0, 250}})};
  pattern.seams = {{"dart", {{0, 3, false}}, {{0, 4, false}}, false}};  // into the tip, out of it
  const mesh::PanelMeshes meshes = meshed(pattern);
  const auto& pairs = meshes.seams[0].pairs;
  const auto& in = meshes.panels[0].edge_vertices[3];
  EXPECT_EQ(pairs.size(), in.size() - 1);
  for (const mesh::SewnPair& p : pairs) {
    EXPECT_FALSE(p.a == p.b);
    EXPECT_NEAR(place(meshes, p.a).y, place(meshes, p.b).y, 1e-9);
  }
}

TEST(MakePanelMeshes, ConsecutiveEdgesOfOnePanelShareTheirCornerPair) {
  pattern::Pattern pattern;
  pattern.panels = {straight_panel("a", {{0, 0}, {150, 10}, {300, 0}, {300, 200}, {0, 200}}),
                    straight_panel("b", {{0, 0}, {150, 10}, {300, 0}, {300, 200}, {0, 200}})};
  pattern.seams = {{"s", {{0, 0, false}, {0, 1, false}}, {{1, 0, true}, {1, 1, true}}, true}};
  EXPECT_EQ(code_of(pattern), "");
  pattern.seams = {{"s", {{0, 0, false}, {0, 1, false}}, {{1, 0, false}, {1, 1, false}}, true}};
  const mesh::PanelMeshes meshes = meshed(pattern);
  EXPECT_EQ(meshes.seams[0].pairs.size(), 21u);
  for (const mesh::SewnPair& p : meshes.seams[0].pairs) EXPECT_EQ(p.a.vertex, p.b.vertex);
}

TEST(MakePanelMeshes, CurvedEdgesAreDividedByArcLength) {
  pattern::Pattern pattern;
  pattern::Panel panel;
  panel.id = "disc";
  panel.outline = circle_loop({0, 0}, 200, true, 1);
  panel.holes = {circle_loop({20, 30}, 60, false, 2)};
  pattern.panels = {panel};
  const mesh::PanelMeshes meshes = meshed(pattern);
  const mesh::PanelMesh& mesh = meshes.panels[0];
  ASSERT_EQ(mesh.edge_vertices.size(), 3u);
  const auto& rim = mesh.edge_vertices[0];
  EXPECT_EQ(rim.size(), 85u);  // 2π·200 / 15 = 83.8
  EXPECT_EQ(rim.front(), rim.back());
  for (std::size_t i = 1; i < rim.size(); ++i) {
    EXPECT_NEAR(length(mesh.rest[rim[i]] - mesh.rest[rim[i - 1]]), 2 * kPi * 0.2 / 84, 1e-5);
    EXPECT_NEAR(length(mesh.rest[rim[i]]), 0.2, 1e-4);
  }
  EXPECT_EQ(mesh.edge_vertices[1].back(), mesh.edge_vertices[2].front());
  EXPECT_EQ(mesh.edge_vertices[2].back(), mesh.edge_vertices[1].front());
  EXPECT_EQ(mesh::euler_characteristic(mesh.triangles, static_cast<Index>(mesh.rest.size())), 0);
}

TEST(MakePanelMeshes, APieceSmallerThanAParticleDistanceKeepsASegmentPerEdge) {
  pattern::Pattern pattern;
  pattern::Panel button;
  button.id = "button";
  button.outline = circle_loop({0, 0}, 4, true, 1);
  pattern::Panel tab;
  tab.id = "tab";
  tab.outline = circle_loop({0, 0}, 4, true, 2);
  pattern.panels = {rectangle_panel("loop", 8, 5), button, tab};
  const mesh::PanelMeshes meshes = meshed(pattern, 0.04);
  EXPECT_EQ(meshes.panels[0].triangles.size(), 2u);
  EXPECT_EQ(meshes.panels[1].triangles.size(), 1u);
  EXPECT_LE(meshes.panels[2].triangles.size(), 4u);
}

TEST(MakePanelMeshes, TwiceTheSameInputIsTwiceTheSameOutput) {
  const pattern::Pattern pattern = waistband(310, 207, 530);
  const mesh::PanelMeshes first = meshed(pattern), second = meshed(pattern);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(first.panels[p].rest, second.panels[p].rest);
    EXPECT_EQ(first.panels[p].triangles, second.panels[p].triangles);
    EXPECT_EQ(first.panels[p].edge_vertices, second.panels[p].edge_vertices);
  }
}

TEST(MakePanelMeshes, ParticlesFollowTheAreaAndTheParticleDistance) {
  for (const double h : {0.04, 0.02, 0.01, 0.005}) {
    pattern::Pattern pattern;
    pattern.panels = {rectangle_panel("front", 500, 700)};
    const mesh::PanelMeshes meshes = meshed(pattern, h);
    const mesh::PanelMesh& mesh = meshes.panels[0];
    const double border = 2 * (0.5 + 0.7) / h;
    EXPECT_NEAR(double(mesh.rest.size()) - border / 2, mesh::particle_estimate(0.35, h),
                0.04 * mesh::particle_estimate(0.35, h));
  }
}

TEST(MakePanelMeshes, NamesThePieceThatCannotBeMeshed) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 200, 300),
                    straight_panel("twisted", {{0, 0}, {300, 300}, {300, 0}, {0, 200}})};
  const auto meshes = mesh::make_panel_meshes(pattern, kH, {});
  ASSERT_FALSE(meshes.ok());
  EXPECT_EQ(meshes.error().code, "mesh.outline_crosses");
  EXPECT_EQ(meshes.error().where, "piece twisted");
}

TEST(MakePanelMeshes, RefusesTooManyParticlesWithTheirNumber) {
  pattern::Pattern pattern;
  for (int i = 0; i < 20; ++i) pattern.panels.push_back(rectangle_panel("p" + std::to_string(i), 1000, 1000));
  const auto meshes = mesh::make_panel_meshes(pattern, 0.005, {});
  ASSERT_FALSE(meshes.ok());
  EXPECT_EQ(meshes.error().code, "mesh.too_many_particles");
  EXPECT_NE(meshes.error().message.find("923760"), std::string::npos) << meshes.error().message;
  pattern.panels = {rectangle_panel("long", 4e8, 1)};
  EXPECT_EQ(code_of(pattern, 5e-4), "mesh.too_many_particles");
}

TEST(MakePanelMeshes, APanelWithASpacingOfItsOwnIsMeshedByIt) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("skirt", 300, 300), rectangle_panel("cuff", 300, 60)};
  pattern.panels[1].spacing = 0.006;
  pattern.seams = {{"s", {{0, 0, false}}, {{1, 2, false}}, false}};
  const mesh::PanelMeshes meshes = meshed(pattern);
  EXPECT_NEAR(mesh::quality_of(meshes.panels[1].rest, meshes.panels[1].triangles).mean_edge, 0.006, 0.001);
  EXPECT_GT(mesh::quality_of(meshes.panels[0].rest, meshes.panels[0].triangles).mean_edge, 0.011);
  EXPECT_EQ(meshes.panels[0].edge_vertices[2].size(), 21u) << "300 / 15, away from the seam";
  EXPECT_EQ(meshes.panels[0].edge_vertices[0].size(), 51u) << "300 / 6, as the cuff asks";
  EXPECT_EQ(meshes.panels[1].edge_vertices[2].size(), 51u);
  EXPECT_EQ(meshes.seams[0].pairs.size(), 51u);
  for (const mesh::PanelMesh& mesh : meshes.panels)
    EXPECT_GT(mesh::quality_of(mesh.rest, mesh.triangles).min_angle, 0.26);  // 15 degrees
}

TEST(MakePanelMeshes, ASpacingOfItsOwnThatIsTooFineNamesThePiece) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("a", 200, 300), rectangle_panel("b", 200, 300)};
  pattern.panels[1].spacing = 1e-4;
  const Result<mesh::PanelMeshes> meshes = mesh::make_panel_meshes(pattern, kH, {});
  ASSERT_FALSE(meshes.ok());
  EXPECT_EQ(meshes.error().code, "mesh.particle_distance");
  EXPECT_EQ(meshes.error().where, "piece b");
}

TEST(MakePanelMeshes, RefusesBrokenPatterns) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("a", 200, 300)};
  for (const double h : {0.0, -1.0, 1e-5, std::nan(""), 1.0 / 0.0}) {
    EXPECT_EQ(code_of(pattern, h), "mesh.particle_distance");
  }
  pattern.seams = {{"s", {{0, 0, false}}, {{0, 4, false}}, false}};
  EXPECT_EQ(code_of(pattern), "mesh.seam_edge");
  pattern.seams = {{"s", {{0, 0, false}}, {{1, 0, false}}, false}};
  EXPECT_EQ(code_of(pattern), "mesh.seam_edge");
  pattern.seams = {{"s", {{0, 0, false}}, {}, false}};
  EXPECT_EQ(code_of(pattern), "mesh.seam_edge");
  pattern.seams = {{"s", {{0, 0, false}}, {{0, 2, false}}, false},
                   {"t", {{0, 1, false}}, {{0, 2, false}}, false}};
  EXPECT_EQ(code_of(pattern), "mesh.seam_edge");
  pattern.seams = {};
  pattern.panels[0].outline.edges[1].curves[0].p0.x += 1;
  EXPECT_EQ(code_of(pattern), "mesh.outline_open");
  pattern.panels[0].outline.edges[1].curves[0].p0.x = std::nan("");
  EXPECT_EQ(code_of(pattern), "mesh.not_finite");
  pattern.panels[0].outline.edges[1].curves.clear();
  EXPECT_EQ(code_of(pattern), "mesh.edge_without_length");
  pattern.panels[0].outline.edges.clear();
  EXPECT_EQ(code_of(pattern), "mesh.too_few_points");
}

TEST(MakePanelMeshes, APatternWithoutPanelsHasNoMeshes) { EXPECT_TRUE(meshed({}).panels.empty()); }

TEST(MakePanelMeshes, TellsItsProgressUpToOne) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("a", 200, 300), rectangle_panel("b", 200, 300)};
  std::vector<double> fractions;
  RunContext context;
  context.on_progress = [&](const Progress& p) { fractions.push_back(p.fraction); };
  ASSERT_TRUE(mesh::make_panel_meshes(pattern, kH, context).ok());
  EXPECT_EQ(fractions, (std::vector<double>{0, 0.5, 1}));
}

}  // namespace
}  // namespace toile
