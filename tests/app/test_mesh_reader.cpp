// The program as the reader of its own mesh files: whatever they do to it, only the reader suffers.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/body/mesh_import/import.h"
#include "tests/app/junk.h"
#include "tests/app/napkin.h"
#include "tests/app/program.h"
#include "tests/app/serving.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

const std::string kProgram = TOILE_BINARY_DIR "/toile";

/// Objects within objects, as deep as no reader's stack is.
std::string deep_ac3d() { return "AC3Db\n" + repeated("OBJECT group\nkids 1\n", 8'000'000); }

/// A few bytes that claim two thousand million vertices.
constexpr const char* kBoast = "OFF\n2000000000 1 0\n0 0 0\n";

/// The post without its lid, and one side turned over.
constexpr const char* kTornPost =
    "v -0.1 0 -0.1\nv 0.1 0 -0.1\nv 0.1 0 0.1\nv -0.1 0 0.1\n"
    "v -0.1 0.5 -0.1\nv 0.1 0.5 -0.1\nv 0.1 0.5 0.1\nv -0.1 0.5 0.1\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 6 5 1 2\nf 2 6 7 3\nf 3 7 8 4\n";

http::HttpReply upload(const Serving& server, const std::string& name, const std::string& bytes) {
  return server.ask({.method = "POST",
                     .target = "/api/v1/bodies?name=" + name,
                     .body = bytes,
                     .content_type = "application/octet-stream",
                     .headers = {}});
}

TEST(MeshReader, IsThisProgramAndMendsWhatItReads) {
  const Result<mesh_import::RepairedMesh> here = mesh_import::MeshImporter().bytes("post.obj", kTornPost, {});
  const Result<mesh_import::RepairedMesh> there =
      mesh_import::MeshImporter(kProgram).bytes("post.obj", kTornPost, {});
  ASSERT_TRUE(here && there) << to_string(there.error());
  EXPECT_EQ(there->mesh.vertices, here->mesh.vertices);
  EXPECT_EQ(there->mesh.triangles, here->mesh.triangles);
  EXPECT_EQ(there->repairs, here->repairs);
  EXPECT_GT(here->repairs.turned, 0);
}

TEST(MeshReader, ReadsFormatsThatAreTooRiskyForTheServerItself) {
  const std::string raw = "chair\n0 0 0 1 0 0 0 1 0\n0 0 0 0 1 0 0 0 1\n";
  EXPECT_FALSE(mesh_import::MeshImporter().bytes("chair.raw", raw, {}));
  const Result<mesh_import::RepairedMesh> mesh =
      mesh_import::MeshImporter(kProgram).bytes("chair.raw", raw, {});
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->mesh.triangles.size(), 2u);
}

TEST(MeshReader, OpensNoOtherFileForAStrangersMesh) {
  const fs::path folder = fresh_folder("toile_mesh_reader");
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":36,"uri":"side.bin"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  write_text(folder / "side.bin", std::string(reinterpret_cast<const char*>(corners), sizeof corners));
  write_text(folder / "mesh.gltf", gltf);
  const mesh_import::MeshImporter importer(kProgram);
  EXPECT_TRUE(importer.file(folder / "mesh.gltf", {})) << "one's own file may name others";
  EXPECT_FALSE(importer.stored(folder / "mesh.gltf", "mesh.gltf", {}));
  const std::string absolute = (folder / "side.bin").string();
  std::string reaching = gltf;
  reaching.replace(reaching.find("side.bin"), 8, absolute);
  EXPECT_FALSE(importer.bytes("mesh.gltf", reaching, {}));
  fs::remove_all(folder);
}

/// 3 KB that are 134 million triangles: each node has the next one twice.
std::string doubling_dae() {
  constexpr int kDeep = 27;
  std::string nodes;
  for (int i = 0; i < kDeep; ++i) {
    const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
    const std::string kids = i + 1 < kDeep ? next + next : "<instance_geometry url=\"#g\"/>";
    nodes += "<node id=\"n" + std::to_string(i) + "\">" + kids + "</node>";
  }
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
    <library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>
    <technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
    <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
    <input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
    <library_nodes>)" +
         nodes +
         R"(</library_nodes><library_visual_scenes><visual_scene id="s"><node><instance_node url="#n0"/></node>
    </visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(MeshReader, RefusesASmallFileThatWantsMuchAndCountsIt) {
  const mesh_import::MeshImporter importer(kProgram);
  const Result<mesh_import::RepairedMesh> mesh = importer.bytes("bomb.dae", doubling_dae(), {});
  ASSERT_FALSE(mesh);
  EXPECT_TRUE(mesh.error().code == "mesh.memory" || mesh.error().code == "mesh.too_long" ||
              mesh.error().code == "mesh.crashed")
      << to_string(mesh.error());
  EXPECT_EQ(mesh.error().where, "bomb.dae");
  EXPECT_EQ(importer.ends().started, 1);
  EXPECT_EQ(importer.ends().refused, mesh.error().code == "mesh.too_long" ? 1 : 0);
}

TEST(MeshReader, BringsNoServerDown) {
  const fs::path folder = fresh_folder("toile_mesh_reader");
  fs::create_directories(folder / "empty");
  Serving server(folder / "data", {"--sample", (folder / "empty").string(), "--workers", "1"});
  ASSERT_TRUE(server.up()) << server.said();
  const http::HttpReply deep = upload(server, "deep.ac", deep_ac3d());
  EXPECT_EQ(deep.status, 422);
  EXPECT_NE(deep.body.find("mesh.crashed"), std::string::npos) << deep.body;
  EXPECT_NE(deep.body.find("deep.ac"), std::string::npos) << deep.body;
#ifndef __SANITIZE_THREAD__  // which has no limit of memory: the reader goes on until its time is up
  const http::HttpReply boast = upload(server, "boast.off", kBoast);
  EXPECT_EQ(boast.status, 422);
  EXPECT_TRUE(boast.body.find("mesh.memory") != std::string::npos ||
              boast.body.find("mesh.crashed") != std::string::npos)  // AddressSanitizer ends at once
      << boast.body;
#endif
  const http::HttpReply good = upload(server, "post.obj", kTornPost);
  EXPECT_EQ(good.status, 201) << good.body;
  EXPECT_NE(good.body.find("turned over, to look outward"), std::string::npos) << good.body;
  EXPECT_NE(good.body.find("\"closed\": false"), std::string::npos) << good.body;
  EXPECT_EQ(server.end(SIGTERM), 0);
  fs::remove_all(folder);
}

TEST(MeshReader, ServesTheCommandLineAsWell) {
  const fs::path folder = napkin_folder("toile_mesh_reader", "post.obj", "deep.ac");
  write_text(folder / "deep.ac", deep_ac3d());
  const Ran run = run_toile({"check", folder / "project.json"});
  EXPECT_EQ(run.signal, 0);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("mesh.crashed"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("/bodies/0/file"), std::string::npos) << run.err;
  write_text(folder / "project.json", kNapkin);
  write_text(folder / "post.obj", kTornPost);
  const Ran mended = run_toile({"check", folder / "project.json"});
  EXPECT_EQ(mended.code, 0) << mended.err;
  EXPECT_NE(mended.out.find("body post: 2 triangles were turned over"), std::string::npos) << mended.out;
  fs::remove_all(folder);
}

TEST(LongMeshReader, TakesEveryModelOfAssimpsTestsOrSaysWhyNot) {
  const fs::path models = "/usr/share/assimp/models";
  if (!fs::is_directory(models))
    GTEST_SKIP() << "assimp-testmodels is not installed: its files were NOT tried";
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(models)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  const mesh_import::MeshImporter importer(kProgram);
  std::map<std::string, int> counts;
  for (const fs::path& file : files) {
    const Result<mesh_import::RepairedMesh> mesh = importer.stored(file, file.filename().string(), {});
    ++counts[mesh ? "ok" : mesh.error().code];
    if (mesh) continue;
    EXPECT_TRUE(mesh.error().code.starts_with("mesh.")) << file;
    EXPECT_NE(mesh.error().code, "mesh.reader") << file;
  }
  for (const auto& [code, count] : counts) std::printf("%5d %s\n", count, code.c_str());
  EXPECT_GT(counts["ok"], 250) << "of " << files.size();
}

}  // namespace
}  // namespace toile
