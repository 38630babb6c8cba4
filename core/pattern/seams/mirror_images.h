#pragma once
// What is sewn on one side of a garment alone.

#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/propose.h"

namespace toile::seams {

/// `proposals`, surest first, and the mirror images of those that can be worn where no likely one wants their
/// edges: garments are alike on both sides, and the search may have ended with one of them. An image is told
/// a little less surely than what it mirrors.
std::vector<SeamProposal> with_mirror_images(const pattern::Pattern& pattern,
                                             std::vector<SeamProposal> proposals);

}  // namespace toile::seams
