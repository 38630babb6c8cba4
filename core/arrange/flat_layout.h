#pragma once
// The garment laid flat: fronts on one sheet, backs on another behind it, seen from the front, so that what
// is sewn together lies together.

#include <vector>

#include "core/arrange/garment_graph.h"

namespace toile::arrange {

struct FlatLayout {
  std::vector<FlatMove> pose;  ///< of each piece: its own plane → the sheet, m; x to the wearer's left, y up
  std::vector<int> face;       ///< 1 front, -1 back, 0 not laid out
  std::vector<Index> partner;  ///< the piece that mirrors each at x = 0, itself perhaps; kNone

  bool has(Index piece) const { return face[static_cast<std::size_t>(piece)] != 0; }
};

/// Lays out the pieces `members` around x = 0, partners as mirror images; y is anyone's. `graph` may be
/// turned inside out where names of left and right ask for it. Pieces that no seam leads to are not laid out.
FlatLayout lay_out_trunk(GarmentGraph& graph, const std::vector<Index>& members);

/// Lays out `members` from `root` on, which lies as told; nothing is mirrored.
void lay_out_limb(const GarmentGraph& graph, const std::vector<Index>& members, Index root,
                  const FlatMove& root_pose, int root_face, FlatLayout& layout);

/// Moves pieces of one sheet apart until `gap` (m) is between them; partners stay mirror images. What cannot
/// be parted within 15 cm is left.
void part_pieces(const GarmentGraph& graph, const std::vector<Index>& members, double gap,
                 FlatLayout& layout);

/// The piece's outline on the sheet.
std::vector<Vec2> outline_on_sheet(const GarmentPiece& piece, const FlatMove& pose);

}  // namespace toile::arrange
