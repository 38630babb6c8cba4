#pragma once
// The female figure as numbers. Everything is a fraction of the stature; floor at y = 0, mid-line at x = 0,
// front towards +z; only the left half (+x) is described.
//
// Heights start from the rule-of-thumb segment lengths as fractions of stature that R. Drillis and
// R. Contini gave ("Body segment parameters", 1966); widths, depths and blends are the project's own, tuned
// by eye on renders. They come from no data set.

#include <span>

#include "core/body/loft.h"

namespace toile {

/// An ellipsoid whose six radii differ by side.
struct SoftEllipsoid {
  Vec3 centre;
  Vec3 low, high;  ///< radii towards -x, -y, -z and +x, +y, +z
  double blend;
};

struct FemaleTables {
  std::span<const LoftSection> torso;  ///< t = y, u = x, v = z
  std::span<const LoftSection> yoke;   ///< t = x, u = y, v = z
  std::span<const LoftSection> neck;   ///< t = y, u = x, v = z
  std::span<const LoftSection> head;   ///< t = y, u = x, v = z
  std::span<const LoftSection> arm;    ///< t from the shoulder joint, u outwards, v = z
  std::span<const LoftSection> hand;   ///< in the arm's frame
  std::span<const LoftSection> leg;    ///< t = y, u = x, v = z
  std::span<const LoftSection> foot;   ///< t towards the toes, u outwards, v = y
  SoftEllipsoid bust, buttock;
};

const FemaleTables& female_tables();

inline constexpr Vec3 kShoulderJoint{0.0893, 0.7917, -0.019};
inline constexpr double kHandStart = 0.3125;  ///< along the arm: the wrist
inline constexpr double kHandEnd = 0.4185;
inline constexpr double kToeOut = 0.1219;  ///< sine of 7°

/// Heights at which the girths of reference are taken, and those girths.
inline constexpr double kHipHeight = 0.519, kWaistHeight = 0.631, kBustHeight = 0.7161;
inline constexpr double kHipGirth = 0.94 / 1.68, kWaistGirth = 0.68 / 1.68, kBustGirth = 0.88 / 1.68;

}  // namespace toile
