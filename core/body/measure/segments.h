#pragma once
// A body in parts, each with a box along it.

#include <array>
#include <vector>

#include "core/body/measure/landmarks.h"

namespace toile::measure {

enum class BodyPart { kHead, kNeck, kTorso, kHips, kLeftArm, kRightArm, kLeftLeg, kRightLeg };
inline constexpr int kBodyParts = 8;

/// "head", "left_arm", …
const char* name_of(BodyPart part);

/// A box with its own axes: axis[1] runs along the part (upwards; along arms and legs towards the trunk),
/// axis[2] to the front, axis[0] at right angles to both, so that the three are right-handed.
struct PartBox {
  BodyPart part = BodyPart::kTorso;
  Vec3 centre;                 ///< m
  std::array<Vec3, 3> axis;    ///< unit vectors
  Vec3 half;                   ///< m, half its size along each axis
  Vec3 at(Vec3 share) const {  ///< the point at shares, -1 to 1, of the half sizes
    return centre + axis[0] * (half.x * share.x) + axis[1] * (half.y * share.y) +
           axis[2] * (half.z * share.z);
  }
};

/// The part that each vertex belongs to: parted at the armpits, the neck's narrowest place, the chin, the
/// waist and the crotch.
std::vector<BodyPart> part_of_vertices(const geometry::TriangleMesh& mesh, const BodyFigure& figure);

/// One box per part, in the order of BodyPart, around the part's vertices.
std::array<PartBox, kBodyParts> part_boxes(const geometry::TriangleMesh& mesh, const BodyFigure& figure);

}  // namespace toile::measure
