// Frames of the stream. Two bytes before the message count the numbers of the frame before it.

#include <cstring>

#include "proto/cpp/frame_codec.h"
#include "tests/fuzz/fuzz.h"
#include "tests/proto/golden_frames.h"

namespace toile::fuzz {
namespace {

std::string with_count(std::size_t numbers, const std::string& message) {
  const auto count = static_cast<std::uint16_t>(numbers);
  std::string input(2, '\0');
  std::memcpy(input.data(), &count, 2);
  return input + message;
}

}  // namespace

std::vector<std::string> seeds() {
  std::vector<std::string> all;
  for (const GoldenFrame& golden : golden_frames())
    if (golden.before.size() < 0xFFFF) all.push_back(with_count(golden.before.size(), golden.bytes));
  for (const RefusedMessage& refused : refused_messages("refused_frames"))
    all.push_back(with_count(refused.before.size(), refused.bytes));
  return all;
}

void try_input(std::string_view bytes) {
  if (bytes.size() < 2) return;
  std::uint16_t count = 0;
  std::memcpy(&count, bytes.data(), 2);
  std::vector<std::int16_t> before(count);
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = static_cast<std::int16_t>(i * 37);
  const std::string_view message = bytes.substr(2);
  const Result<proto::DecodedFrame> frame = proto::decode_frame(message, before);
  if (!frame) return;
  expect(frame->key || frame->grid.size() == before.size(), "a delta is as long as the frame before it");
  const std::string key = proto::encode_key(frame->header, frame->grid);
  expect(proto::decode_frame(key, {})->grid == frame->grid, "what is written is read again");
}

}  // namespace toile::fuzz
