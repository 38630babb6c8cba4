#include "core/analysis/cloth_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/analysis/cloth_pressure.h"
#include "core/analysis/surface_curvature.h"
#include "core/base/units.h"

namespace toile::analysis {
namespace {

/// A tube around the y axis that one piece makes, whose ends are sewn: `strain` wider than it was cut, `gap`
/// outside a body of radius `radius` (m).
struct Tube {
  drape::DrapeInput input;
  drape::DrapeResult result;
};

constexpr int kAround = 60, kUp = 20;

Vec3 on_tube(double radius, int i, int j) {
  const double angle = 2 * kPi * i / kAround;
  return {radius * std::sin(angle), 0.01 * j, radius * std::cos(angle)};
}

body::Body cylinder(double radius) {
  body::Body body{"limb", {}};
  for (int j = -10; j <= kUp + 10; ++j)
    for (int i = 0; i < kAround; ++i) body.mesh.vertices.push_back(on_tube(radius, i, j));
  for (Index j = 0; j < kUp + 20; ++j) {
    for (Index i = 0; i < kAround; ++i) {
      const Index a = j * kAround + i, b = j * kAround + (i + 1) % kAround;
      body.mesh.triangles.push_back({a, b, b + kAround});
      body.mesh.triangles.push_back({a, b + kAround, a + kAround});
    }
  }
  return body;
}

Tube tube(double radius, double strain, double gap) {
  Tube t;
  t.input.pattern.panels.resize(1);
  t.input.pattern.panels[0].grain = {0, 1};
  t.input.fabrics.resize(1);
  t.input.fabrics[0].stretch_weft = 500;
  t.input.fabrics[0].stretch_coupling = 0;
  t.input.fabric_of_panel = {0};
  sewing::GarmentMesh& g = t.result.garment;
  const double side = 2 * kPi * (radius + gap) / kAround / (1 + strain);
  for (Index j = 0; j <= kUp; ++j) {
    for (Index i = 0; i <= kAround; ++i) {
      g.rest.push_back({side * i, 0.01 * j});
      t.result.positions.push_back(on_tube(radius + gap, i, j));
      const Index v = j * (kAround + 1) + i;
      g.weld.push_back(i == kAround ? v - kAround : v);
    }
  }
  for (Index j = 0; j < kUp; ++j) {
    for (Index i = 0; i < kAround; ++i) {
      const Index a = j * (kAround + 1) + i, b = a + 1, up = kAround + 1;
      g.triangles.push_back({a, b, b + up});
      g.triangles.push_back({a, b + up, a + up});
    }
  }
  g.panel_of_vertex.assign(g.rest.size(), 0);
  g.panel_of_triangle.assign(g.triangles.size(), 0);
  g.first_vertex = {0, static_cast<Index>(g.rest.size())};
  t.result.bodies = {cylinder(radius)};
  return t;
}

const ClothMap& map_of(const std::vector<ClothMap>& maps, MapKind kind) {
  for (const ClothMap& map : maps)
    if (map.kind == kind) return map;
  throw std::runtime_error("no such map");
}

/// At half the height, away from the seam and on it.
std::vector<std::size_t> middles() {
  const std::size_t row = (kAround + 1) * (kUp / 2);
  return {row, row + 7, row + 30, row + kAround};
}

TEST(ClothMap, ATubeIsCurvedAroundAndStraightAlong) {
  const Tube t = tube(0.08, 0, 0.001);
  const std::vector<SymmetricTensor> curvature = surface_curvature(t.result.garment, t.result.positions);
  for (const std::size_t v : middles()) {
    const Vec3 out = normalized(Vec3{t.result.positions[v].x, 0, t.result.positions[v].z});
    const Vec3 around = cross(Vec3{0, 1, 0}, out);
    EXPECT_NEAR(curvature[v].along(around), 1 / 0.081, 0.02 / 0.081);
    EXPECT_NEAR(curvature[v].along({0, 1, 0}), 0, 0.1);
    // The mean over two edges of 6 degrees each tilts what is around by about five: sin² of that, and no
    // more.
    EXPECT_NEAR(curvature[v].along(out), 0, 0.01 / 0.081);
  }
}

TEST(ClothMap, TurnedInsideOutItIsHollow) {
  Tube t = tube(0.08, 0, 0.001);
  for (Tri& tri : t.result.garment.triangles) std::swap(tri[1], tri[2]);
  const std::vector<SymmetricTensor> curvature = surface_curvature(t.result.garment, t.result.positions);
  for (const std::size_t v : middles()) EXPECT_NEAR(curvature[v].trace(), -1 / 0.081, 0.02 / 0.081);
}

TEST(ClothMap, PressureIsTensionOverRadius) {
  const Tube t = tube(0.08, 0.06, 0.001);
  const std::vector<ClothMap> maps = cloth_maps(t.input, t.result);
  const double known = 500 * 0.06 / 0.081 / 1000;  // kPa
  for (const std::size_t v : middles()) {
    EXPECT_NEAR(map_of(maps, MapKind::kWeft).values[v], 6, 0.2);
    EXPECT_NEAR(map_of(maps, MapKind::kWarp).values[v], 0, 0.01);
    EXPECT_NEAR(map_of(maps, MapKind::kPressure).values[v], known, 0.03 * known);
    EXPECT_NEAR(map_of(maps, MapKind::kEase).values[v], 1, 0.15);
  }
}

TEST(ClothMap, ClothThatIsLooseOrStandsOffDoesNotPress) {
  for (const auto& [strain, gap] : {std::pair{-0.05, 0.001}, std::pair{0.06, 0.01}}) {
    const Tube t = tube(0.08, strain, gap);
    const std::vector<ClothMap> maps = cloth_maps(t.input, t.result);
    for (const float value : map_of(maps, MapKind::kPressure).values) EXPECT_EQ(value, 0);
  }
}

TEST(ClothMap, WithoutABodyThereIsNothingToPressOn) {
  Tube t = tube(0.08, 0.06, 0.001);
  t.result.bodies.clear();
  std::vector<MapKind> kinds;
  for (const ClothMap& map : cloth_maps(t.input, t.result)) kinds.push_back(map.kind);
  EXPECT_EQ(kinds, (std::vector{MapKind::kWarp, MapKind::kWeft, MapKind::kShear, MapKind::kCurvature}));
}

TEST(ClothTension, IsTheFabricsLawAndNeverPushes) {
  material::Fabric fabric;
  fabric.stretch_warp = 1000;
  fabric.stretch_weft = 400;
  fabric.stretch_coupling = 0;
  fabric.stretch_shear = 200;
  const Vec3 warp{0, 1, 0}, weft{1, 0, 0};
  const SymmetricTensor pulled = cloth_tension(fabric, {0.02, 0.05, 0}, warp, weft);
  EXPECT_NEAR(pulled.along(warp), 20, 1e-9);
  EXPECT_NEAR(pulled.along(weft), 20, 1e-9);
  const SymmetricTensor sheared = cloth_tension(fabric, {0, 0, 0.1}, warp, weft);
  EXPECT_NEAR(sheared.along(normalized(warp + weft)), 20, 1e-9) << "on the bias";
  EXPECT_NEAR(sheared.along(normalized(warp - weft)), 0, 1e-9) << "and folded across it";
  EXPECT_NEAR(cloth_tension(fabric, {-0.1, -0.1, 0}, warp, weft).trace(), 0, 1e-9);
  fabric.limit_warp = 0.01;
  EXPECT_NEAR(cloth_tension(fabric, {0.5, 0, 0}, warp, weft).along(warp), 10, 1e-9) << "at its limit";
}

TEST(MapScale, IsTheSmallestThatHoldsNearlyAll) {
  ClothMap map{MapKind::kWarp, std::vector<float>(100, 1.5F)};
  map.values[0] = 35;
  EXPECT_EQ(scale_of(map).high, 2);
  EXPECT_EQ(scale_of(map).low, -2);
  map.values.assign(100, 300);
  EXPECT_EQ(scale_of(map).high, 40) << "the widest that there is";
  EXPECT_EQ(scale_of({MapKind::kWarp, {}}).high, 1);
}

TEST(MapScale, BandsRunFromBlueToRedAndTightIsRed) {
  const MapScale strain{MapKind::kWarp, -2, 2};
  EXPECT_EQ(strain.place(-9), 0);
  EXPECT_EQ(strain.place(-1.25), 1) << "the middle of the second";
  EXPECT_EQ(strain.place(0), 3.5);
  EXPECT_EQ(strain.place(9), 7);
  EXPECT_EQ(strain.bounds().front(), -2);
  const MapScale ease{MapKind::kEase, 0, 16};
  EXPECT_EQ(ease.place(0), 7);
  EXPECT_EQ(ease.place(16), 0);
  EXPECT_EQ(ease.bounds().front(), 16);
}

TEST(MapKinds, HaveAWordEach) {
  for (const MapTrait& trait : map_traits()) {
    EXPECT_EQ(*map_kind_from(trait.word), trait.kind);
    EXPECT_EQ(trait_of(trait.kind).word, trait.word);
    EXPECT_TRUE(trait.attribute.starts_with('_')) << "glTF asks for it";
  }
  EXPECT_EQ(map_kind_from("stress").error().code, "map.unknown");
}

}  // namespace
}  // namespace toile::analysis
