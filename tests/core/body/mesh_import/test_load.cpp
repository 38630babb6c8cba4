#include "core/body/mesh_import/load.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>

#include "tests/core/body/mesh_checks.h"

namespace toile {
namespace {

constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

class LoadMesh : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("toile_load_mesh_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  std::string code(const std::string& name, const std::string& bytes) {
    const Result<geometry::TriangleMesh> mesh = mesh_import::load_mesh(write(name, bytes));
    return mesh ? "ok" : mesh.error().code;
  }

  std::filesystem::path folder_;
};

TEST_F(LoadMesh, CutsQuadsAndMergesCornersToAClosedCube) {
  const Result<geometry::TriangleMesh> cube = mesh_import::load_mesh(write("cube.obj", kCube));
  ASSERT_TRUE(cube) << to_string(cube.error());
  EXPECT_EQ(cube->vertices.size(), 8u);
  EXPECT_EQ(cube->triangles.size(), 12u);
  EXPECT_EQ(open_edges(*cube), 0);
  EXPECT_NEAR(volume(*cube), 1, 1e-12);
}

TEST_F(LoadMesh, ReadsAnStlWhoseTrianglesShareNoVertices) {
  const char* tetrahedron =
      "solid t\n"
      "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
      "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
      "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
      "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
      "endsolid t\n";
  const Result<geometry::TriangleMesh> mesh = mesh_import::load_mesh(write("t.stl", tetrahedron));
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->vertices.size(), 4u);
  EXPECT_EQ(open_edges(*mesh), 0);
  EXPECT_NEAR(volume(*mesh), 1.0 / 6, 1e-9);
}

TEST_F(LoadMesh, PutsEveryNodeOfASceneInItsPlace) {
  // One triangle, used twice: as it is, and mirrored and moved.
  const std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
    "nodes":[{"mesh":0},{"mesh":0,"translation":[3,0,0],"scale":[-1,1,1]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
  const Result<geometry::TriangleMesh> mesh = mesh_import::load_mesh(write("two.gltf", gltf));
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  ASSERT_EQ(mesh->triangles.size(), 2u);
  double right = 0;
  for (const Vec3& p : mesh->vertices) right = std::max(right, p.x);
  EXPECT_NEAR(right, 3, 1e-6);
  for (const Tri& t : mesh->triangles) {
    const Vec3 n =
        cross(mesh->vertices[t[1]] - mesh->vertices[t[0]], mesh->vertices[t[2]] - mesh->vertices[t[0]]);
    EXPECT_GT(n.z, 0) << "a mirrored part keeps its outer side outside";
  }
}

TEST_F(LoadMesh, TurnsAndScalesToMetresWithYUp) {
  const std::string tall = "v 0 0 0\nv 50 0 0\nv 0 0 170\nf 1 2 3\n";
  const Result<geometry::TriangleMesh> guessed =
      mesh_import::load_mesh(write("tall.obj", tall), {.z_up = true});
  ASSERT_TRUE(guessed) << to_string(guessed.error());
  EXPECT_NEAR(guessed->vertices[2].y, 1.7, 1e-9) << "170 units can only be centimetres";
  EXPECT_NEAR(guessed->vertices[2].z, 0, 1e-9);
  const Result<geometry::TriangleMesh> told =
      mesh_import::load_mesh(folder_ / "tall.obj", {.unit_in_m = 0.001});
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->vertices[2].z, 0.17, 1e-9);
}

TEST_F(LoadMesh, DropsTrianglesWithoutArea) {
  const Result<geometry::TriangleMesh> mesh = mesh_import::load_mesh(
      write("d.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 0 0 0\nf 1 2 3\nf 1 2 4\nf 1 5 3\n"));
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->triangles.size(), 1u);
  EXPECT_EQ(mesh->vertices.size(), 3u);
}

TEST_F(LoadMesh, NamesTheVertexThatIsNoNumber) {
  const Result<geometry::TriangleMesh> mesh =
      mesh_import::load_mesh(write("nan.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n"));
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.not_finite");
  EXPECT_NE(mesh.error().where.find("vertex 3"), std::string::npos) << mesh.error().where;
}

TEST_F(LoadMesh, RefusesWhatIsNoMesh) {
  EXPECT_EQ(mesh_import::load_mesh(folder_ / "missing.obj").error().code, "mesh.not_found");
  EXPECT_EQ(mesh_import::load_mesh(folder_).error().code, "mesh.not_found");
  EXPECT_EQ(code("empty.obj", ""), "mesh.empty");
  EXPECT_NE(code("text.obj", "It was a dark and stormy night.\n"), "ok");
  EXPECT_NE(code("text.stl", "It was a dark and stormy night.\n"), "ok");
  EXPECT_EQ(code("text.ply", "ply\nformat ascii 1.0\nelement vertex 99999999\n"), "mesh.unreadable");
  EXPECT_EQ(code("open.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "mesh.unreadable");
  EXPECT_EQ(code("cube.xyzzy", kCube), "mesh.unreadable");
  EXPECT_NE(code("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "ok");
  EXPECT_NE(code("faces.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n"), "ok");
  EXPECT_EQ(mesh_import::load_mesh(write("cube.obj", kCube), {.unit_in_m = -1}).error().code, "mesh.setting");
}

TEST_F(LoadMesh, RefusesFiftyMegabytesOfZeros) {
  const std::string zeros(50u << 20, '\0');
  for (const char* name : {"zeros.obj", "zeros.stl", "zeros.ply", "zeros.glb"})
    EXPECT_NE(code(name, zeros), "ok") << name;
}

TEST_F(LoadMesh, SurvivesAFileThatEndsAnywhere) {
  const std::string whole = kCube;
  for (size_t length = 1; length < whole.size(); length += 3) {
    const Result<geometry::TriangleMesh> mesh =
        mesh_import::load_mesh(write("cut.obj", whole.substr(0, length)));
    if (mesh) {
      EXPECT_LE(mesh->triangles.size(), 12u);
    }
  }
}

TEST_F(LoadMesh, RefusesMoreTrianglesThanTwoMillion) {
  // A grid of 1420 × 710 quads.
  std::string text;
  const int n = 1421, m = 711;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) text += "v " + std::to_string(i) + " " + std::to_string(j) + " 0\n";
  for (int j = 0; j + 1 < m; ++j) {
    for (int i = 0; i + 1 < n; ++i) {
      const int a = j * n + i + 1;
      text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + n + 1) + " " +
              std::to_string(a + n) + "\n";
    }
  }
  EXPECT_EQ(code("grid.obj", text), "mesh.too_large");
}

/// A flat ring of `corners` points as one face.
std::string disc(int corners, int faces = 1) {
  std::string text, face = "f";
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(k + 1);
  }
  for (int k = 0; k < faces; ++k) text += face + "\n";
  return text;
}

TEST(LoadMeshFaces, OfAFewHundredCornersAreCutAndOfManyAreRefusedByName) {
  const Result<geometry::TriangleMesh> cap = mesh_import::load_mesh_bytes("cap.obj", disc(512));
  ASSERT_TRUE(cap) << to_string(cap.error());
  EXPECT_EQ(cap->triangles.size(), 510u);
  for (const std::string& text : {disc(1001), disc(200'000), disc(999, 300)}) {
    const Result<geometry::TriangleMesh> huge = mesh_import::load_mesh_bytes("huge.obj", text);
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error().code, "mesh.huge_face");
    EXPECT_TRUE(huge.error().where.starts_with("huge.obj: face ")) << huge.error().where;
  }
}

TEST(LoadMeshBodies, ReadsTheSharedBodiesWhole) {
  const char* shared = std::getenv("TOILE_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: the shared bodies were NOT read";
  const std::pair<const char*, size_t> bodies[] = {{"garmentcode-mean_all.obj", 47500},
                                                   {"makehuman-female-average.obj", 26756},
                                                   {"makehuman-male-average.obj", 26756}};
  for (const auto& [name, triangles] : bodies) {
    const Result<geometry::TriangleMesh> mesh =
        mesh_import::load_mesh(std::filesystem::path(shared) / "data/bodies" / name);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_EQ(mesh->triangles.size(), triangles) << name;
    double high = 0;
    for (const Vec3& p : mesh->vertices) high = std::max(high, p.y);
    EXPECT_GT(high, 1.4) << name;
    EXPECT_LT(high, 2.0) << name;
  }
}

}  // namespace
}  // namespace toile
