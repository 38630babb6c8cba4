#pragma once
// Automatic arrangement: every piece gets a place around a standing person, so that it can be sewn there.

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/body/body.h"
#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"
#include "core/preflight/finding.h"
#include "core/sewing/attachment.h"
#include "core/sewing/placement.h"

namespace toile::arrange {

struct ArrangeInput {
  const pattern::Pattern& pattern;
  const mesh::PanelMeshes& meshes;     ///< of any particle distance that shows the outlines
  std::span<const body::Body> bodies;  ///< the first that stands like a person is dressed
  /// Names of the garment's pieces that are not here: sleeves that are not sewn say that it is a top.
  std::vector<std::string> absent = {};
};

/// What was decided for a piece, in words: "torso, front", "left sleeve, around the arm".
struct ArrangedPiece {
  std::string id, where;
};

struct Arrangement {
  std::vector<sewing::Placement> placements;    ///< one per panel
  std::vector<sewing::Attachment> attachments;  ///< what holds a skirt or trousers up until friction does
  std::vector<ArrangedPiece> pieces;            ///< one per panel
  preflight::Findings findings;                 ///< what the look at this start finds
  /// Panels for which nothing tells a place, rising: whatever stands in `placements`, they stay where they
  /// are.
  std::vector<Index> unplaced = {};
};

/// Fronts stand flat before the body and backs behind it, sleeves before and behind the arms or around them,
/// hoods beside the head, strips that close in themselves around what they close around; partners as mirror
/// images. Names say what a piece covers where they can, seams and shapes where they cannot. Heights come
/// from the body: shoulder seams at the neck's sides, waists where the trunk is as wide as they are, crotches
/// below the crotch. Where no seam leads to some pieces, each part that hangs together is arranged by itself,
/// smaller ones over larger ones; what still has no place is left and told. Equal input gives equal places.
///
/// Errors: "arrange.no_body" (nobody to dress), "body.not_standing", "arrange.no_seams" with the piece that
/// nothing leads to, where less than half of the cloth has a place.
Result<Arrangement> arrange(const ArrangeInput& input);

}  // namespace toile::arrange
