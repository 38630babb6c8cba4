#pragma once
// Questions about bodies that the checks ask again and again: what a straight line meets, whether a point is
// inside, what a plane cuts.

#include <optional>
#include <span>
#include <vector>

#include "core/base/aabb.h"
#include "core/body/body.h"
#include "core/body/measure/mesh_cut.h"
#include "core/collision/crossings.h"
#include "core/geometry/bvh.h"

namespace toile::preflight {

class BodyProbe {
 public:
  /// `body` must outlive the probe.
  explicit BodyProbe(const body::Body& body);

  const body::Body& body() const { return *body_; }
  const collision::CrossingBody& crossing() const { return crossing_; }
  const measure::PlaneCutter& cutter() const { return cutter_; }
  const Aabb3& box() const { return box_; }  ///< m, around the body
  double height() const { return box_.size().y; }

  /// Parameters t in (0, 1), rising, at which the segment passes through a triangle; exact but for t itself.
  std::vector<double> hits(Vec3 from, Vec3 to) const;
  bool meets(Vec3 from, Vec3 to) const;
  /// Whether rays in three directions all leave through an odd number of triangles.
  bool contains(Vec3 p) const;

 private:
  template <typename Visit>
  void visit_hits(Vec3 from, Vec3 to, Visit&& visit) const;

  const body::Body* body_;
  collision::CrossingBody crossing_;
  measure::PlaneCutter cutter_;
  Aabb3 box_;
};

std::vector<BodyProbe> make_probes(std::span<const body::Body> bodies);

/// A connected line in which a plane cuts a body, as loose points in the plane's own axes.
struct SlicePart {
  std::vector<Vec2> points;  ///< m
  Vec2 centre;               ///< of the points' bounding box
};

/// A plane with two axes in it, all unit vectors at right angles.
struct PlaneFrame {
  Vec3 origin, u, v, normal;
  Vec2 flat(Vec3 p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
  Vec3 lifted(Vec2 p) const { return origin + u * p.x + v * p.y; }
};
/// REQUIRES `normal` not null.
PlaneFrame make_plane_frame(Vec3 origin, Vec3 normal);

std::vector<SlicePart> slice_parts(const measure::PlaneCutter& cutter, const PlaneFrame& plane);

}  // namespace toile::preflight
