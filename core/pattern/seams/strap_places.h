#pragma once
// Where straps over the shoulder are held: their ends are sewn onto a piece, not to an edge of their length.

#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/propose.h"

namespace toile::seams {

/// `proposals`, surest first, and seams for the ends of shoulder straps that no likely one takes: in front to
/// the corners of the upper edge, or at a pair of notches on it, and so behind, each strap on one side of the
/// body. Where an upper edge has neither, at a quarter of it. Nothing where there is no front or no back.
std::vector<SeamProposal> with_strap_places(const pattern::Pattern& pattern,
                                            std::vector<SeamProposal> proposals);

}  // namespace toile::seams
