// Any cloth comes through the wire as it was, and damaged messages are read or refused.

#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "tests/damage.h"
#include "tests/proto/golden_frames.h"

namespace toile {
namespace {

using Numbers = std::vector<std::int16_t>;

/// Two moments of one cloth: places anywhere, of which most move little or not at all.
struct Moments {
  Numbers before, now;
};

rc::Gen<Moments> moments() {
  const auto place = rc::gen::resize(100, rc::gen::arbitrary<std::int16_t>());
  const auto step = rc::gen::oneOf(rc::gen::just<std::int16_t>(0), rc::gen::arbitrary<std::int16_t>(), place);
  const auto vertex =
      rc::gen::container<std::vector<std::pair<std::int16_t, std::int16_t>>>(3, rc::gen::pair(place, step));
  const auto cloth =
      rc::gen::container<std::vector<std::vector<std::pair<std::int16_t, std::int16_t>>>>(vertex);
  return rc::gen::map(cloth, [](const auto& vertices) {
    Moments made;
    for (const auto& numbers : vertices) {
      for (const auto& [at, by] : numbers) {
        made.before.push_back(at);
        made.now.push_back(static_cast<std::int16_t>(at + by));
      }
    }
    return made;
  });
}

void showValue(const Moments& shown, std::ostream& out) {
  rc::show(shown.before, out);
  out << " then ";
  rc::show(shown.now, out);
}

RC_GTEST_PROP(RandomFrames, AnyClothComesBackFromItsKeyAndFromItsDelta, ()) {
  const Moments cloth = *moments();
  const proto::FrameHeader header{*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(),
                                  *rc::gen::positive<std::int32_t>(), 0.25f};
  const std::string messages[] = {proto::encode_key(header, cloth.now),
                                  proto::encode_delta(header, cloth.now, cloth.before)};
  for (const std::string& message : messages) {
    const Result<proto::DecodedFrame> frame = proto::decode_frame(message, cloth.before);
    if (!frame) RC_FAIL(to_string(frame.error()));
    RC_ASSERT(frame->grid == cloth.now);
    RC_ASSERT(frame->header.epoch == header.epoch);
    RC_ASSERT(frame->header.seq == header.seq);
    RC_ASSERT(frame->header.step == header.step);
    RC_ASSERT(frame->header.time == header.time);
  }
}

/// A garment of so many vertices, at least one.
sewing::GarmentMesh garment_of(Index vertices) {
  const auto vertex = rc::gen::inRange<Index>(0, vertices);
  const auto metres =
      rc::gen::map(rc::gen::arbitrary<std::int16_t>(), [](std::int16_t n) { return n / 1024.0; });
  sewing::GarmentMesh garment;
  for (Index v = 0; v < vertices; ++v) garment.rest.push_back({*metres, *metres});
  garment.triangles = *rc::gen::container<std::vector<Tri>>(rc::gen::container<Tri>(vertex));
  garment.sewn = *rc::gen::container<std::vector<std::array<Index, 2>>>(
      rc::gen::container<std::array<Index, 2>>(vertex));
  return garment;
}

RC_GTEST_PROP(RandomFrames, AnyGarmentComesBackFromItsTopology, ()) {
  const sewing::GarmentMesh garment = garment_of(*rc::gen::inRange<Index>(1, 400));
  const Index first = *rc::gen::inRange<Index>(0, garment.vertex_count());
  const std::vector<proto::StreamPiece> pieces{
      {*rc::gen::string<std::string>(), first, garment.vertex_count() - first, {1, 0.5, 0.25}}};
  const auto read = proto::decode_topology(proto::encode_topology(7, {}, garment, pieces));
  if (!read) RC_FAIL(to_string(read.error()));
  RC_ASSERT(read->rest == garment.rest);  // multiples of 2⁻¹⁰: float32 holds them
  RC_ASSERT(read->triangles == garment.triangles);
  RC_ASSERT(read->sewn == garment.sewn);
  RC_ASSERT(read->pieces.size() == 1u);
  RC_ASSERT(read->pieces[0].id == pieces[0].id);
  RC_ASSERT(read->pieces[0].first_vertex == first);
}

/// The bytes alone on the heap, so that a sanitizer sees a read past either end.
class Alone {
 public:
  explicit Alone(const std::string& bytes) : size_(bytes.size()), bytes_(new char[bytes.size()]) {
    std::memcpy(bytes_.get(), bytes.data(), size_);
  }
  std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::size_t size_;
  std::unique_ptr<char[]> bytes_;
};

bool is_frame_error(const Error& error) {
  return error.code == "frame.malformed" || error.code == "frame.version" || error.code == "frame.wrong_base";
}

TEST(RandomFrames, DamagedOnesAreReadOrRefusedAndNeverHarm) {
  const std::vector<GoldenFrame> goldens = golden_frames();
  int taken = 0, refused = 0;
  EXPECT_TRUE(rc::check([&] {
    const std::vector<test::Stroke> strokes = *test::damage(rc::gen::arbitrary<std::uint8_t>());
    for (const GoldenFrame& golden : goldens) {
      const Alone bytes(test::struck(golden.bytes, strokes));
      const auto frame = proto::decode_frame(bytes.view(), golden.before);
      ++(frame ? taken : refused);
      if (!frame) {
        RC_ASSERT(is_frame_error(frame.error()));
        continue;
      }
      RC_ASSERT(std::isfinite(frame->header.time));
      RC_ASSERT(frame->grid.size() % 3 == 0u);
      RC_ASSERT(frame->grid.size() * sizeof(std::int16_t) <= 40 * bytes.view().size());
    }
  }));
  EXPECT_GT(20 * taken, refused) << "hardly any is read";
  EXPECT_GT(refused, taken) << "hardly any is refused";
}

void expect_vertices_that_are_there(const proto::DecodedTopology& topology) {
  const auto there = [&](Index v) { return v >= 0 && v < topology.vertex_count(); };
  for (const Tri& t : topology.triangles) RC_ASSERT(there(t[0]) && there(t[1]) && there(t[2]));
  for (const auto& pair : topology.sewn) RC_ASSERT(there(pair[0]) && there(pair[1]));
  for (const proto::StreamPiece& p : topology.pieces) {
    RC_ASSERT(p.first_vertex >= 0 && p.vertex_count >= 0);
    RC_ASSERT(p.vertex_count <= topology.vertex_count() - p.first_vertex);
  }
}

TEST(RandomFrames, DamagedTopologiesHoldOnlyVerticesThatAreThere) {
  const std::vector<GoldenTopology> goldens = golden_topologies();
  int taken = 0, refused = 0;
  EXPECT_TRUE(rc::check([&] {
    const std::vector<test::Stroke> strokes = *test::damage(rc::gen::arbitrary<std::uint8_t>());
    for (const GoldenTopology& golden : goldens) {
      const Alone bytes(test::struck(golden.bytes, strokes));
      const auto topology = proto::decode_topology(bytes.view());
      ++(topology ? taken : refused);
      if (topology) expect_vertices_that_are_there(*topology);
      if (!topology) RC_ASSERT(is_frame_error(topology.error()));
    }
  }));
  EXPECT_GT(20 * taken, refused) << "hardly any is read";
  EXPECT_GT(refused, taken) << "hardly any is refused";
}

TEST(CutFrames, AreRefusedWhereverTheyEnd) {
  for (const GoldenFrame& golden : golden_frames()) {
    for (std::size_t size = 0; size < golden.bytes.size(); ++size) {
      const Alone bytes(golden.bytes.substr(0, size));
      ASSERT_EQ(proto::decode_frame(bytes.view(), golden.before).error().code, "frame.malformed")
          << golden.file << size;
    }
  }
  for (const GoldenTopology& golden : golden_topologies()) {
    for (std::size_t size = 0; size < golden.bytes.size(); ++size) {
      const Alone bytes(golden.bytes.substr(0, size));
      ASSERT_EQ(proto::decode_topology(bytes.view()).error().code, "frame.malformed") << golden.file << size;
    }
  }
}

}  // namespace
}  // namespace toile
