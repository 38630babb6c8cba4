#pragma once
// Where the pins of a garment that hung are in the cloth that goes on from it.

#include <array>
#include <vector>

#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"
#include "core/warm/hung_garment.h"

namespace toile::warm {

/// A point of the garment's cloth.
struct CarriedPin {
  Index triangle = kNone;
  std::array<double, 3> share{};  ///< of its corners, none below 0; they sum up to 1
};

/// Each pin of `hung` at the cloth where it was before, in the pattern as it is now and its meshes, in their
/// order. What was cut away with its cloth, or with its piece, has none.
std::vector<CarriedPin> carried_pins(const HungGarment& hung, const pattern::Pattern& pattern,
                                     const mesh::PanelMeshes& meshes);

}  // namespace toile::warm
