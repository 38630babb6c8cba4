// Cuts of a mesh by planes: however the triangles are found, the cut is the same.

#include "core/body/measure/mesh_cut.h"

#include <gtest/gtest.h>

#include <random>

#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

const geometry::TriangleMesh& body() {
  static const geometry::TriangleMesh mesh =
      mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  return mesh;
}

void expect_same(const measure::MeshCut& a, const measure::MeshCut& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.part, b.part);
  EXPECT_EQ(a.part_count, b.part_count);
}

TEST(PlaneCutter, CutsAsThoughItLookedAtAllTriangles) {
  const measure::PlaneCutter cutter(body());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-1, 1), height(-0.1, 1.9);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 origin{0.3 * along(random), height(random), 0.3 * along(random)};
    const Vec3 normal{along(random), along(random), along(random)};
    const measure::MeshCut cut = cutter.cut(origin, normal);
    expect_same(cut, measure::plane_cut(body(), origin, normal));
    met += cut.part_count > 0;
  }
  EXPECT_GT(met, 200);
}

TEST(PlaneCutter, FindsVerticesThatLieInThePlane) {
  const measure::PlaneCutter cutter(body());
  for (std::size_t v = 0; v < body().vertices.size(); v += 97)
    for (const Vec3 normal : {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, -2}})
      expect_same(cutter.cut(body().vertices[v], normal),
                  measure::plane_cut(body(), body().vertices[v], normal));
}

TEST(PlaneCutter, FindsNothingInAnEmptyMesh) {
  const geometry::TriangleMesh nothing;
  EXPECT_EQ(measure::PlaneCutter(nothing).cut({}, {0, 1, 0}).part_count, 0);
}

TEST(MeshCutter, AgreesWithThePlane) {
  const measure::MeshCutter level(body(), {0, 1, 0});
  for (double y = 0.003; y < 1.7; y += 0.037)
    EXPECT_EQ(level.at(y).part_count, measure::plane_cut(body(), {0, y, 0}, {0, 1, 0}).part_count) << y;
}

}  // namespace
}  // namespace toile
