#include "core/dressing/limbs.h"

#include <algorithm>

namespace toile::dressing {

namespace {

constexpr double kSleeve = 0.15;  // m, from the arm's middle
constexpr double kAtTrunk = 0.1;  // m along the arm, that may still be the bodice's

double distance_to(Vec3 p, Vec3 from, Vec3 to) {
  const Vec3 way = to - from;
  const double share = std::clamp(dot(p - from, way) / dot(way, way), 0.0, 1.0);
  return length(p - (from + way * share));
}

bool is_around_arm(const measure::ArmLine& arm, Vec3 p) {
  if (dot(p - arm.root, arm.along()) < kAtTrunk) return false;
  return std::min(distance_to(p, arm.root, arm.elbow), distance_to(p, arm.elbow, arm.tip)) < kSleeve;
}

}  // namespace

bool is_around_limb(const measure::BodyFigure& figure, Vec3 p) {
  if (p.y < figure.crotch) return true;
  return std::any_of(figure.arm.begin(), figure.arm.end(),
                     [&](const measure::ArmLine& arm) { return is_around_arm(arm, p); });
}

}  // namespace toile::dressing
