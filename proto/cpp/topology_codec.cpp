// The topology message, written and read.

#include <cmath>

#include "proto/cpp/frame_codec.h"
#include "proto/cpp/message_bytes.h"

namespace toile::proto {
namespace {

constexpr std::size_t kRestSize = 2 * sizeof(float);  // bytes a vertex
constexpr std::size_t kPieceSize =
    2 * sizeof(std::uint32_t) + 3 * sizeof(float) + 1;  // bytes a piece, at least

void put_piece(std::string& out, const StreamPiece& piece) {
  put(out, static_cast<std::uint32_t>(piece.first_vertex));
  put(out, static_cast<std::uint32_t>(piece.vertex_count));
  for (const double c : piece.colour) put(out, static_cast<float>(c));
  put_varint(out, static_cast<std::uint32_t>(piece.id.size()));
  out += piece.id;
}

/// Sizes as the message's head tells them.
struct Counts {
  std::uint32_t vertices = 0, triangles = 0, pieces = 0, sewn = 0;
};

/// Whether what the counts promise fits into `left` bytes at all: nothing is allocated before.
bool can_hold(std::size_t left, const Counts& counts) {
  const auto fits = [left](std::uint32_t count, std::size_t size) { return count <= left / size; };
  return fits(counts.vertices, kRestSize) && fits(counts.triangles, 3) && fits(counts.pieces, kPieceSize) &&
         fits(counts.sewn, 2);
}

/// An index of a vertex, coded as its difference to `from`; kNone when there is no such vertex.
Index take_vertex(ByteReader& in, Index from, Index count) {
  const std::int64_t index = std::int64_t{from} + in.take_difference();
  return in.ok() && index >= 0 && index < count ? static_cast<Index>(index) : kNone;
}

Status read_rest(ByteReader& in, std::uint32_t count, DecodedTopology& topology) {
  topology.rest.resize(count);
  for (Vec2& p : topology.rest) {
    p.x = in.take<float>();
    p.y = in.take<float>();
    if (!is_finite(p)) return malformed("a rest position is no number");
  }
  return {};
}

Status read_pieces(ByteReader& in, std::uint32_t count, DecodedTopology& topology) {
  const auto vertices = static_cast<std::uint32_t>(topology.vertex_count());
  topology.pieces.resize(count);
  for (StreamPiece& piece : topology.pieces) {
    const auto first = in.take<std::uint32_t>(), size = in.take<std::uint32_t>();
    if (first > vertices || size > vertices - first)
      return malformed("a piece has vertices that are not there");
    piece.first_vertex = static_cast<Index>(first);
    piece.vertex_count = static_cast<Index>(size);
    for (double& c : piece.colour) {
      c = in.take<float>();
      if (!std::isfinite(c)) return malformed("a piece's colour is no number");
    }
    piece.id = in.take_bytes(in.take_varint());
  }
  return {};
}

Status read_triangles(ByteReader& in, std::uint32_t count, DecodedTopology& topology) {
  topology.triangles.resize(count);
  Index from = 0;
  for (Tri& triangle : topology.triangles) {
    for (Index& corner : triangle) {
      corner = from = take_vertex(in, from, topology.vertex_count());
      if (corner == kNone) return malformed("a triangle has a vertex that is not there");
    }
    from = triangle[0];
  }
  return {};
}

Status read_sewn(ByteReader& in, std::uint32_t count, DecodedTopology& topology) {
  topology.sewn.resize(count);
  std::array<Index, 2> from{};
  for (auto& pair : topology.sewn) {
    for (std::size_t i = 0; i < 2; ++i) {
      pair[i] = from[i] = take_vertex(in, from[i], topology.vertex_count());
      if (pair[i] == kNone) return malformed("a sewn pair has a vertex that is not there");
    }
  }
  return {};
}

}  // namespace

std::string encode_topology(std::uint32_t epoch, const FrameGrid& grid, const sewing::GarmentMesh& garment,
                            std::span<const StreamPiece> pieces) {
  std::string out;
  put_prefix(out, MessageType::kTopology, epoch);
  for (const double number : {grid.origin.x, grid.origin.y, grid.origin.z, grid.step}) put(out, number);
  for (const std::size_t count :
       {garment.rest.size(), garment.triangles.size(), pieces.size(), garment.sewn.size()}) {
    put(out, static_cast<std::uint32_t>(count));
  }
  for (const Vec2& p : garment.rest) {
    put(out, static_cast<float>(p.x));
    put(out, static_cast<float>(p.y));
  }
  for (const StreamPiece& piece : pieces) put_piece(out, piece);
  Index from = 0;
  for (const Tri& t : garment.triangles) {
    put_difference(out, t[0] - from);
    put_difference(out, t[1] - t[0]);
    put_difference(out, t[2] - t[1]);
    from = t[0];
  }
  std::array<Index, 2> before{};
  for (const auto& pair : garment.sewn) {
    for (std::size_t i = 0; i < 2; ++i) put_difference(out, pair[i] - before[i]);
    before = pair;
  }
  return out;
}

Result<DecodedTopology> decode_topology(std::string_view bytes) {
  const auto type = TRY(message_type(bytes));
  if (type != MessageType::kTopology) return malformed("a topology was expected, and this is a frame");
  DecodedTopology topology;
  ByteReader in(bytes.substr(kPrefixSize - sizeof(topology.epoch)));
  topology.epoch = in.take<std::uint32_t>();
  FrameGrid& grid = topology.grid;
  for (double* number : {&grid.origin.x, &grid.origin.y, &grid.origin.z, &grid.step})
    *number = in.take<double>();
  Counts counts;
  for (auto* count : {&counts.vertices, &counts.triangles, &counts.pieces, &counts.sewn}) {
    *count = in.take<std::uint32_t>();
  }
  if (!in.ok() || !can_hold(in.left(), counts)) return malformed("the topology ends early");
  if (!is_finite(grid.origin) || !std::isfinite(grid.step) || grid.step <= 0) {
    return malformed("the topology's grid is none");
  }
  TRY(read_rest(in, counts.vertices, topology));
  TRY(read_pieces(in, counts.pieces, topology));
  TRY(read_triangles(in, counts.triangles, topology));
  TRY(read_sewn(in, counts.sewn, topology));
  if (!in.ok() || in.left() != 0) return malformed("the topology is longer or shorter than it says");
  return topology;
}

}  // namespace toile::proto
