#pragma once
// What the tape takes of a cut.

#include "core/body/measure/mesh_cut.h"

namespace toile::measure {

/// (x, z) of points in a level plane.
std::vector<Vec2> flat(const std::vector<Vec3>& points);

/// Points of the parts of a level cut that cross x = middle, or else of the nearest part on each side.
std::vector<Vec3> middle_points(const MeshCut& cut, double middle);

/// The middle of the box around the points; not a number where there are none.
Vec3 middle_of(const std::vector<Vec3>& points);

/// The outermost part (greatest x) of a cut among those whose middle lies within reach of p: the arm, not the
/// trunk beside it. Empty where there is none.
std::vector<Vec3> outer_part(const MeshCut& cut, Vec3 p, double reach);

/// The tape around points of one plane, m: the corners at which it bends.
std::vector<Vec3> taut_loop(const std::vector<Vec3>& points, Vec3 normal);

/// The tape's length around points of one plane, m.
double around(const std::vector<Vec3>& points, Vec3 normal);

}  // namespace toile::measure
