#include <gtest/gtest.h>

#include "tests/proto/golden_frames.h"

namespace toile {
namespace {

/// Rest positions and colours travel as float32. Volatile because g++ 12 at -O2 drops the rounding where it
/// finds two of them side by side (its vectoriser takes double → float → double for nothing).
double as_sent(double number) {
  const volatile float sent = static_cast<float>(number);
  return sent;
}

TEST(TopologyCodec, WritesTheWorkedExampleOfTheDocumentByteForByte) {
  sewing::GarmentMesh garment;
  garment.rest = {{0, 0}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}};
  garment.triangles = {{0, 1, 2}, {1, 3, 2}};
  garment.sewn = {{0, 3}};
  const std::vector<proto::StreamPiece> pieces = {{"a", 0, 4, {1, 0.5, 0.25}}};
  const std::string bytes = bytes_of_hex(
      "544c0101"
      "01000000"
      "0000000000000000"
      "000000000000f03f"
      "0000000000000000"
      "2d431cebe2361a3f"
      "04000000"
      "02000000"
      "01000000"
      "01000000"
      "00000000"
      "00000000"
      "0000003f"
      "00000000"
      "00000000"
      "0000003f"
      "0000003f"
      "0000003f"
      "00000000"
      "04000000"
      "0000803f"
      "0000003f"
      "0000803e"
      "01"
      "61"
      "00"
      "02"
      "02"
      "02"
      "04"
      "01"
      "00"
      "06");
  EXPECT_EQ(proto::encode_topology(1, {.origin = {0, 1, 0}, .step = 1e-4}, garment, pieces), bytes);
}

TEST(TopologyCodec, WritesTheGoldenTopologies) {
  ASSERT_GE(golden_topologies().size(), 3u);
  for (const GoldenTopology& golden : golden_topologies()) {
    EXPECT_EQ(proto::encode_topology(golden.epoch, golden.grid, golden.garment, golden.pieces), golden.bytes)
        << golden.file;
  }
}

TEST(TopologyCodec, ReadsTheGoldenTopologies) {
  for (const GoldenTopology& golden : golden_topologies()) {
    const auto topology = proto::decode_topology(golden.bytes);
    ASSERT_TRUE(topology) << golden.file << ": " << to_string(topology.error());
    EXPECT_EQ(topology->epoch, golden.epoch);
    EXPECT_EQ(topology->grid.origin, golden.grid.origin);
    EXPECT_EQ(topology->grid.step, golden.grid.step);
    EXPECT_EQ(topology->triangles, golden.garment.triangles);
    EXPECT_EQ(topology->sewn, golden.garment.sewn);
    ASSERT_EQ(topology->rest.size(), golden.garment.rest.size());
    for (std::size_t v = 0; v < topology->rest.size(); ++v) {
      EXPECT_EQ(topology->rest[v],
                (Vec2{as_sent(golden.garment.rest[v].x), as_sent(golden.garment.rest[v].y)}));
    }
    ASSERT_EQ(topology->pieces.size(), golden.pieces.size());
    for (std::size_t p = 0; p < golden.pieces.size(); ++p) {
      const proto::StreamPiece &read = topology->pieces[p], &sent = golden.pieces[p];
      EXPECT_EQ(read.id, sent.id);
      EXPECT_EQ(read.first_vertex, sent.first_vertex);
      EXPECT_EQ(read.vertex_count, sent.vertex_count);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(read.colour[c], as_sent(sent.colour[c]));
    }
  }
}

TEST(TopologyCodec, RefusesTheGoldenMisfits) {
  ASSERT_GE(refused_messages("refused_topologies").size(), 20u);
  for (const RefusedMessage& refused : refused_messages("refused_topologies")) {
    const auto topology = proto::decode_topology(refused.bytes);
    ASSERT_FALSE(topology) << refused.why;
    EXPECT_EQ(topology.error().code, refused.code) << refused.why;
  }
}

TEST(TopologyCodec, CarriesIndicesThatLieFarApart) {
  sewing::GarmentMesh garment;
  garment.rest.resize(70000, {0.25, 0.5});
  garment.triangles = {{69999, 0, 35000}, {1, 69998, 2}};
  garment.sewn = {{0, 69999}, {69999, 0}};
  const auto topology = proto::decode_topology(proto::encode_topology(1, {}, garment, {}));
  ASSERT_TRUE(topology);
  EXPECT_EQ(topology->triangles, garment.triangles);
  EXPECT_EQ(topology->sewn, garment.sewn);
}

}  // namespace
}  // namespace toile
