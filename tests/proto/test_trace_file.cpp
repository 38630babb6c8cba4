#include "proto/cpp/trace_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <iterator>
#include <string>

namespace toile {
namespace {

template <typename T>
T at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// The bytes of a trace of `frames` frames of one triangle, step 50 apart.
std::string traced(int frames, int every) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("toile_test_" + std::to_string(::getpid()) + ".trace");
  auto writer = proto::TraceWriter::open(path, every);
  EXPECT_TRUE(writer);
  sewing::GarmentMesh garment;
  garment.rest.resize(3);
  garment.triangles = {{0, 1, 2}};
  (*writer)->begin(garment);
  for (int i = 0; i < frames; ++i) {
    drape::Frame frame;
    frame.step = 50 * i;
    frame.time = 0.5 * i;
    frame.positions = {{0, 1.0 * i, 0}, {1, 0, 0}, {0, 0, 1}};
    (*writer)->frame(frame);
  }
  EXPECT_TRUE((*writer)->finish());
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

constexpr std::size_t kHeader = 8 + 16 + 12;
constexpr std::size_t kFrame = 16 + 36;

TEST(TraceFile, BeginsWithTheDocumentedHeader) {
  const std::string bytes = traced(1, 7);
  ASSERT_EQ(bytes.size(), kHeader + kFrame);
  EXPECT_EQ(bytes.substr(0, 8), "TOILETRC");
  EXPECT_EQ(at<std::uint32_t>(bytes, 8), 1u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 12), 3u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 16), 1u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 20), 7u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 32), 2u);
}

TEST(TraceFile, KeepsEveryNthFrameAndTheLast) {
  const std::string bytes = traced(6, 2);  // 0, 2, 4 and the last, 5
  ASSERT_EQ(bytes.size(), kHeader + 4 * kFrame);
  EXPECT_EQ(at<std::uint32_t>(bytes, kHeader + kFrame), 100u);
  EXPECT_EQ(at<std::uint32_t>(bytes, kHeader + 3 * kFrame), 250u);
  EXPECT_EQ(at<double>(bytes, kHeader + 3 * kFrame + 8), 2.5);
  EXPECT_EQ(at<float>(bytes, kHeader + 3 * kFrame + 16 + 4), 5.0f);
}

TEST(TraceFile, WritesTheLastFrameOnceWhenItWasKeptAnyway) {
  EXPECT_EQ(traced(5, 2).size(), kHeader + 3 * kFrame);
}

/// What it is given.
struct Taken final : drape::FrameSink {
  void begin(const sewing::GarmentMesh& garment) override { triangles = garment.triangles; }
  void frame(const drape::Frame& frame) override { frames.push_back(frame); }
  std::vector<Tri> triangles;
  std::vector<drape::Frame> frames;
};

Status read_back(const std::string& bytes, Taken& taken) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("toile_read_" + std::to_string(::getpid()) + ".trace");
  std::ofstream(path, std::ios::binary) << bytes;
  return proto::read_trace(path, taken);
}

TEST(TraceFile, IsReadUpToTheFrameInWhichItWasCutOff) {
  const std::string bytes = traced(6, 2);
  Taken whole, cut;
  ASSERT_TRUE(read_back(bytes, whole));
  ASSERT_EQ(whole.frames.size(), 4u);
  EXPECT_EQ(whole.triangles, (std::vector<Tri>{{0, 1, 2}}));
  EXPECT_EQ(whole.frames[3].step, 250);
  EXPECT_EQ(whole.frames[3].time, 2.5);
  EXPECT_EQ(whole.frames[3].positions[0].y, 5);
  ASSERT_TRUE(read_back(bytes.substr(0, bytes.size() - 1), cut));
  EXPECT_EQ(cut.frames.size(), 3u);
}

TEST(TraceFile, WhoseTrianglesHaveNoVerticesIsRefused) {
  std::string bytes = traced(1, 1);
  Taken none;
  EXPECT_EQ(read_back(bytes.substr(0, kHeader - 1), none).error().code, "trace.damaged");
  bytes[24] = 3;
  EXPECT_EQ(read_back(bytes, none).error().code, "trace.damaged");
  EXPECT_EQ(read_back("TOILETRX", none).error().code, "trace.damaged");
}

TEST(TraceFile, SaysAtOnceThatAFileCannotBeMade) {
  const auto writer = proto::TraceWriter::open("/no/such/folder/a.trace", 1);
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, "export.write");
  EXPECT_EQ(writer.error().where, "/no/such/folder/a.trace");
}

}  // namespace
}  // namespace toile
