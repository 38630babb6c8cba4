#pragma once
// Figures of reference as numbers. Everything is a fraction of the stature; floor at y = 0, mid-line at
// x = 0, front towards +z; only the left half (+x) is described.
//
// Heights start from segment lengths of the kind that R. Drillis and R. Contini gave ("Body segment
// parameters", 1966), the head's length and breadth from ratios of the order of ANSUR II (2012); neither was
// checked figure by figure. Widths, depths, blends and strokes
// are the project's own, tuned by eye on renders. No scan was traced.

#include <span>

#include "core/body/mannequin/loft.h"
#include "core/body/measure/measures.h"

namespace toile::mannequin {

enum class Sex { kFemale, kMale, kChild };

/// An ellipsoid whose six radii differ by side.
struct SoftEllipsoid {
  Vec3 centre;
  Vec3 low, high;  ///< radii towards -x, -y, -z and +x, +y, +z
  double blend;
};

/// What carries a stroke along when the figure is stretched.
enum class Carrier { kTrunk, kHead, kLeg, kArm };

/// A soft ridge (height > 0) or furrow (height < 0) along a segment, as a sculptor's thumb leaves it. On an
/// arm the coordinates are (outwards, along the arm, to the front) from the shoulder joint.
struct Stroke {
  Carrier carrier;
  Vec3 a, b;
  double radius;  ///< where it has faded out
  double height;
};

struct Figure {
  std::span<const LoftSection> torso;  ///< t = y, u = x, v = z
  std::span<const LoftSection> yoke;   ///< t = x, u = y, v = z
  std::span<const LoftSection> neck;   ///< t = y, u = x, v = z
  std::span<const LoftSection> head;   ///< t = y, u = x, v = z
  std::span<const LoftSection> arm;    ///< t from the shoulder joint, u outwards, v = z
  std::span<const LoftSection> hand;   ///< in the arm's frame
  std::span<const LoftSection> leg;    ///< t = y, u = x, v = z
  std::span<const LoftSection> foot;   ///< t towards the toes, u outwards, v = y
  SoftEllipsoid breast, buttock;
  double bust_share;  ///< how much faster than the bust's girth its masses grow; 0: they go with the chest
  std::span<const Stroke> strokes;  ///< of the trunk; see common_strokes for the rest
  Vec3 shoulder;                    ///< joint
  double elbow, wrist, hand_end;    ///< along the arm
  double crotch, knee, hip, waist, underbust, bust, nape, chin;  ///< heights
  /// What the tape says of the figure: lengths as fractions of the stature.
  std::array<double, measure::kMeasureCount> reference;

  double of(measure::Measure m) const { return reference[static_cast<size_t>(m)]; }
};

/// Strokes of head, legs and arms, the same for all.
std::span<const Stroke> common_strokes();

const Figure& female_figure();
const Figure& male_figure();
/// The figure that a body of this kind starts from; a child has the male one.
const Figure& figure_of(Sex sex);

inline constexpr double kToeOut = 0.1219;  ///< sine of 7°

}  // namespace toile::mannequin
