#pragma once
// Tailored sleeves: a top sleeve and an under sleeve that follow the arm.

#include <string>

#include "core/draft/sleeve.h"

namespace toile::draft {

/// Both pieces of one sleeve.
struct TwoPieceSleeve {
  pattern::Panel top, under;
};

/// The left arm's sleeve, each piece seen from its right side, cap up: edges hem, back_seam, cap_back,
/// cap_front, front_seam of the top sleeve and hem, front_seam, cap_front, cap_back, back_seam of the under
/// sleeve, counter-clockwise. `id` follows "top" and "under" after the side: "left top sleeve".
///
/// The one-piece sleeve (sleeve.h) is cut along two lines, a seventh of its width before the underarm and
/// more than a quarter behind it, and the strips between are joined at the underarm, as Aldrich derives her
/// two-piece sleeve from the block (from memory; the shares are the project's). Both seams bend at the elbow
/// by `draft.elbow_shift`, hollow in front, and both pieces narrow by the same amount along the back seam, so
/// that seams are of one length.
TwoPieceSleeve left_two_piece_sleeve(const SleeveDraft& draft);

}  // namespace toile::draft
