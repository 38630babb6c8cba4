#pragma once
// Whether a garment is on: what must hold before a drape may begin from a shape that contact did not guard.

#include <span>
#include <vector>

#include "core/collision/obstacle.h"
#include "core/dressing/linking.h"
#include "core/dressing/untangle.h"
#include "core/sewing/garment_mesh.h"

namespace toile::dressing {

/// A border of the sewn garment and what of the body goes through it.
struct WornRing {
  std::vector<Index> vertices;  ///< least of their classes, in order
  double girth = 0;             ///< m, of the flat cloth
  Enclosure around;
  bool slit = false;   ///< around nothing, and cloth goes all around one of its ends: a seam may be missing
  bool right = false;  ///< around limbs, each once, or a slit
};

struct Certificate {
  Tangle crossings;
  std::vector<WornRing> rings;
  double shrink_p99 = 0;                    ///< likewise, shorter
  double stretch_p99 = 0, stretch_max = 0;  ///< of edges, 0.1: a tenth longer than flat
  double faces_out = 1;  ///< share of the cloth near the body whose right side is away from it

  double gap = 1;       ///< m, least of cloth to cloth and body
  double lowest = 1e9;  ///< m above the ground

  int wrong_rings() const;
  /// The garment is on, though its cloth may be stretched far: tight pieces, and threads that ended late.
  bool holds_strained() const;
  /// It is on, and near its own size.
  bool holds() const;
};

/// The borders of the sewn garment that are long enough to go around a limb, and what they go around.
std::vector<WornRing> worn_rings(const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                                 const Skeleton& skeleton);

/// `x`: one position a garment vertex, sewn ones together. `body` is the whole figure, not drawn in.
Certificate certify(const sewing::GarmentMesh& garment, std::span<const Vec3> x, const SlimFigure& body,
                    const collision::CrossingBody& crossing, std::span<const collision::Obstacle> obstacles,
                    const Skeleton& skeleton);

}  // namespace toile::dressing
