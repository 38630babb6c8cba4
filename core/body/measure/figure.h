#pragma once
// A standing person's build, found by the mesh's shape alone: where girths are widest and narrowest, where
// limbs leave the trunk, where profiles turn.

#include <array>

#include "core/base/result.h"
#include "core/body/measure/mesh_cut.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::measure {

/// Index of a wearer's side in arrays of two. The wearer looks along +z, so that the left is at +x.
enum BodySide { kWearersLeft = 0, kWearersRight = 1 };

/// A limb's middle line, m.
struct ArmLine {
  Vec3 root;   ///< where the arm leaves the trunk, in its middle
  Vec3 elbow;  ///< middles of the sections there
  Vec3 wrist;
  Vec3 tip;      ///< farthest point of the hand
  double girth;  ///< m, of the upper arm
  Vec3 along() const { return normalized(wrist - root); }
};
struct LegLine {
  Vec3 top;  ///< at the crotch's height
  Vec3 knee, ankle;
};

/// The measures that landmarks, boxes and arrangement share. m; heights are y.
struct BodyFigure {
  double floor = 0, top = 0, middle = 0;  ///< lowest and highest y; x of the mid-plane
  double crotch = 0, hip = 0, waist = 0, bust = 0;
  double neck = 0, chin = 0;       ///< narrowest neck; where the head begins
  std::array<Vec3, 2> armpit;      ///< left, right
  std::array<Vec3, 2> shoulder;    ///< outer end of the shoulder's slope
  std::array<Vec3, 2> neck_side;   ///< where the shoulder's slope rises into the neck
  Vec3 neck_front, neck_back;      ///< where the profile turns from chest and back into the neck
  std::array<Vec3, 2> bust_point;  ///< farthest to the front
  std::array<ArmLine, 2> arm;      ///< left, right
  std::array<LegLine, 2> leg;
  double height() const { return top - floor; }
};

/// The figure of someone who stands upright on two legs, looks along +z and holds the arms off the trunk (A-
/// or T-pose, up to hanging at some distance). Any closed mesh will do, and one that crosses itself a little.
/// Error "body.not_standing" with what was not found: no trunk, no two legs, no arms.
Result<BodyFigure> find_figure(const geometry::TriangleMesh& mesh);

/// Girth (m) of the trunk at a height, arms left out, as a tape takes it.
double trunk_girth(const PlaneCutter& cutter, const BodyFigure& figure, double height);

}  // namespace toile::measure
