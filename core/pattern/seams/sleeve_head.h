#pragma once
// How a sleeve of two pieces is set into its armhole. Around the ring that both make no corner of one meets a
// corner of the other, so that lengths do not say how far it is turned; tailoring does.

#include <vector>

#include "core/pattern/seams/model.h"
#include "core/pattern/seams/propose.h"

namespace toile::seams {

/// Turns each sleeve in its armhole so that its highest point, or the notch there, lies at the shoulder; of
/// two sleeves that are sewn to the wrong arms, so that their fronts would lie at the back, changes the arms.
/// The sleeve's back seam is the one nearer to its highest point: it ends higher than the front one (Aldrich,
/// Metric Pattern Cutting for Menswear, the two-piece sleeve). Where that point is near the middle of its
/// piece, neither arm is the wrong one.
///
/// `rings` are numbers of proposals whose two sides each run all around. `model` says of each panel what it
/// is. Leaves alone what is no sleeve of two pieces with one that holds the highest
/// point between its ends, or no armhole between a front and a back.
void set_in_sleeves(const pattern::Pattern& pattern, const SeamModel& model, const std::vector<Index>& rings,
                    std::vector<SeamProposal>& proposals);

}  // namespace toile::seams
