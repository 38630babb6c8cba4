#pragma once
// Seams that a pattern's pieces ask for, for a person to accept or not.

#include <span>
#include <string>
#include <vector>

#include "core/base/run_context.h"
#include "core/pattern/pattern.h"

namespace toile::seams {

struct SeamProposal {
  pattern::Seam seam;                 ///< id "seam0", "seam1", … beside those of the pattern
  double confidence = 0;              ///< 0 to 1
  double length_a = 0, length_b = 0;  ///< mm
};

struct ProposalSettings {
  /// Whether every piece is drawn from its right side, so that seams always run against the outlines; without
  /// it a piece may also be drawn from its wrong side.
  bool sides_known = false;
  /// One per panel, or none: whether the file draws its outline clockwise. Programs walk around all pieces
  /// alike, so that where both occur, the ones are drawn from the right side and the others from the wrong
  /// one; a hint, for pieces whose shapes do not tell.
  std::vector<char> clockwise = {};
  /// Whether what goes around the neck has ends, though none of the pieces tells so.
  bool open_neck = false;
};

/// For ProposalSettings::clockwise: the winding of a closed polyline in the file's order.
bool runs_clockwise(std::span<const Vec2> outline);

/// Proposes seams between edges of outlines that no seam of the pattern has yet, surest first.
///
/// What decides is the garment that all seams make together: pairs of like length (and shape, notches, height
/// along the grain); cloth that lies about flat around the points where pieces meet; borders that run on
/// straight; openings that stay open, no handles; the same seams on mirrored pieces; and names that say left,
/// right, front, back, or a kind of piece, where they do. Confidence is how much worse the best garment
/// without the seam would be, and lower where few names say what is what, where cloth lies on cloth or two
/// pieces have one role, and for collars. Seams may join parts of edges. The order of the pieces does not
/// matter, nor does the number of threads. REQUIRES a pattern that validate() accepts. Some 0.1 to 4 s; a
/// cancelled run proposes nothing.
std::vector<SeamProposal> propose_seams(const pattern::Pattern& pattern,
                                        const ProposalSettings& settings = {},
                                        const RunContext& context = {});

}  // namespace toile::seams
