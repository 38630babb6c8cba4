#pragma once
// The stream of moving cloth as bytes. The layout stands in proto/frames.md; proto/ts has the same in
// TypeScript, and proto/fixtures the golden bytes that both must read and write.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/sewing/garment_mesh.h"

namespace toile::proto {

/// Third byte of a message.
enum class MessageType : std::uint8_t { kTopology = 1, kKey = 2, kDelta = 3 };

/// What a binary message is, from its first bytes. Errors: frame.malformed, frame.version.
Result<MessageType> message_type(std::string_view bytes);

/// Grid on which positions travel: metres = origin + step · int16.
struct FrameGrid {
  Vec3 origin;
  double step = 1e-4;  ///< m
};

/// A grid that holds `lo` to `hi` and 1 m more on every side, for the cloth to fall and swing: 0.1 mm unless
/// the bounds are too wide.
FrameGrid grid_for(Vec3 lo, Vec3 hi);

/// Positions on the grid, three numbers a vertex, each the nearest and clamped to int16 (what is no number:
/// the origin).
std::vector<std::int16_t> quantise(std::span<const Vec3> positions, const FrameGrid& grid);
/// Back to metres. REQUIRES three numbers a vertex.
std::vector<Vec3> dequantise(std::span<const std::int16_t> numbers, const FrameGrid& grid);

/// Pieces as viewers show them.
struct StreamPiece {
  std::string id;
  Index first_vertex = 0, vertex_count = 0;
  std::array<double, 3> colour{};  ///< linear RGB
};

/// Topology message: grid, pieces, triangles, rest positions (m, float32), sewn pairs.
std::string encode_topology(std::uint32_t epoch, const FrameGrid& grid, const sewing::GarmentMesh& garment,
                            std::span<const StreamPiece> pieces);

/// A topology message, read.
struct DecodedTopology {
  std::uint32_t epoch = 1;
  FrameGrid grid;
  std::vector<StreamPiece> pieces;
  std::vector<Vec2> rest;  ///< m, flat, one a vertex
  std::vector<Tri> triangles;
  std::vector<std::array<Index, 2>> sewn;

  Index vertex_count() const { return static_cast<Index>(rest.size()); }
};
/// Every index in the result is that of a vertex, every number finite. Memory stays within a fixed multiple
/// of the message. Errors: frame.malformed, frame.version.
Result<DecodedTopology> decode_topology(std::string_view bytes);

struct FrameHeader {
  std::uint32_t epoch = 1, seq = 0;
  std::int32_t step = 0;
  float time = 0;  ///< s
};

/// A frame by itself. REQUIRES three numbers a vertex.
std::string encode_key(const FrameHeader& header, std::span<const std::int16_t> grid);
/// A frame against the one before it (seq − 1 of the same epoch). REQUIRES the same length of both.
std::string encode_delta(const FrameHeader& header, std::span<const std::int16_t> grid,
                         std::span<const std::int16_t> before);

struct DecodedFrame {
  FrameHeader header;
  bool key = false;
  std::vector<std::int16_t> grid;
};
/// Reads a key, or a delta against `before`, of which it can only check the length: FrameReader also checks
/// epoch and order. Never reads outside `bytes`; the result takes at most 40 times their memory. Errors:
/// frame.malformed, frame.version, frame.wrong_base.
Result<DecodedFrame> decode_frame(std::string_view bytes, std::span<const std::int16_t> before);

/// One end of a stream: keeps the newest frame, and takes only what fits it.
class FrameReader {
 public:
  FrameReader(std::uint32_t epoch, Index vertex_count) : epoch_(epoch), vertex_count_(vertex_count) {}

  /// Takes a key of this epoch, or the delta that follows the frame it holds. On an error it holds what it
  /// held. Errors: frame.malformed, frame.version; frame.wrong_base for a gap or another epoch.
  Status read(std::string_view bytes);

  /// The newest frame; nothing before the first key.
  const std::optional<DecodedFrame>& frame() const { return frame_; }

 private:
  std::uint32_t epoch_;
  Index vertex_count_;
  std::optional<DecodedFrame> frame_;
};

}  // namespace toile::proto
