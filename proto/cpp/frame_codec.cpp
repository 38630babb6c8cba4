#include "proto/cpp/frame_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/check.h"
#include "proto/cpp/bit_pack.h"
#include "proto/cpp/message_bytes.h"

namespace toile::proto {
namespace {

constexpr std::size_t kHeaderSize = 24;  ///< bytes before a frame's block heads
constexpr int kAxes = 3;
constexpr int kGroup = kAxes * kBlock;  ///< numbers of sixteen vertices
constexpr std::uint8_t kWidthBits = 0x1f;
constexpr std::uint8_t kAlongOrder = 0x20;  ///< head flag: numbers differ along the vertex order too

std::size_t group_count(std::size_t vertices) { return (vertices + kBlock - 1) / kBlock; }

/// A block's numbers both ways: as they are, and each less the one before it on its axis.
struct Candidates {
  std::uint16_t plain[kBlock], along[kBlock];
};

/// `previous` is the axis's last number of the block before. Numbers past `count` become zero either way.
Candidates candidates(const std::uint16_t* numbers, int count, std::uint16_t previous) {
  Candidates c;
  std::uint16_t shifted[kBlock];
  shifted[0] = previous;
  std::memcpy(shifted + 1, numbers, (kBlock - 1) * sizeof(std::uint16_t));
  for (int i = 0; i < kBlock; ++i) {
    c.plain[i] = zigzag(numbers[i]);
    c.along[i] = zigzag(static_cast<std::uint16_t>(numbers[i] - shifted[i]));
  }
  for (int i = count; i < kBlock; ++i) c.plain[i] = c.along[i] = 0;
  return c;
}

int width_of(const std::uint16_t* values) {
  std::uint16_t all = 0;
  for (int i = 0; i < kBlock; ++i) all = static_cast<std::uint16_t>(all | values[i]);
  return std::bit_width(all);
}

/// Packs a block the narrower way, plain when both are as wide; returns the bytes written.
int write_block(const std::uint16_t* numbers, int count, std::uint16_t previous, char* head, char* out) {
  const Candidates c = candidates(numbers, count, previous);
  const int plain = width_of(c.plain), along = width_of(c.along);
  const bool choose_along = along < plain;
  const int width = choose_along ? along : plain;
  *head = static_cast<char>(width | (choose_along ? kAlongOrder : 0));
  pack_block(width, choose_along ? c.along : c.plain, out);
  return packed_size(width);
}

/// What changed of sixteen vertices from vertex `first` on, axis by axis; `before` null means from zero.
/// Returns how many vertices there were. Differences wrap modulo 2¹⁶.
int read_group(std::span<const std::int16_t> grid, const std::int16_t* before, std::size_t first,
               std::uint16_t (&axis)[kAxes][kBlock]) {
  const std::size_t begin = kAxes * first;
  const int count = static_cast<int>(std::min<std::size_t>(kBlock, grid.size() / kAxes - first));
  std::uint16_t change[kGroup] = {};
  std::memcpy(change, grid.data() + begin, sizeof(std::int16_t) * kAxes * static_cast<std::size_t>(count));
  if (before != nullptr) {
    std::uint16_t base[kGroup] = {};
    std::memcpy(base, before + begin, sizeof(std::int16_t) * kAxes * static_cast<std::size_t>(count));
    for (int i = 0; i < kGroup; ++i) change[i] = static_cast<std::uint16_t>(change[i] - base[i]);
  }
  for (int i = 0; i < kBlock; ++i) {
    for (int a = 0; a < kAxes; ++a) axis[a][i] = change[kAxes * i + a];
  }
  return count;
}

std::string encode(MessageType type, const FrameHeader& header, std::span<const std::int16_t> grid,
                   const std::int16_t* before) {
  TOILE_CHECK(grid.size() % kAxes == 0);
  const std::size_t vertices = grid.size() / kAxes, groups = group_count(vertices);
  std::string out;
  out.reserve(kHeaderSize + kAxes * groups * (1 + packed_size(kMaxWidth)));
  put_prefix(out, type, header.epoch);
  put(out, header.seq);
  put(out, header.step);
  put(out, header.time);
  put(out, static_cast<std::uint32_t>(vertices));
  out.resize(out.capacity());
  char* head = out.data() + kHeaderSize;
  char* body = head + kAxes * groups;
  std::uint16_t previous[kAxes] = {}, axis[kAxes][kBlock];
  for (std::size_t g = 0; g < groups; ++g) {
    const int count = read_group(grid, before, g * kBlock, axis);
    for (int a = 0; a < kAxes; ++a) {
      body += write_block(axis[a], count, previous[a], head++, body);
      previous[a] = axis[a][kBlock - 1];
    }
  }
  out.resize(static_cast<std::size_t>(body - out.data()));
  return out;
}

/// A frame message taken apart, its sizes proved: `body` holds exactly the bytes that `heads` ask for.
struct Parts {
  FrameHeader header;
  bool key = false;
  std::size_t vertices = 0;
  std::string_view heads, body;
};

Result<Parts> take_apart(std::string_view bytes) {
  const auto type = TRY(message_type(bytes));
  if (type == MessageType::kTopology) return malformed("a frame was expected, and this is a topology");
  Parts parts;
  parts.key = type == MessageType::kKey;
  ByteReader in(bytes.substr(kPrefixSize - sizeof(parts.header.epoch)));
  parts.header.epoch = in.take<std::uint32_t>();
  parts.header.seq = in.take<std::uint32_t>();
  parts.header.step = in.take<std::int32_t>();
  parts.header.time = in.take<float>();
  parts.vertices = in.take<std::uint32_t>();
  parts.heads = in.take_bytes(kAxes * group_count(parts.vertices));
  if (!in.ok()) return malformed("the frame ends early");
  if (!std::isfinite(parts.header.time)) return malformed("the frame's time is no number");
  std::size_t size = 0;
  for (const char head : parts.heads) {
    const auto h = static_cast<std::uint8_t>(head);
    if ((h & kWidthBits) > kMaxWidth || h > (kAlongOrder | kWidthBits)) {
      return malformed("a block of the frame has no possible width");
    }
    size += static_cast<std::size_t>(packed_size(h & kWidthBits));
  }
  if (in.left() != size) return malformed("the frame is longer or shorter than its blocks");
  parts.body = in.take_bytes(size);
  return parts;
}

/// Adds what the blocks say to `grid`.
void apply(const Parts& parts, std::vector<std::int16_t>& grid) {
  const char* body = parts.body.data();
  std::uint16_t previous[kAxes] = {}, values[kBlock];
  for (std::size_t b = 0; b < parts.heads.size(); ++b) {
    const auto head = static_cast<std::uint8_t>(parts.heads[b]);
    const std::size_t a = b % kAxes, first = b / kAxes * kBlock;
    const int count = static_cast<int>(std::min<std::size_t>(kBlock, parts.vertices - first));
    unpack_block(head & kWidthBits, body, values);
    body += packed_size(head & kWidthBits);
    std::uint16_t number = previous[a];
    std::int16_t* out = grid.data() + kAxes * first + a;
    for (int i = 0; i < count; ++i, out += kAxes) {
      const std::uint16_t base = (head & kAlongOrder) != 0 ? number : 0;
      number = static_cast<std::uint16_t>(base + unzigzag(values[i]));
      *out = static_cast<std::int16_t>(static_cast<std::uint16_t>(*out) + number);
    }
    previous[a] = number;
  }
}

}  // namespace

std::string encode_key(const FrameHeader& header, std::span<const std::int16_t> grid) {
  return encode(MessageType::kKey, header, grid, nullptr);
}

std::string encode_delta(const FrameHeader& header, std::span<const std::int16_t> grid,
                         std::span<const std::int16_t> before) {
  TOILE_CHECK(grid.size() == before.size());
  return encode(MessageType::kDelta, header, grid, before.data());
}

Result<DecodedFrame> decode_frame(std::string_view bytes, std::span<const std::int16_t> before) {
  const auto parts = TRY(take_apart(bytes));
  DecodedFrame frame{.header = parts.header, .key = parts.key, .grid = {}};
  if (parts.key) {
    frame.grid.resize(kAxes * parts.vertices);
  } else if (before.size() == kAxes * parts.vertices) {
    frame.grid.assign(before.begin(), before.end());
  } else {
    return Error{"frame.wrong_base", "the delta is against a frame of another size; wait for a key",
                 "frame " + std::to_string(parts.header.seq)};
  }
  apply(parts, frame.grid);
  return frame;
}

Status FrameReader::read(std::string_view bytes) {
  const std::span<const std::int16_t> before =
      frame_ ? std::span<const std::int16_t>(frame_->grid) : std::span<const std::int16_t>();
  DecodedFrame frame = TRY(decode_frame(bytes, before));
  const FrameHeader& header = frame.header;
  const auto wrong_base = [&](std::string message) {
    return Error{"frame.wrong_base", std::move(message), "frame " + std::to_string(header.seq)};
  };
  if (header.epoch != epoch_) return wrong_base("the frame is of another epoch than the topology");
  if (!frame.key && (!frame_ || header.seq != frame_->header.seq + 1)) {
    return wrong_base("the delta does not follow the frame before; wait for a key");
  }
  if (frame.grid.size() != kAxes * static_cast<std::size_t>(vertex_count_)) {
    return malformed("the frame has not the topology's number of vertices");
  }
  frame_ = std::move(frame);
  return {};
}

}  // namespace toile::proto
