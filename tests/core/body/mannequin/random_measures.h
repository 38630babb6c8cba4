#pragma once
// Plausible people by chance.

#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/proportions.h"

namespace toile {

/// A small generator of our own: the same people everywhere.
class PeopleByChance {
 public:
  explicit PeopleByChance(std::uint64_t seed) : state_(seed * 2654435769u + 88172645463325252u) {}

  /// Height and the trunk's girths always; each other measure every second time, a few percent off what
  /// proportions say.
  mannequin::MannequinSettings next(mannequin::Sex sex) {
    mannequin::MannequinSettings s;
    s.sex = sex;
    measure::MeasureSet& m = s.asked;
    const bool child = sex == mannequin::Sex::kChild;
    m[measure::Measure::kHeight] = sex == mannequin::Sex::kFemale ? in(1.50, 1.86)
                                   : sex == mannequin::Sex::kMale ? in(1.60, 2.0)
                                                                  : in(0.92, 1.66);
    const measure::MeasureSet usual = mannequin::with_proportions(sex, m);
    const double size = child ? in(-0.03, 0.05) : in(-0.08, 0.16), own = child ? 0.02 : 0.035;
    for (measure::Measure girth : {measure::Measure::kBust, measure::Measure::kWaist, measure::Measure::kHip})
      m[girth] = *usual[girth] + size + in(-own, own);
    const measure::MeasureSet rest = mannequin::with_proportions(sex, m);
    const std::pair<measure::Measure, double> others[] = {
        {measure::Measure::kUnderbust, 0.015},    {measure::Measure::kNeck, 0.06},
        {measure::Measure::kShoulderWidth, 0.05}, {measure::Measure::kUpperArm, 0.07},
        {measure::Measure::kWrist, 0.06},         {measure::Measure::kArmLength, 0.05},
        {measure::Measure::kThigh, 0.05},         {measure::Measure::kCalf, 0.07},
        {measure::Measure::kInseam, 0.03},        {measure::Measure::kBackLength, 0.04}};
    for (const auto& [measure, share] : others)
      if (in(0, 1) < 0.5) m[measure] = *rest[measure] * in(1 - share, 1 + share);
    s.arm_angle = in(35, 55) * mannequin::kQuarterTurn / 90;
    constexpr Index kCounts[] = {2204, 3304, 4562, 5624};
    s.triangle_count = kCounts[static_cast<int>(in(0, 3.999))];
    return s;
  }

 private:
  double in(double low, double high) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return low + (high - low) * static_cast<double>(state_ >> 11) * (1.0 / 9007199254740992.0);
  }

  std::uint64_t state_;
};

}  // namespace toile
