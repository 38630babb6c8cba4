#pragma once
// Pieces in the making: what one pass over a place's lines hands to the next.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/nest.h"
#include "core/pattern/dxf/read.h"

namespace toile::dxf {

/// What may be a piece's name.
struct DxfTitle {
  std::string text;
  std::optional<std::size_t> entity;  ///< that says it; none where it is the name of a block
};

/// What texts say of the fold that a piece is cut on.
struct DxfToldFold {
  std::optional<int> line = std::nullopt;  ///< of the first text that says so; labels may be of other folds
  std::vector<Vec2> labels = {};           ///< where texts stand that say nothing else, mm
};

/// A piece with what the report has to know of it.
struct DxfFound {
  DxfPiece piece;
  int id = 0;                         ///< its number in the log
  std::vector<std::size_t> entities;  ///< those of its outline
  std::vector<DxfTitle> titles = {};  ///< words that stand in it or beside it, the likeliest first
  DxfToldFold fold = {};
  std::vector<Vec2> half = {};  ///< mm, its outline before it was unfolded; empty where it was not

  /// What of it stands in the drawing.
  const std::vector<Vec2>& drawn() const { return half.empty() ? piece.outline : half; }
};

/// A piece among the loops that it was made from; these outlive it.
struct DxfPlaced {
  DxfFound found;
  const DxfLoop* loop = nullptr;                 ///< its outline
  const DxfLoop* cut = nullptr;                  ///< the cut line around it, when the outline is the sew line
  std::vector<std::size_t> notch_entities = {};  ///< the entity of each notch

  /// The outermost line of the piece.
  const DxfLoop& border() const { return cut ? *cut : *loop; }
};

/// The pieces of one place so far.
struct DxfPieces {
  std::vector<DxfPlaced> placed;  ///< by line
  std::vector<bool> used;  ///< of each chain: it is an outline, a hole or a fault, no line to be placed
  bool is_block = false;   ///< the place is a block: what stands in it belongs to its pieces
  DxfNotes notes;
};

/// How far a line may lie from the piece that it belongs to.
enum class DxfReach {
  kWithin,   ///< the box of the piece holds it, or most of it lies in the piece
  kAround,   ///< one box holds the other: lines that may be outlines
  kCrossing  ///< any of it lies in the piece, or it stands in the block of the piece
};

/// The number of the piece that the line belongs to, of several the smallest whose box holds it, else the one
/// that most of it lies in, else of a block the nearest. placed.size() when there is none.
std::size_t owner_of(const DxfPieces& pieces, const std::vector<Vec2>& line, DxfReach reach);

/// Says what became of the chain's entities.
void tell(DxfNotes& notes, const DxfChain& chain, DxfFate fate, const std::string& reason, int piece = -1);

}  // namespace toile::dxf
