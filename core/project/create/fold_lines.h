#pragma once
// Lines along which a piece is folded back: the middle of a waistband, and the edge of a facing that is cut
// on. The garment shows, and its seams meet, what is left when it is folded.

#include <optional>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/piece_words.h"
#include "core/project/create/drawn_lines.h"

namespace toile::create {

/// From one place of the outline straight to another, mm; what stays lies at its left.
struct FoldLine {
  Vec2 from, to;
  bool halves = false;  ///< a strip's middle: nothing is sewn there, as it may be to the edge of a front
};

/// A piece in two parts, the larger at the line's left; their outlines, mm.
struct PartedPiece {
  FoldLine line;
  std::vector<Vec2> larger, smaller;
};

/// The piece parted along the chord; nothing where that leaves nothing at one side of it.
std::optional<PartedPiece> parted_along(const pattern::Panel& panel, const Chord& chord);

/// How far the part reaches from the line, mm.
double breadth_of(const std::vector<Vec2>& part, const FoldLine& fold);

/// The line of the piece, drawn from outline to outline, along which a part of it is folded back onto the
/// rest and then lies within it, ending where it ends: a strip's middle, of whichever halves the one with
/// more notches stays, or, along the grain, the border of a front's facing. A narrower strip than 28 mm is no
/// facing, but what laps over beyond the middle of a front. REQUIRES a panel that validate() accepts.
std::optional<FoldLine> fold_line(const pattern::Panel& panel, const seams::PieceWords& words);

/// What stays of the piece, its edges numbered anew. The fold is the last, of a strip as pattern::kFoldEdge.
pattern::Panel folded(const pattern::Panel& panel, const FoldLine& fold);

}  // namespace toile::create
