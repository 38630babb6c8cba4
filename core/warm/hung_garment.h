#pragma once
// A garment as it hung at the end of a drape, for another drape to go on from: its cloth in space and in the
// flat, by the names of pieces and edges, so that it fits a pattern that has been edited since.
//
//   "TOILEHG\n" | version u32 | pieces | in version 2 pins | hash of all before, 32 hex digits
//
// Little endian; doubles as they are (proto/hung.md).

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"
#include "core/sewing/garment_mesh.h"

namespace toile::warm {

/// What is written: the first where there are no pins.
inline constexpr std::uint32_t kHungVersion = 1, kHungVersionWithPins = 2;

struct HungEdge {
  std::string id;
  std::vector<Index> vertices;  ///< of the piece, from the edge's start to its end
};

struct HungPiece {
  std::string id;
  std::vector<Vec2> rest;      ///< m, each vertex in the flat piece
  std::vector<Tri> triangles;  ///< counter-clockwise in the flat piece
  std::vector<HungEdge> edges;
  std::vector<Vec3> positions;  ///< m, each vertex in space
  std::vector<Vec3> preloads;   ///< what the membrane of each triangle had learnt
};

/// As many as hands may set (core/drape/hands.h); a file that has more is no such file.
inline constexpr std::size_t kMostHungPins = 100;

/// Where somebody held the cloth.
struct HungPin {
  std::string piece;  ///< its id
  Vec2 at;            ///< m, in the flat piece
  friend bool operator==(const HungPin&, const HungPin&) = default;
};

struct HungGarment {
  std::vector<HungPiece> pieces;
  std::vector<HungPin> pins{};  ///< in the order in which they were set
};

/// The pieces of a pattern as they were meshed; neither positions nor preloads.
HungGarment flat_pieces(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes);

/// Puts them where they hang: `positions` (m) one a vertex of the garment, `preloads` one a triangle.
void hang(const sewing::GarmentMesh& garment, std::span<const Vec3> positions, std::span<const Vec3> preloads,
          HungGarment& hung);

std::string encode_hung(const HungGarment& hung);

/// Errors: hung.damaged (cut off, changed, or no such file at all), hung.version. Takes no more memory than a
/// few times the bytes; what it gives back is whole: indices in range, numbers finite, all lengths agree.
Result<HungGarment> decode_hung(std::string_view bytes);

}  // namespace toile::warm
