#pragma once
// A drape that goes on from where another ended: the cloth as it hung then, cut to the pattern as it is now.
// The change becomes strain, which the cloth gets rid of under contact: nothing is moved through anything.

#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/collision/crossings.h"
#include "core/collision/obstacle.h"
#include "core/dressing/person.h"
#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"
#include "core/sewing/garment_mesh.h"
#include "core/warm/hung_garment.h"

namespace toile::warm {

struct WarmStart {
  std::vector<Vec3> positions;  ///< m, one a garment vertex; joined ones together
  std::vector<bool> joined;     ///< garment vertices that are one with the least of their class
  std::vector<Vec3> preloads;   ///< one a triangle
  double widest = 0;            ///< m, between two vertices that are sewn and not joined
};

/// What the cloth must not cross: the same solids as contact and as the count of crossings see them, and who
/// wears it, out of whom cloth is moved.
struct Surroundings {
  std::span<const collision::Obstacle> obstacles;
  std::span<const collision::CrossingBody> solids;
  const std::optional<dressing::Person>& person;
};

/// `hung`, cut to `pattern`. Errors: warm.piece (a piece that did not hang, `where` names it), warm.crosses
/// (cloth would begin within cloth or a body, e.g. since another stands there now).
Result<WarmStart> go_on_from(const HungGarment& hung, const pattern::Pattern& pattern,
                             const mesh::PanelMeshes& meshes, const sewing::GarmentMesh& garment,
                             const Surroundings& around);

}  // namespace toile::warm
