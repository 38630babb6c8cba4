#pragma once
// Which way up a piece is worn.

#include "core/pattern/pattern.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::seams {

/// The direction in the panel's plane, a unit vector, that is up when the piece is worn, as far as its grain,
/// its shape and its name tell.
Vec2 up_of_piece(const pattern::Panel& panel, const PieceWords& words);

}  // namespace toile::seams
