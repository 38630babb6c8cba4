#pragma once
// Pieces that are drawn as a half, to be cut on the fold.

#include <optional>
#include <vector>

#include "core/base/types.h"

namespace toile::dxf {

/// A mirror line, endless.
struct FoldAxis {
  Vec2 at, along;  ///< along: unit vector

  double side(Vec2 p) const { return cross(along, p - at); }  ///< mm, positive on the left
  Vec2 mirrored(Vec2 p) const { return p - perpendicular(along) * (2 * side(p)); }
  Vec2 snapped(Vec2 p) const { return p - perpendicular(along) * side(p); }
};

/// Within this a point lies on the fold, mm.
inline constexpr double kOnFold = 0.5;

/// The axis through the line's ends; nothing when they are one.
std::optional<FoldAxis> fold_axis(const std::vector<Vec2>& line);

/// Whether the points lie on both sides: the piece is drawn whole.
bool spans_fold(const std::vector<Vec2>& points, const FoldAxis& axis);

/// Whether the piece that spans the fold reaches about as far on one side as on the other, as a whole one
/// does.
bool is_even_about(const std::vector<Vec2>& points, const FoldAxis& axis);

/// Whether both ends of an open line lie on the axis, so that the fold closes it.
bool closes_at_fold(const std::vector<Vec2>& points, const FoldAxis& axis);

struct UnfoldedLoop {
  std::vector<Vec2> outline;
  std::vector<std::vector<Vec2>> holes;  ///< where the half leaves the fold and comes back to it
};

/// The closed outline of both halves, from the half: what of it runs along the axis goes. Where it does so in
/// several stretches, what lies between two of them is a hole on the fold. Nothing when the outline does not
/// run along the axis, touches it in a point, or would fall apart.
std::optional<UnfoldedLoop> unfolded_loop(const std::vector<Vec2>& half, const FoldAxis& axis);

}  // namespace toile::dxf
