#include "core/body/mesh_import/repair.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

#include "core/body/mesh_import/load.h"
#include "tests/core/body/mesh_checks.h"

namespace toile {
namespace {

/// A closed cube of edge `size` from `low`, twelve triangles that look outward.
geometry::TriangleMesh cube(double size = 1, Vec3 low = {}) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(low + Vec3{i & 1 ? size : 0, i & 2 ? size : 0, i & 4 ? size : 0});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A ball of 20·4^n triangles around `middle`, from an icosahedron.
geometry::TriangleMesh ball(double radius, int n, Vec3 middle = {}) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  geometry::TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int round = 0; round < n; ++round) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto half = [&](Index a, Index b) {
      const auto [at, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<Index>(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) * 0.5);
      return at->second;
    };
    std::vector<Tri> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Index ab = half(a, b), bc = half(b, c), ca = half(c, a);
      for (const Tri& t : {Tri{a, ab, ca}, Tri{ab, b, bc}, Tri{ca, bc, c}, Tri{ab, bc, ca}})
        finer.push_back(t);
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& p : mesh.vertices) p = middle + normalized(p) * radius;
  return mesh;
}

void add(geometry::TriangleMesh& mesh, const geometry::TriangleMesh& other) {
  const auto first = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Tri& t : other.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void turn(geometry::TriangleMesh& mesh) {
  for (Tri& t : mesh.triangles) std::swap(t[1], t[2]);
}

void expect_closed(const mesh_import::RepairedMesh& r, double wanted_volume) {
  EXPECT_EQ(open_edges(r.mesh), 0);
  EXPECT_TRUE(fans_are_whole(r.mesh));
  EXPECT_NEAR(volume(r.mesh), wanted_volume, 1e-9);
  EXPECT_EQ(r.repairs.open_shells, 0);
  EXPECT_EQ(r.repairs.open_borders, 0);
}

bool says(const mesh_import::RepairedMesh& r, const std::string& words) {
  for (const std::string& sentence : mesh_import::repair_words(r.repairs)) {
    if (sentence.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(RepairMesh, LeavesAMeshInOrderAsItIs) {
  for (const geometry::TriangleMesh& mesh : {cube(), ball(0.5, 2)}) {
    const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
    EXPECT_EQ(r.mesh.vertices, mesh.vertices);
    EXPECT_EQ(r.mesh.triangles, mesh.triangles);
    EXPECT_FALSE(mesh_import::repaired(r.repairs));
    EXPECT_EQ(r.repairs.shells, 1);
    EXPECT_TRUE(mesh_import::repair_words(r.repairs).empty());
  }
}

TEST(RepairMesh, TurnsAMeshThatIsInsideOut) {
  geometry::TriangleMesh mesh = cube();
  turn(mesh);
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  expect_closed(r, 1);
  EXPECT_EQ(r.repairs.turned, 12);
  EXPECT_TRUE(says(r, "12 triangles were turned over"));
}

TEST(RepairMesh, TurnsTheTrianglesThatDisagree) {
  geometry::TriangleMesh mesh = ball(1, 2);
  const double whole = volume(mesh);
  for (const std::size_t t : {3u, 57u, 58u, 200u}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  expect_closed(r, whole);
  EXPECT_EQ(r.repairs.turned, 4);
}

TEST(RepairMesh, CountsWhatWasTurnedTwiceAsUnturned) {
  geometry::TriangleMesh mesh = cube();
  turn(mesh);
  std::swap(mesh.triangles[5][1], mesh.triangles[5][2]);  // the only one that is right
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  expect_closed(r, 1);
  EXPECT_EQ(r.repairs.turned, 11);
}

TEST(RepairMesh, JoinsBordersThatLieOnEachOther) {
  geometry::TriangleMesh mesh = cube();  // its top lid as a piece of its own, a hair above
  for (const Index v : {2, 3, 6, 7}) mesh.vertices.push_back(mesh.vertices[v] + Vec3{1e-6, 5e-6, 0});
  mesh.triangles[6] = {8, 10, 9};
  mesh.triangles[7] = {9, 10, 11};
  ASSERT_GT(open_edges(mesh), 0);
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  expect_closed(r, 1);
  EXPECT_EQ(r.repairs.welded, 4);
  EXPECT_EQ(r.mesh.vertices.size(), 8u);
  EXPECT_TRUE(says(r, "4 border points were joined"));
}

TEST(RepairMesh, DropsEmptyAndDoubledTriangles) {
  geometry::TriangleMesh mesh = cube();
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back({1, 2, 3});  // as it is
  mesh.triangles.push_back({5, 4, 6});  // the other way round
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  expect_closed(r, 1);
  EXPECT_EQ(r.repairs.flat, 1);
  EXPECT_EQ(r.repairs.doubled, 2);
  EXPECT_EQ(r.mesh.triangles, cube().triangles);
}

TEST(RepairMesh, FillsSmallHolesAndTellsHowMany) {
  geometry::TriangleMesh mesh = ball(1, 3);
  const double whole = volume(mesh);
  mesh.triangles.erase(mesh.triangles.begin() + 700);
  mesh.triangles.erase(mesh.triangles.begin() + 100,
                       mesh.triangles.begin() + 104);  // four that hang together
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_EQ(open_edges(r.mesh), 0);
  EXPECT_TRUE(fans_are_whole(r.mesh));
  EXPECT_NEAR(volume(r.mesh), whole, 0.002 * whole);
  EXPECT_EQ(r.repairs.holes, 2);
  EXPECT_EQ(r.repairs.hole_triangles, 5);
  EXPECT_EQ(r.mesh.vertices, mesh.vertices);
  EXPECT_TRUE(says(r, "2 small holes were filled with 5 triangles."));
}

TEST(RepairMesh, FillsHolesThatTouchInAPoint) {
  geometry::TriangleMesh mesh = ball(1, 3);
  const double whole = volume(mesh);
  std::vector<std::size_t> around;  // a vertex, in no order
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Tri& corners = mesh.triangles[t];
    if (std::find(corners.begin(), corners.end(), 200) != corners.end()) around.push_back(t);
  }
  ASSERT_EQ(around.size(), 6u);
  for (std::size_t k = 1; k < around.size(); ++k) {  // of each two that touch in the vertex alone
    const Tri a = mesh.triangles[around[0]], b = mesh.triangles[around[k]];
    if (std::count_if(a.begin(), a.end(), [&](Index v) { return v == b[0] || v == b[1] || v == b[2]; }) > 1)
      continue;
    geometry::TriangleMesh torn = mesh;
    torn.triangles.erase(torn.triangles.begin() + static_cast<long>(around[k]));
    torn.triangles.erase(torn.triangles.begin() + static_cast<long>(around[0]));
    const mesh_import::RepairedMesh r = mesh_import::repair_mesh(torn);
    expect_closed(r, whole);
    EXPECT_EQ(r.repairs.holes, 2);
    EXPECT_EQ(r.repairs.parted_points, 0);
  }
}

TEST(RepairMesh, FillsAHoleOfManyCornersAroundItsMiddle) {
  geometry::TriangleMesh mesh;  // a tall tube of 120 sides, its lower end shut, its upper end open
  constexpr Index kSides = 120;
  for (Index i = 0; i < kSides; ++i) {
    const double a = 2 * 3.14159265358979 * i / kSides;
    mesh.vertices.push_back({0.05 * std::cos(a), 0, -0.05 * std::sin(a)});
    mesh.vertices.push_back({0.05 * std::cos(a), 1, -0.05 * std::sin(a)});
  }
  mesh.vertices.push_back({});
  for (Index i = 0; i < kSides; ++i) {
    const Index a = 2 * i, b = 2 * ((i + 1) % kSides);
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({b, b + 1, a + 1});
    mesh.triangles.push_back({2 * kSides, b, a});
  }
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_EQ(open_edges(r.mesh), 0);
  EXPECT_EQ(r.repairs.holes, 1);
  EXPECT_EQ(r.repairs.hole_triangles, kSides);
  EXPECT_EQ(r.mesh.vertices.size(), mesh.vertices.size() + 1);
  EXPECT_NEAR(volume(r.mesh), 3.14159 * 0.0025, 1e-5);
}

TEST(RepairMesh, LeavesABowlAndASheetOpenAndSaysSo) {
  geometry::TriangleMesh bowl = ball(0.2, 3);
  std::erase_if(bowl.triangles, [&](const Tri& t) {
    return bowl.vertices[t[0]].y + bowl.vertices[t[1]].y + bowl.vertices[t[2]].y > 0;
  });
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(bowl);
  EXPECT_EQ(r.repairs.holes, 0);
  EXPECT_EQ(r.repairs.turned, 0);
  EXPECT_EQ(r.repairs.open_shells, 1);
  EXPECT_EQ(r.repairs.open_borders, 1);
  EXPECT_TRUE(says(r, "stays open: 1 border"));
  turn(bowl);
  EXPECT_EQ(mesh_import::repair_mesh(bowl).repairs.turned, static_cast<int>(bowl.triangles.size()))
      << "most of it looks inward";

  const geometry::TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}, {{0, 1, 2}, {1, 3, 2}}};
  EXPECT_EQ(mesh_import::repair_mesh(sheet).mesh.triangles, sheet.triangles) << "a sheet has no outer side";
}

TEST(RepairMesh, PartsTwoCubesThatShareAnEdge) {
  geometry::TriangleMesh mesh = cube();
  add(mesh, cube(1, {1, 1, 0}));  // vertices 8 to 15; its edge 8–12 is the first one's 3–7
  for (Tri& t : mesh.triangles) {
    for (Index& v : t) v = v == 8 ? 3 : v == 12 ? 7 : v;
  }
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_EQ(r.repairs.crowded_edges, 1);
  EXPECT_EQ(r.repairs.parted_points, 2);
  EXPECT_EQ(r.repairs.shells, 2);
  EXPECT_EQ(open_edges(r.mesh), 0);
  EXPECT_NEAR(volume(r.mesh), 2, 1e-12);
  EXPECT_TRUE(says(r, "1 edge with more than two triangles"));
  EXPECT_TRUE(says(r, "2 separate surfaces"));
}

TEST(RepairMesh, CutsAnInnerWallOff) {
  geometry::TriangleMesh mesh = cube();
  mesh.triangles.push_back({0, 3, 7});
  mesh.triangles.push_back({0, 7, 4});  // through the middle
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_GT(r.repairs.crowded_edges, 0);
  EXPECT_EQ(r.repairs.shells, 2);
  EXPECT_EQ(r.repairs.open_shells, 1) << "the wall";
  EXPECT_EQ(r.repairs.turned, 0);
  geometry::TriangleMesh outside = r.mesh;  // as the cube was
  outside.triangles.resize(12);
  EXPECT_EQ(open_edges(outside), 0);
}

TEST(RepairMesh, PartsSurfacesThatTouchInAPoint) {
  geometry::TriangleMesh mesh = cube();
  add(mesh, cube(1, {1, 1, 1}));
  for (Tri& t : mesh.triangles) {
    for (Index& v : t) v = v == 8 ? 7 : v;
  }
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_EQ(r.repairs.parted_points, 1);
  EXPECT_TRUE(fans_are_whole(r.mesh) || r.mesh.vertices.size() == 17) << "vertex 8 is unused";
  EXPECT_EQ(r.repairs.shells, 2);
}

TEST(RepairMesh, KeepsTheWallOfAHollow) {
  geometry::TriangleMesh mesh = ball(1, 2);
  geometry::TriangleMesh hollow = ball(0.5, 1);
  turn(hollow);
  add(mesh, hollow);
  EXPECT_EQ(mesh_import::repair_mesh(mesh).repairs.turned, 0);
  geometry::TriangleMesh beside = ball(1, 2);
  geometry::TriangleMesh far = ball(0.5, 1, {3, 0, 0});
  turn(far);
  add(beside, far);
  EXPECT_EQ(mesh_import::repair_mesh(beside).repairs.turned, 80) << "beside the other it is no hollow";
}

TEST(RepairMesh, LeavesATwistedStripAlone) {
  geometry::TriangleMesh mesh;
  constexpr Index kParts = 30;
  for (Index i = 0; i < kParts; ++i) {
    const double a = 2 * 3.14159265358979 * i / kParts, half = a / 2;
    for (const double w : {-0.2, 0.2}) {
      const double r = 1 + w * std::cos(half);
      mesh.vertices.push_back({r * std::cos(a), w * std::sin(half), r * std::sin(a)});
    }
  }
  for (Index i = 0; i < kParts; ++i) {
    const bool last = i + 1 == kParts;
    const Index a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({b, d, c});
  }
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_EQ(r.repairs.one_sided, 1);
  EXPECT_EQ(r.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_TRUE(says(r, "no outer side"));
}

TEST(RepairMesh, SurvivesASoupOfTriangles) {
  geometry::TriangleMesh mesh;
  std::uint64_t state = 12345;
  const auto random = [&state] {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
  };
  for (int i = 0; i < 60; ++i) {
    const auto at = [&] { return static_cast<double>(random() % 1000) / 1000; };
    mesh.vertices.push_back({at(), at(), at()});
  }
  for (int i = 0; i < 3000; ++i) {
    const auto v = [&] { return static_cast<Index>(random() % 60); };
    mesh.triangles.push_back({v(), v(), v()});
  }
  const mesh_import::RepairedMesh r = mesh_import::repair_mesh(mesh);
  EXPECT_GT(r.repairs.crowded_edges, 100);
  for (const Tri& t : r.mesh.triangles) {
    for (const Index v : t) ASSERT_LT(static_cast<std::size_t>(v), r.mesh.vertices.size());
  }
  const mesh_import::RepairedMesh again = mesh_import::repair_mesh(mesh);
  EXPECT_EQ(again.mesh.triangles, r.mesh.triangles) << "mended the same way each time";
}

TEST(RepairMesh, MendsWhatItMendedNoFurther) {
  geometry::TriangleMesh mesh = ball(1, 3);
  mesh.triangles.erase(mesh.triangles.begin() + 10, mesh.triangles.begin() + 14);
  std::swap(mesh.triangles[100][0], mesh.triangles[100][1]);
  add(mesh, cube(0.5, {2, 0, 0}));
  const mesh_import::RepairedMesh once = mesh_import::repair_mesh(mesh),
                                  twice = mesh_import::repair_mesh(once.mesh);
  EXPECT_TRUE(mesh_import::repaired(once.repairs));
  EXPECT_FALSE(mesh_import::repaired(twice.repairs));
  EXPECT_EQ(twice.mesh.triangles, once.mesh.triangles);
}

TEST(RepairMesh, KeepsScansThatCrossThemselves) {
  const char* shared = std::getenv("TOILE_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: the shared bodies were NOT looked at";
  for (const char* name : {"makehuman-female-average.obj", "garmentcode-mean_all.obj"}) {
    const Result<geometry::TriangleMesh> mesh =
        mesh_import::load_mesh(std::string(shared) + "/data/bodies/" + name);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    const mesh_import::RepairedMesh r = mesh_import::repair_mesh(*mesh);
    EXPECT_EQ(r.mesh.triangles.size(), mesh->triangles.size()) << name;
    EXPECT_EQ(r.repairs.turned, 0) << name;
    EXPECT_EQ(open_edges(r.mesh), 0) << name;
  }
}

}  // namespace
}  // namespace toile
