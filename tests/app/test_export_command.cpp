#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <string>

#include "server/movie/film_codec.h"
#include "tests/app/program.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class ExportCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_export_command");
    write_text(folder / movie::kFilmFile, movie::encode_film(film));
  }
  void TearDown() override { fs::remove_all(folder); }
  Ran exported(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"export", folder, "--out", folder / out};
    words.insert(words.end(), more.begin(), more.end());
    return run_toile(words);
  }
  /// Read back by a program that is not ours; null where it cannot.
  const aiScene* read(const std::string& name, unsigned how = aiProcess_JoinIdenticalVertices) {
    return importer.ReadFile((folder / name).string(), how);
  }

  movie::Film film = test::napkin_film();
  fs::path folder;
  Assimp::Importer importer;
};

unsigned triangles_of(const aiScene& scene) {
  unsigned count = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) count += scene.mMeshes[m]->mNumFaces;
  return count;
}

aiVector3D upper_corner(const aiScene& scene) {
  aiVector3D most(-1e9f, -1e9f, -1e9f);
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned v = 0; v < scene.mMeshes[m]->mNumVertices; ++v) {
      const aiVector3D& p = scene.mMeshes[m]->mVertices[v];
      most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
  return most;
}

TEST_F(ExportCommand, EveryFormatIsReadBackByAssimpWithAllTriangles) {
  Vec3 most = film.end.front();
  for (const Vec3& p : film.end) most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.dae"}) {
    const Ran run = exported(name);
    ASSERT_EQ(run.code, 0) << run.err;
    const aiScene* scene = read(name);
    ASSERT_TRUE(scene) << name << ": " << importer.GetErrorString();
    EXPECT_EQ(triangles_of(*scene), film.garment.triangles.size()) << name;
    const float per_metre = std::string(name) == "a.stl" ? 1000 : 1;
    const aiVector3D corner = upper_corner(*scene);
    EXPECT_NEAR(corner.x, most.x * per_metre, 1e-4 * per_metre) << name;
    EXPECT_NEAR(corner.y, most.y * per_metre, 1e-4 * per_metre) << name;
    EXPECT_NEAR(corner.z, most.z * per_metre, 1e-4 * per_metre) << name;
  }
}

TEST_F(ExportCommand, AnObjHasItsMaterialsBesideIt) {
  const Ran run = exported("gown.obj");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("gown.mtl"), std::string::npos) << run.out;
  EXPECT_NE(text_of(folder / "gown.obj").find("mtllib gown.mtl"), std::string::npos);
  EXPECT_NE(text_of(folder / "gown.mtl").find("newmtl"), std::string::npos);
}

TEST_F(ExportCommand, BodiesComeWhenAskedForAndUnitsAreScaled) {
  ASSERT_EQ(exported("cloth.ply").code, 0);
  ASSERT_EQ(exported("both.ply", {"--body", "--unit", "cm"}).code, 0);
  const unsigned cloth = triangles_of(*read("cloth.ply"));
  const float height = upper_corner(*read("cloth.ply")).y;
  const aiScene* both = read("both.ply");
  ASSERT_TRUE(both);
  std::size_t bodies = 0;
  for (const geometry::TriangleMesh& body : film.bodies) bodies += body.triangles.size();
  EXPECT_EQ(triangles_of(*both), cloth + bodies);
  EXPECT_GE(upper_corner(*both).y, 100 * height - 1e-2f);
}

TEST_F(ExportCommand, AWeldedGarmentIsOneSurface) {
  ASSERT_EQ(exported("one.obj", {"--welded"}).code, 0);
  const aiScene* scene = read("one.obj");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->mNumMeshes, 1u);
  EXPECT_LE(triangles_of(*scene), film.garment.triangles.size());
}

TEST_F(ExportCommand, ShowsAnEarlierMomentAndRefusesOneThatNeverWas) {
  ASSERT_EQ(exported("start.ply", {"--at", "0"}).code, 0);
  const Ran late = exported("late.ply", {"--at", "1000"});
  EXPECT_EQ(late.code, 2);
  EXPECT_NE(late.err.find("export.time"), std::string::npos) << late.err;
  EXPECT_FALSE(fs::exists(folder / "late.ply"));
}

TEST_F(ExportCommand, RefusesANameThatTellsNoFormat) {
  for (const char* name : {"a", "a.xyz", "a.fbx"}) {
    const Ran run = exported(name);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(".ply, .stl, .obj, .dae"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder / name));
  }
}

}  // namespace
}  // namespace toile
