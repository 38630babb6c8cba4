#pragma once
// A chair to be covered: its sizes, and its mesh.

#include "core/geometry/triangle_mesh.h"

namespace toile::draft {

/// A dining chair with a closed, upholstered seat and back. Millimetres.
struct ChairSize {
  double width = 450, depth = 460;  ///< of the seat, the back's part of it included
  double seat = 470;                ///< height of its top
  double cushion = 80;              ///< thickness of the seat
  double back = 520;                ///< height of the back above the seat
  double back_thick = 60;
  double rake = 0.13;  ///< of the back: how far it leans back for each length of height
  double leg = 45;
};

/// Of such a chair, its front at +z, the middle of its seat over the origin, its feet on y = 0. Metres,
/// closed, edges of about 4 cm.
geometry::TriangleMesh chair_solid(const ChairSize& chair);

}  // namespace toile::draft
