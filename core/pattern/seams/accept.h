#pragma once
// Which proposed seams a garment takes.

#include <span>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/propose.h"

namespace toile::seams {

/// Which of `proposals`, surest first, can be sewn together: those of at least this confidence that want no
/// part of an edge that a surer one has taken. Proposals may be each other's alternatives.
std::vector<bool> sewn_together(std::span<const SeamProposal> proposals, double least_confidence);

/// Likelier than not: what a piece takes that no surer seam holds on.
inline constexpr double kLikely = 0.5;

/// What is sewn where nothing surer wants its edges: a gap that was not meant lets a garment slip, and more
/// often than not nothing else fits there.
inline constexpr double kFits = 0.65;

/// What closes a sleeve that is set in: hardly any garment has one that is open along the arm.
inline constexpr double kClosesTube = 0.25;

/// As sewn_together(), but down to kFits; and likely ones of pieces that would be sewn to no part, or not to
/// the largest, of edges that are sewn in part, and of legs that close in themselves, and less likely ones
/// that close what is set in all around (kClosesTube): a seam in doubt is better than a piece that must be
/// left out, or a sleeve that is set in by half. Proposals of the same edges are likely together, whichever
/// way each runs. What is sewn last (linings, pockets, second layers, strangers: strangers.h) takes none
/// below `least_confidence`.
std::vector<bool> sewn_to_wear(const pattern::Pattern& pattern, std::span<const SeamProposal> proposals,
                               double least_confidence);

}  // namespace toile::seams
