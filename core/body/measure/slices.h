#pragma once
// What a plane cuts from a body, part by part: the means by which landmarks are found on any mesh.

#include <optional>
#include <span>
#include <vector>

#include "core/base/aabb.h"
#include "core/body/measure/mesh_cut.h"

namespace toile::measure {

/// A connected line in which a plane cuts a body, as loose points.
struct BodyCut {
  std::vector<Vec3> points;  ///< m
  Aabb3 box;                 ///< m, around them
};

/// The parts in which the plane through `origin` with `normal` cuts the mesh, in plane_cut()'s order.
std::vector<BodyCut> cut_body(const PlaneCutter& cutter, Vec3 origin, Vec3 normal);

/// The tape around points of a plane, over hollows, m. `normal` as it was cut.
double tape_around(const BodyCut& cut, Vec3 normal);

/// The level part that holds the upright line x = `middle`, with those that overlap it; no points when none
/// does.
BodyCut middle_cut(const PlaneCutter& cutter, double height, double middle);

/// The skin's place foremost (`facing` 1) or hindmost (−1) in the mid-plane at a height: of the cut's points
/// within `aside` (m) of it, or where a coarse mesh has none there, of its triangles. `cut` is the
/// middle_cut() at `height`.
std::optional<Vec3> middle_skin(const geometry::TriangleMesh& mesh, const BodyCut& cut, double height,
                                double middle, double facing, double aside);

}  // namespace toile::measure
