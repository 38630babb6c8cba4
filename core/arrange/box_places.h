#pragma once
// Places by hand: a piece on a side of a body part's box, or rolled around the part.

#include "core/body/measure/segments.h"
#include "core/sewing/placement.h"

namespace toile::arrange {

/// Sides of a box; left and right are the wearer's.
enum class BoxSide { kFront, kBack, kLeft, kRight };

/// Where on a box a piece goes.
struct OnBox {
  BoxSide side = BoxSide::kFront;
  Vec2 at;          ///< m, from the side's middle: to the right as one looks at it, and up along the part
  double away = 0;  ///< m, from the side
  double turn = 0;  ///< radians, counter-clockwise as one looks at it
  Vec2 anchor;      ///< m, the piece's flat point that comes there
  bool flipped = false;  ///< mirrored before the turn: the right side faces the body
};

/// Flat before the side, the right side outwards unless flipped.
sewing::RigidPlacement on_box_side(const measure::PartBox& box, const OnBox& where);

/// Rolled around the box's axis at `where.away` (m) from what of the part stands out farthest, without
/// stretching; the anchor comes to `where.at.y` along the axis, turned from the side's middle by `where.at.x`
/// along the circle. With `slope` it is a cone (WrappedPlacement). REQUIRES the part's own box.
sewing::WrappedPlacement around_box(const measure::PartBox& box, const OnBox& where, double part_radius,
                                    double slope = 0);

/// Farthest distance (m) of a part's vertices from its box's axis, between two places along it, m from the
/// box's middle.
double radius_of_part(const geometry::TriangleMesh& mesh, const measure::BodyFigure& figure,
                      const measure::PartBox& box, double low, double high);

}  // namespace toile::arrange
