#pragma once
// Pieces of cloth of every shape that a cutter may think of, each with four sides that can be sewn.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/pattern/pattern.h"
#include "tests/garments/random_chance.h"

namespace toile::test {

enum Side { kBottom, kRight, kTop, kLeft };

/// A piece with its flat middle, mm. Every side is a series of edges in the outline's direction, none empty.
struct CutPiece {
  std::string shape;
  pattern::Panel panel;
  std::array<std::vector<Index>, 4> sides;
  std::vector<std::pair<Index, Index>> darts;  ///< pairs of edges to be sewn to each other
  Aabb2 box;                                   ///< mm, of the outline
};

/// A piece of about `width` × `height` mm. `narrow` (mm) is what counts as narrow: slits, slivers.
CutPiece cut_piece(Chance& chance, const std::string& id, double width, double height, double narrow);

/// A ring of cloth to be put around something of `inner` mm radius: a half ring (a sector, its ends apart) or
/// a disc with a hole.
CutPiece cut_ring(Chance& chance, const std::string& id, double inner, double outer, bool slit);

/// The same outline under another name, so that edge meets edge.
CutPiece copy_of(const CutPiece& piece, const std::string& id);

}  // namespace toile::test
