#pragma once
// All that a drape needs, in the core's own terms: what a project document becomes once its files are read.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/body/body.h"
#include "core/drape/drape_settings.h"
#include "core/material/fabric.h"
#include "core/pattern/pattern.h"
#include "core/sewing/attachment.h"
#include "core/sewing/notions.h"
#include "core/sewing/placement.h"
#include "core/warm/hung_garment.h"

namespace toile::drape {

/// A piece that nothing holds on, or that could not be put on.
struct LeftOut {
  std::string id;
  bool layer = false;  ///< a lining, facing, pocket or small trim: the garment is whole without it
  Vec3 place;          ///< m, its middle where it stands
  bool tried = false;  ///< with it, no way to put the garment on was certified
  bool tied = false;   ///< by its name a belt or a tie, which would be knotted: whole without it as well
};

struct DrapeInput {
  std::string name;
  pattern::Pattern pattern;
  std::vector<sewing::Placement> placements;  ///< one per panel
  std::vector<material::Fabric> fabrics;
  std::vector<Index> fabric_of_panel;  ///< index into fabrics, one per panel
  std::vector<body::Body> bodies;
  std::vector<sewing::Attachment> attachments;
  sewing::Notions notions;
  DrapeSettings settings;
  /// From whose end to go on, where that can be done; null: from the pieces.
  std::shared_ptr<const warm::HungGarment> before = nullptr;
  std::vector<LeftOut> left_out;         ///< not in `pattern` (core/drape/worn_part.h, fit_start.h)
  std::vector<pattern::Seam> left_open;  ///< not in `pattern`: cannot be sewn (core/drape/left_open.h)

  /// Whether something holds it for good, as the hooks of a curtain do: not until friction carries it.
  bool hangs_by_hooks() const {
    return std::any_of(attachments.begin(), attachments.end(),
                       [](const sewing::Attachment& a) { return a.release_after < 0; });
  }
};

}  // namespace toile::drape
