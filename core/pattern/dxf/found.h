#pragma once
// Pieces in the making: what one pass over a place's lines hands to the next.

#include <cstddef>
#include <vector>

#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/nest.h"
#include "core/pattern/dxf/read.h"

namespace toile::dxf {

/// A piece with what the report has to know of it.
struct DxfFound {
  DxfPiece piece;
  int id = 0;                         ///< its number in the log
  std::vector<std::size_t> entities;  ///< those of its outline
};

/// A piece among the loops that it was made from; these outlive it.
struct DxfPlaced {
  DxfFound found;
  const DxfLoop* loop = nullptr;  ///< its outline
  const DxfLoop* cut = nullptr;   ///< the cut line around it, when the outline is the sew line
};

/// The pieces of one place so far.
struct DxfPieces {
  std::vector<DxfPlaced> placed;  ///< by line
  std::vector<bool> used;  ///< of each chain: it is an outline, a hole or a fault, no line to be placed
  DxfNotes notes;
};

/// The number of the piece that a line of this box belongs to: the smallest whose box holds it, or with
/// `overlap_is_enough` is held by it. placed.size() when there is none.
std::size_t owner_of(const std::vector<DxfPlaced>& placed, const Aabb2& box, bool overlap_is_enough);

/// Says what became of the chain's entities.
void tell(DxfNotes& notes, const DxfChain& chain, DxfFate fate, const std::string& reason, int piece = -1);

}  // namespace toile::dxf
