#pragma once
// The body as the arrangement asks for it: alike on both sides, and how far it stands out under a piece.

#include <span>
#include <vector>

#include "core/arrange/garment_graph.h"
#include "core/body/body.h"
#include "core/body/measure/landmarks.h"
#include "core/body/measure/mesh_cut.h"

namespace toile::arrange {

/// The figure with its left and right sides made alike about x = middle.
measure::BodyFigure alike_on_both_sides(measure::BodyFigure figure);

/// What a body has under outlines on a sheet before or behind it.
class BodyStand {
 public:
  BodyStand(const geometry::TriangleMesh& mesh, const measure::BodyFigure& figure)
      : mesh_(mesh), cutter_(mesh), figure_(alike_on_both_sides(figure)) {}

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  const measure::BodyFigure& figure() const { return figure_; }

  /// The farthest z towards the front (face 1) or back (-1) of what lies within `margin` (m) of the outline,
  /// seen along z; nothing there: the mid-plane's.
  double reach(const std::vector<Vec2>& outline, int face, double margin) const;

  /// The height at which a closed ring of `girth` (m) sits around the trunk: the highest below the waist,
  /// or at it, where it is not too tight; the hip's where it is wider than all.
  double height_of_ring(double girth) const;

  /// m, as a tape takes it.
  double waist_girth() const;

  /// Farthest distance of the trunk between two heights from the upright axis through (x, z), m.
  double radius_about(Vec2 axis, double low, double high, double breadth) const;

  /// (x, z) of the trunk's middle at a height, m.
  Vec2 middle_at(double height) const;

  /// Farthest from the mid-plane of what is higher than `height`, m.
  double half_breadth_above(double height) const;

  /// Highest y of the body about `x` (m) from the mid-plane on either side.
  double top_beside(double x) const;

 private:
  const geometry::TriangleMesh& mesh_;
  measure::PlaneCutter cutter_;
  measure::BodyFigure figure_;
};

}  // namespace toile::arrange
