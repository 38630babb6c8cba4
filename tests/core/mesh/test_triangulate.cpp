#include "core/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/units.h"
#include "core/mesh/quality.h"
#include "core/mesh/topology.h"
#include "tests/core/mesh/shapes.h"

namespace toile {
namespace {

constexpr double kH = 0.015;

mesh::FlatMesh meshed(const std::vector<mesh::Polygon>& loops, double h = kH) {
  Result<mesh::FlatMesh> mesh = mesh::triangulate(loops, h, {});
  EXPECT_TRUE(mesh.ok()) << (mesh.ok() ? "" : to_string(mesh.error()));
  return mesh.ok() ? *mesh : mesh::FlatMesh{};
}

/// What every mesh must fulfil: covers the piece, same topology, all given points, nothing else on the
/// border.
void expect_sound(const mesh::FlatMesh& mesh, const std::vector<mesh::Polygon>& loops) {
  ASSERT_TRUE(mesh::check_manifold(mesh.triangles, static_cast<Index>(mesh.points.size())));
  const mesh::MeshQuality q = mesh::quality_of(mesh.points, mesh.triangles);
  EXPECT_EQ(q.inverted, 0);
  EXPECT_NEAR(q.area / mesh::enclosed_area(loops), 1, 1e-9);
  EXPECT_EQ(mesh::euler_characteristic(mesh.triangles, static_cast<Index>(mesh.points.size())),
            2 - static_cast<Index>(loops.size()));
  std::size_t i = 0;
  for (const mesh::Polygon& loop : loops) {
    for (const Vec2 p : loop) EXPECT_EQ(mesh.points[mesh.border[i++]], p);
  }
  EXPECT_EQ(i, mesh.border.size());
  const mesh::BoundaryLoops border =
      mesh::boundary_loops(mesh::edges_of(mesh.triangles, static_cast<Index>(mesh.points.size())));
  EXPECT_EQ(border.count(), static_cast<Index>(loops.size()));
  EXPECT_EQ(std::set<Index>(border.vertices.begin(), border.vertices.end()),
            std::set<Index>(mesh.border.begin(), mesh.border.end()));
}

/// Homogeneous triangles near the wanted edge length.
void expect_even(const mesh::FlatMesh& mesh, double h, double least_degrees) {
  const mesh::MeshQuality q = mesh::quality_of(mesh.points, mesh.triangles);
  EXPECT_GE(degrees_from_radians(q.min_angle), least_degrees);
  EXPECT_NEAR(q.mean_edge, h, 0.1 * h);
  int inner = 0, good = 0;
  for (const mesh::MeshEdge& e : mesh::edges_of(mesh.triangles, static_cast<Index>(mesh.points.size()))) {
    if (e.t1 == kNone) continue;
    const double l = length(mesh.points[e.v1] - mesh.points[e.v0]);
    ++inner;
    good += l >= 0.6 * h && l <= 1.5 * h;
  }
  EXPECT_GE(good, 0.95 * inner);
}

/// Particles against the area that each stands for; a border particle stands for half as much.
double density(const mesh::FlatMesh& mesh, const std::vector<mesh::Polygon>& loops, double h) {
  return (static_cast<double>(mesh.points.size()) - 0.5 * static_cast<double>(mesh.border.size())) /
         mesh::particle_estimate(mesh::enclosed_area(loops), h);
}

TEST(Triangulate, ASquareGetsEvenTriangles) {
  const std::vector<mesh::Polygon> loops{sampled(rectangle(0.3, 0.3), kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 28);
  EXPECT_NEAR(density(mesh, loops, kH), 1, 0.05);
}

TEST(Triangulate, ATurnedRectangleIsAsGoodAsAnUprightOne) {
  mesh::Polygon corners = rectangle(0.5, 0.703);
  for (Vec2& p : corners) p = {p.x * 0.8 - p.y * 0.6, p.x * 0.6 + p.y * 0.8};
  const std::vector<mesh::Polygon> loops{sampled(corners, kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 27);
  EXPECT_NEAR(density(mesh, loops, kH), 1, 0.03);
}

TEST(Triangulate, ACircleGetsEvenTriangles) {
  const std::vector<mesh::Polygon> loops{circle({0.1, -3}, 0.25, kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 27);
  EXPECT_NEAR(density(mesh, loops, kH), 1, 0.05);
}

TEST(Triangulate, AWaistbandTwoParticlesWideHasARowOfInnerVertices) {
  for (const double h : {0.015, 0.02}) {
    const std::vector<mesh::Polygon> loops{sampled(rectangle(0.7, 0.03), h)};
    const mesh::FlatMesh mesh = meshed(loops, h);
    expect_sound(mesh, loops);
    expect_even(mesh, h, 25);
    std::vector<bool> on_border(mesh.points.size(), false);
    for (const Index v : mesh.border) on_border[v] = true;
    int ears = 0;
    for (const Tri& t : mesh.triangles) ears += on_border[t[0]] && on_border[t[1]] && on_border[t[2]];
    EXPECT_LE(ears, 4) << "only the corners may be cut off";
  }
}

TEST(Triangulate, AStripNarrowerThanAParticleDistanceIsStillMeshed) {
  const std::vector<mesh::Polygon> loops{sampled(rectangle(0.7, 0.03), 0.04)};
  const mesh::FlatMesh mesh = meshed(loops, 0.04);
  expect_sound(mesh, loops);
  EXPECT_EQ(mesh.points.size(), mesh.border.size());
}

TEST(Triangulate, AnLShapeGetsEvenTriangles) {
  const std::vector<mesh::Polygon> loops{
      sampled({{0, 0}, {0.4, 0}, {0.4, 0.15}, {0.15, 0.15}, {0.15, 0.4}, {0, 0.4}}, kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 27);
}

TEST(Triangulate, ASkirtPanelGetsEvenTriangles) {
  const std::vector<mesh::Polygon> loops{ring_sector(0.2, 0.75, 0.3, 2.2, kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 25);
  EXPECT_NEAR(density(mesh, loops, kH), 1, 0.03);
}

TEST(Triangulate, APieceWithTwoHolesKeepsThem) {
  const std::vector<mesh::Polygon> loops{sampled(rectangle(0.5, 0.3), kH),
                                         clockwise(circle({0.15, 0.15}, 0.06, kH)),
                                         clockwise(circle({0.36, 0.16}, 0.03, kH))};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 25);
}

TEST(Triangulate, SharpTipsSpoilOnlyTheTrianglesInThem) {
  const mesh::Polygon corners = star(7, 0.4, 0.1);  // tips of about 17 degrees
  const std::vector<mesh::Polygon> loops{sampled(corners, kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  expect_even(mesh, kH, 0);
  for (const Tri& t : mesh.triangles) {
    const Vec2 centre = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) * (1.0 / 3);
    double to_tip = 1;
    for (std::size_t i = 0; i < corners.size(); i += 2)
      to_tip = std::min(to_tip, length(centre - corners[i]));
    if (to_tip < 5 * kH) continue;
    EXPECT_GE(
        degrees_from_radians(mesh::least_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])), 20);
  }
}

TEST(Triangulate, ATipOfTenDegreesIsMeshed) {
  const std::vector<mesh::Polygon> loops{sampled({{0, 0}, {0.6, 0}, {0.6, 0.6 * std::tan(kPi / 18)}}, kH)};
  expect_sound(meshed(loops), loops);
}

TEST(Triangulate, ABorderDividedThreeTimesFinerIsGradedInto) {
  mesh::Polygon outline;
  for (int i = 0; i < 60; ++i) outline.push_back({0.3 * i / 60, 0});
  for (const Vec2 p : sampled(rectangle(0.3, 0.3), kH)) {
    if (p.y > 0 || p.x == 0.3) outline.push_back(p);
  }
  const std::vector<mesh::Polygon> loops{outline};
  const mesh::FlatMesh mesh = meshed(loops);
  expect_sound(mesh, loops);
  EXPECT_GE(degrees_from_radians(mesh::quality_of(mesh.points, mesh.triangles).min_angle), 20);
}

TEST(Triangulate, ATriangleOfThreePointsIsOneTriangle) {
  const std::vector<mesh::Polygon> loops{{{0, 0}, {0.01, 0}, {0, 0.01}}};
  const mesh::FlatMesh mesh = meshed(loops, 0.04);
  expect_sound(mesh, loops);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Triangulate, StaysSoundOnFiveHundredRandomStarShapedPieces) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Sequence random(seed);
    const int corners = 4 + static_cast<int>(random.next() * 30);  // no gap of half a turn
    const double h = 0.01 + 0.04 * random.next();
    mesh::Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double a = 2 * kPi * (i + 0.9 * random.next()) / corners, r = 0.03 + 0.4 * random.next();
      polygon.push_back({r * std::cos(a), r * std::sin(a)});
    }
    const std::vector<mesh::Polygon> loops{sampled(polygon, h)};
    const Result<mesh::FlatMesh> mesh = mesh::triangulate(loops, h, {});
    ASSERT_TRUE(mesh.ok()) << "seed " << seed << ": " << to_string(mesh.error());
    expect_sound(*mesh, loops);
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
}

TEST(Triangulate, AnEdgeThatRisesByRoundingErrorsAloneLeadsNoPointOutside) {
  mesh::Polygon piece;
  for (int i = 0; i < 25; ++i) piece.push_back(Vec2{-0.020680777044770469, 1.4802973661668755e-18} * i);
  const Vec2 left{-0.38901277659931882, -0.27053210433641472}, right{0, -0.0829725};
  for (int i = 0; i <= 20; ++i) piece.push_back(left + (right - left) * (i / 20.0));
  expect_sound(meshed({piece}, 0.021052288173204831), {piece});
}

TEST(Triangulate, MostTrianglesOfRandomPiecesAreWellShaped) {
  int triangles = 0, poor = 0;
  for (std::uint64_t seed = 1000; seed < 1040; ++seed) {
    Sequence random(seed);
    mesh::Polygon polygon;
    for (int i = 0; i < 12; ++i) {
      const double a = 2 * kPi * i / 12, r = 0.2 + 0.3 * random.next();
      polygon.push_back({r * std::cos(a), r * std::sin(a)});
    }
    const mesh::FlatMesh mesh = meshed({sampled(polygon, kH)});
    for (const Tri& t : mesh.triangles) {
      ++triangles;
      poor += degrees_from_radians(
                  mesh::least_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])) < 30;
    }
  }
  EXPECT_LT(poor, 0.005 * triangles);
}

TEST(Triangulate, TheSameInputGivesTheSameBytes) {
  const std::vector<mesh::Polygon> loops{sampled(star(5, 0.4, 0.2), kH)};
  const mesh::FlatMesh first = meshed(loops), second = meshed(loops);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.border, second.border);
}

TEST(Triangulate, AMovedPieceGetsTheSameMesh) {
  std::vector<mesh::Polygon> loops{sampled({{0, 0}, {0.4, 0.05}, {0.45, 0.3}, {0.2, 0.2}, {0.02, 0.4}}, kH)};
  for (Vec2& p : loops[0]) p = {std::round(p.x * 1e6) * 1e-6, std::round(p.y * 1e6) * 1e-6};
  const mesh::FlatMesh here = meshed(loops);
  for (Vec2& p : loops[0]) p = p + Vec2{3, -2};
  const mesh::FlatMesh there = meshed(loops);
  EXPECT_EQ(here.triangles, there.triangles);
  ASSERT_EQ(here.points.size(), there.points.size());
  for (std::size_t i = 0; i < here.points.size(); ++i) {
    EXPECT_LT(length(there.points[i] - here.points[i] - Vec2{3, -2}), 1e-9);
  }
}

TEST(Triangulate, NeighboursInThePlaneAreNeighboursInMemory) {
  const std::vector<mesh::Polygon> loops{sampled(rectangle(0.6, 0.6), kH)};
  const mesh::FlatMesh mesh = meshed(loops);
  double steps = 0;
  for (const mesh::MeshEdge& e : mesh::edges_of(mesh.triangles, static_cast<Index>(mesh.points.size()))) {
    steps += std::abs(e.v0 - e.v1) < 64;
  }
  EXPECT_GT(steps, 0.7 * static_cast<double>(mesh.triangles.size()) * 1.5);
}

std::string code_of(const std::vector<mesh::Polygon>& loops, double h = kH) {
  const Result<mesh::FlatMesh> mesh = mesh::triangulate(loops, h, {});
  return mesh.ok() ? "" : mesh.error().code;
}

TEST(Triangulate, RefusesAnOutlineThatCrossesItself) {
  EXPECT_EQ(code_of({sampled({{0, 0}, {0.3, 0.3}, {0.3, 0}, {0, 0.2}}, kH)}), "mesh.outline_crosses");
  // A figure of eight whose areas cancel, at a distance that would fill it with a billion points.
  EXPECT_EQ(code_of({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}, 5e-4), "mesh.outline_crosses");
}

TEST(Triangulate, RefusesAnOutlineWithoutArea) {
  EXPECT_EQ(code_of({{{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}}}), "mesh.zero_area");
  EXPECT_EQ(code_of({{{0, 0}, {0.1, 0.1}, {0.2, 0.2}, {0.1, 0.1}}}), "mesh.zero_area");
}

TEST(Triangulate, RefusesAnOutlineThatTouchesItself) {
  EXPECT_EQ(code_of({{{0, 0}, {0.1, 0.1}, {0.2, 0}, {0.2, 0.2}, {0.1, 0.1}, {0, 0.2}}}),
            "mesh.outline_touches");
  EXPECT_EQ(code_of({{{0, 0}, {0.2, 0}, {0.2, 0.2}, {0.1, 0}, {0, 0.2}}}), "mesh.outline_touches");
}

TEST(Triangulate, RefusesWrongWindingAndHolesOutside) {
  EXPECT_EQ(code_of({clockwise(sampled(rectangle(0.3, 0.3), kH))}), "mesh.outline_winding");
  EXPECT_EQ(code_of({sampled(rectangle(0.3, 0.3), kH), circle({0.15, 0.15}, 0.05, kH)}),
            "mesh.outline_winding");
  EXPECT_EQ(code_of({sampled(rectangle(0.3, 0.3), kH), clockwise(circle({0.6, 0.15}, 0.05, kH))}),
            "mesh.outline_winding");
}

TEST(Triangulate, RefusesWhatIsNoPiece) {
  EXPECT_EQ(code_of({}), "mesh.too_few_points");
  EXPECT_EQ(code_of({{{0, 0}, {1, 0}}}), "mesh.too_few_points");
  EXPECT_EQ(code_of({{{0, 0}, {1, 0}, {0, std::nan("")}}}), "mesh.not_finite");
  EXPECT_EQ(code_of({rectangle(30, 0.1)}), "mesh.piece_too_large");
  EXPECT_EQ(code_of({rectangle(3, 3)}, 1e-3), "mesh.too_many_particles");
}

TEST(Triangulate, StopsWhenCancelled) {
  const std::atomic<bool> cancel{true};
  RunContext context;
  context.cancel = &cancel;
  const auto mesh =
      mesh::triangulate(std::vector<mesh::Polygon>{sampled(rectangle(0.3, 0.3), kH)}, kH, context);
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().code, "cancelled");
}

}  // namespace
}  // namespace toile
