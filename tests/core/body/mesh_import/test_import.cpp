#include "core/body/mesh_import/import.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/body/mesh_import/message.h"
#include "tests/core/body/mesh_checks.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// A cube with one lid turned over and another missing.
constexpr const char* kSentCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 4 8 5\n";

/// A program that stands in for the reader of another process, and does what the script says.
class ImportMesh : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("toile_import_mesh_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return (folder_ / name).string();
  }
  mesh_import::MeshImporter played_by(const std::string& script) {
    const std::string path = write("reader.sh", "#!/bin/sh\n" + script + "\n");
    ::chmod(path.c_str(), 0700);
    ChildLimits limits = mesh_import::mesh_import_limits();
    limits.memory_bytes = std::uint64_t{256} << 20;
    limits.cpu_s = 1;
    limits.wall_s = 0.5;
    limits.output_bytes = 1 << 20;
    return mesh_import::MeshImporter(path, limits);
  }
  Error error_of(const std::string& script) {
    const Result<mesh_import::RepairedMesh> mesh = played_by(script).bytes("given.obj", kSentCube, {});
    return mesh ? Error{"ok", "", ""} : mesh.error();
  }

  fs::path folder_;
};

TEST_F(ImportMesh, ReadsAndMendsInThisProcessWithoutAReader) {
  const mesh_import::MeshImporter here;
  const std::string path = write("cube.obj", kSentCube);
  for (const Result<mesh_import::RepairedMesh>& mesh :
       {here.file(path, {}), here.bytes("cube.obj", kSentCube, {}), here.stored(path, "cube.obj", {})}) {
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_EQ(mesh->repairs.turned, 2);
    EXPECT_EQ(open_edges(mesh->mesh), 0);
    EXPECT_NEAR(volume(mesh->mesh), 1, 1e-12);
  }
}

TEST_F(ImportMesh, TakesWhatTheReaderSends) {
  const Result<mesh_import::RepairedMesh> mesh = mesh_import::MeshImporter().bytes("cube.obj", kSentCube, {});
  const std::string path = write("message", mesh_import::mesh_message(mesh));
  const Result<mesh_import::RepairedMesh> sent = played_by("cat " + path).bytes("cube.obj", kSentCube, {});
  ASSERT_TRUE(sent) << to_string(sent.error());
  EXPECT_EQ(sent->mesh.vertices, mesh->mesh.vertices);
  EXPECT_EQ(sent->mesh.triangles, mesh->mesh.triangles);
  EXPECT_EQ(sent->repairs, mesh->repairs);
}

TEST_F(ImportMesh, GivesTheReaderTheBytesAndTheSettings) {
  const std::string script =
      "read first; text=\"$* [$first]\"; printf 'TOILEMSH\\0\\0\\0\\0\\0\\0\\0\\0'"
      "; for part in mesh.unreadable \"$text\" here; do printf \"\\\\$(printf %o ${#part})\\\\0\\\\0\\\\0\"; "
      "printf %s \"$part\"; done";
  const Result<mesh_import::RepairedMesh> mesh =
      played_by(script).bytes("given.obj", kSentCube, {.unit_in_m = 0.01, .z_up = true});
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.unreadable");
  EXPECT_EQ(mesh.error().message, "import-mesh bytes given.obj 0.01 z [v 0 0 0]");
  EXPECT_EQ(mesh.error().where, "here");
}

TEST_F(ImportMesh, TellsOfAReaderThatCrashes) {
  const Error error = error_of("kill -SEGV $$");
  EXPECT_EQ(error.code, "mesh.crashed");
  EXPECT_EQ(error.where, "given.obj");
  EXPECT_NE(error.message.find("signal 11"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("export it anew"), std::string::npos) << error.message;
  EXPECT_EQ(error_of("kill -ABRT $$").code, "mesh.crashed");
}

TEST_F(ImportMesh, TellsOfAReaderThatHangs) {
  EXPECT_EQ(error_of("exec sleep 1000").code, "mesh.too_long");
  EXPECT_EQ(error_of("while :; do :; done").code, "mesh.too_long");
}

TEST_F(ImportMesh, EndsAReaderForWhichNobodyWaits) {
  const std::atomic<bool> cancel{true};
  const Result<mesh_import::RepairedMesh> mesh =
      played_by("exec sleep 1000").bytes("given.obj", kSentCube, {}, &cancel);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.cancelled");
  EXPECT_EQ(mesh.error().kind, ErrorKind::kCancelled);
  EXPECT_EQ(mesh.error().where, "given.obj");
}

TEST_F(ImportMesh, TellsOfAReaderThatEatsMemory) {
  const Error error = error_of("x=aaaaaaaaaaaaaaaa; while :; do x=$x$x; done; echo never");
  EXPECT_TRUE(error.code == "mesh.crashed" || error.code == "mesh.too_long") << to_string(error);
}

TEST_F(ImportMesh, TellsOfAReaderThatFloodsItsOutput) {
  EXPECT_EQ(error_of("exec cat /dev/zero").code, "mesh.too_large");
}

TEST_F(ImportMesh, TellsOfAReaderThatTalksNonsense) {
  EXPECT_EQ(error_of("exit 0").code, "mesh.crashed");
  EXPECT_EQ(error_of("exit 7").code, "mesh.crashed");
  EXPECT_EQ(error_of("echo hello").code, "mesh.crashed");
  EXPECT_EQ(error_of("printf 'TOILEMSH\\1\\0\\0\\0'").code, "mesh.crashed");
}

TEST_F(ImportMesh, SaysThatTheReaderIsMissing) {
  const Result<mesh_import::RepairedMesh> mesh =
      mesh_import::MeshImporter("/no/such/reader").bytes("a.obj", kSentCube, {});
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.reader");
  EXPECT_EQ(mesh.error().where, "a.obj");
}

TEST_F(ImportMesh, ServesManyThreadsTwoAtATime) {
  const std::string path = write(
      "message", mesh_import::mesh_message(mesh_import::MeshImporter().bytes("cube.obj", kSentCube, {})));
  const mesh_import::MeshImporter importer = played_by("cat " + path);
  std::atomic<int> good{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 6; ++i) {
    threads.emplace_back([&] { good += importer.bytes("cube.obj", kSentCube, {}).ok(); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 6);
}

TEST(ImportMeshLimits, ASmallFileMayTakeLittleAndALargeOneNoMoreThanAny) {
#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "this build is slow, and every file may take all: NOT tried";
#endif
  const ChildLimits most{.memory_bytes = std::uint64_t{3} << 30, .cpu_s = 30, .wall_s = 90};
  const ChildLimits small = mesh_import::limits_for(most, 6500);
  EXPECT_LT(small.cpu_s, 0.9) << "told within a second";
  EXPECT_LT(small.memory_bytes, std::uint64_t{600} << 20);
  const ChildLimits large = mesh_import::limits_for(most, std::uint64_t{200} << 20);
  EXPECT_EQ(large.cpu_s, most.cpu_s);
  EXPECT_EQ(large.memory_bytes, most.memory_bytes);
  EXPECT_EQ(large.wall_s, most.wall_s);
}

TEST(MeshMessage, ComesBackAsItWasSent) {
  const Result<mesh_import::RepairedMesh> mesh = mesh_import::MeshImporter().bytes("cube.obj", kSentCube, {});
  const Result<mesh_import::RepairedMesh> back =
      mesh_import::parse_mesh_message(mesh_import::mesh_message(mesh));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->mesh.vertices, mesh->mesh.vertices);
  EXPECT_EQ(back->repairs, mesh->repairs);
  const Error error{"mesh.unreadable", "Words.", "a.obj: vertex 3"};
  const Result<mesh_import::RepairedMesh> told =
      mesh_import::parse_mesh_message(mesh_import::mesh_message(error));
  ASSERT_FALSE(told);
  EXPECT_EQ(to_string(told.error()), to_string(error));
}

TEST(MeshMessage, IsRefusedWhenItIsCutOrChangedAnywhere) {
  const std::string whole =
      mesh_import::mesh_message(mesh_import::MeshImporter().bytes("cube.obj", kSentCube, {}));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(mesh_import::parse_mesh_message(whole.substr(0, length))) << length;
  }
  EXPECT_FALSE(mesh_import::parse_mesh_message(whole + "x"));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(0xff);
    const Result<mesh_import::RepairedMesh> mesh = mesh_import::parse_mesh_message(changed);
    if (!mesh) continue;
    for (const Tri& t : mesh->mesh.triangles) {
      for (const Index v : t) ASSERT_LT(static_cast<std::size_t>(v), mesh->mesh.vertices.size());
    }
    for (const Vec3& p : mesh->mesh.vertices) ASSERT_TRUE(is_finite(p));
  }
}

TEST(MeshMessage, WithMoreRepairsThanCanBeCountedIsRefused) {
  std::string message =
      mesh_import::mesh_message(mesh_import::MeshImporter().bytes("cube.obj", kSentCube, {}));
  message[15] =
      static_cast<char>(0x80);  // the highest byte of the first count, behind the opening and the kind
  EXPECT_FALSE(mesh_import::parse_mesh_message(message));
}

TEST(MeshMessage, OfNoTrianglesIsRefused) {
  mesh_import::RepairedMesh mesh;
  EXPECT_EQ(mesh_import::parse_mesh_message(mesh_import::mesh_message(mesh)).error().code, "mesh.crashed");
  mesh.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(mesh_import::parse_mesh_message(mesh_import::mesh_message(mesh)).error().code, "mesh.crashed");
}

TEST(MeshMessage, CarriesWhatAnErrorMeansAndNoKindThatIsNone) {
  for (const ErrorKind kind :
       {ErrorKind::kInput, ErrorKind::kTooLarge, ErrorKind::kSystem, ErrorKind::kInternal}) {
    EXPECT_EQ(mesh_import::parse_mesh_message(mesh_import::mesh_message(Error{"mesh.x", "", "", kind}))
                  .error()
                  .kind,
              kind);
  }
  const auto beyond = static_cast<ErrorKind>(static_cast<int>(ErrorKind::kInternal) + 1);
  const Error refused =
      mesh_import::parse_mesh_message(mesh_import::mesh_message(Error{"mesh.x", "", "", beyond})).error();
  EXPECT_EQ(refused.code, "mesh.crashed");
}

TEST(MeshMessage, TakesNoStrangeCodesFromAReader) {
  EXPECT_EQ(
      mesh_import::parse_mesh_message(mesh_import::mesh_message(Error{"store.full", "", ""})).error().code,
      "mesh.crashed");
  EXPECT_EQ(
      mesh_import::parse_mesh_message(mesh_import::mesh_message(Error{"mesh.<b>", "", ""})).error().code,
      "mesh.crashed");
  const Error long_one{"mesh.unreadable", std::string(5000, 'x') + "\x1b[31m", "a\nb"};
  const Error back = mesh_import::parse_mesh_message(mesh_import::mesh_message(long_one)).error();
  EXPECT_LE(back.message.size(), 1000u);
  EXPECT_EQ(back.where, "a b");
}

}  // namespace
}  // namespace toile
