#pragma once
// A tape measure: girths of slices, as a tape spans them (over hollows, straight).

#include <limits>

#include "core/geometry/triangle_mesh.h"

namespace toile::measure {

struct Girth {
  double height = 0;  ///< m above the floor's y = 0
  double girth = 0;   ///< m
};

inline constexpr double kNoBreadth = std::numeric_limits<double>::infinity();

/// Girth of the trunk (or of both legs together) in the level plane at `height`: the parts of the slice that
/// cross x = 0, or where none does, the nearest part on each side. Arms that stand off are not counted, nor
/// what lies farther than `half_breadth` from x = 0. 0 where the plane misses the mesh.
double girth_at(const geometry::TriangleMesh& mesh, double height, double half_breadth = kNoBreadth);

/// Half the breadth (along x) of what girth_at() goes around.
double half_breadth_at(const geometry::TriangleMesh& mesh, double height);

/// Narrowest and widest girth between two heights, looked for every 4 mm. REQUIRES low <= high.
Girth narrowest_girth(const geometry::TriangleMesh& mesh, double low, double high,
                      double half_breadth = kNoBreadth);
Girth widest_girth(const geometry::TriangleMesh& mesh, double low, double high,
                   double half_breadth = kNoBreadth);

struct TrunkGirths {
  Girth bust, waist, hip;
};

/// Bust and hip as the widest places, waist as the narrowest, each looked for where it lies on a standing
/// adult whose feet are at y = 0: hip 0.48–0.56, waist 0.58–0.68, bust 0.70–0.72 of the stature. Arms may
/// have grown together with the chest: at the bust nothing counts that is wider than the ribs below it.
TrunkGirths trunk_girths(const geometry::TriangleMesh& standing);

}  // namespace toile::measure
