#include "core/dressing/figure.h"

#include <algorithm>

namespace toile::dressing {

namespace {

constexpr double kMittenRoom = 8e-3;  // m
constexpr int kStepsToClear = 3;      // towards a place with clearance

}  // namespace

Mittens::Mittens(const measure::BodyFigure& f) {
  for (std::size_t side = 0; side < 2; ++side) {
    const measure::ArmLine& arm = f.arm[side];
    ends_[side] = {arm.wrist, normalized(arm.tip - arm.wrist), length(arm.tip - arm.wrist) + 0.05};
    const measure::LegLine& leg = f.leg[side];
    ends_[2 + side] = {leg.ankle, {0, -1, 0}, leg.ankle.y - f.floor + 0.05};
  }
}

double Mittens::room_at(Vec3 p) const {
  for (const End& end : ends_) {
    const double along = dot(p - end.from, end.along);
    const double aside = length(p - end.from - end.along * along);
    if (along > 0 && along < end.reach && aside < 0.25) return kMittenRoom;
  }
  return 0;
}

double SlimFigure::clearance(Vec3 p) const {
  const double d = field->distance(p, slim) - margin;
  return mittens != nullptr && d < kMittenRoom ? d - mittens->room_at(p) : d;
}

Vec3 SlimFigure::above_floor(Vec3 p) const { return {p.x, std::max(p.y, floor + margin), p.z}; }

Vec3 SlimFigure::moved_out(Vec3 p, double most) const {
  double left = most;
  for (int i = 0; i < kStepsToClear && left > 0; ++i) {
    const double d = clearance(p);
    if (d >= 0) break;
    const double way = std::min(-d, left);
    p += field->outwards(p, slim) * way;
    left -= way;
  }
  return above_floor(p);
}

}  // namespace toile::dressing
