#pragma once
// The stream of moving cloth as bytes. The layout stands in proto/frames.md; proto/ts has the same in TypeScript,
// and proto/fixtures the golden bytes that both must read and write.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/sewing/garment_mesh.h"

namespace toile {

/// Grid on which positions travel: metres = origin + step · int16.
struct FrameGrid {
  Vec3 origin;
  double step = 1e-4;  ///< m
};

/// A grid that holds `lo` to `hi` with room for the cloth to fall and swing: 0.1 mm unless the bounds are too wide.
FrameGrid grid_for(Vec3 lo, Vec3 hi);

/// Positions on the grid, three numbers a vertex, clamped to int16.
std::vector<std::int16_t> quantise(std::span<const Vec3> positions, const FrameGrid& grid);

/// Pieces as viewers show them.
struct StreamPiece {
  std::string id;
  Index first_vertex = 0, vertex_count = 0;
  std::array<double, 3> colour{};  ///< linear RGB
};

/// Topology message: grid, pieces, triangles, rest positions (m, float32), sewn pairs.
std::string encode_topology(std::uint32_t epoch, const FrameGrid& grid, const GarmentMesh& garment,
                            std::span<const StreamPiece> pieces);

struct FrameHeader {
  std::uint32_t epoch = 1, seq = 0;
  std::int32_t step = 0;
  float time = 0;  ///< s
};

/// A frame by itself.
std::string encode_key(const FrameHeader& header, std::span<const std::int16_t> grid);
/// A frame against the one before it (seq − 1 of the same epoch, same length).
std::string encode_delta(const FrameHeader& header, std::span<const std::int16_t> grid,
                         std::span<const std::int16_t> before);

struct DecodedFrame {
  FrameHeader header;
  bool key = false;
  std::vector<std::int16_t> grid;
};
/// Reads a key, or a delta against `before`. Errors: frame.malformed, frame.wrong_base. Never reads outside `bytes`.
Result<DecodedFrame> decode_frame(std::string_view bytes, std::span<const std::int16_t> before);

}  // namespace toile
