#include "core/draft/wearer.h"

#include <string>

#include "core/base/text.h"
#include "core/base/units.h"

namespace toile::draft {
namespace {

using measure::Measure;

struct Needed {
  Measure measure;
  double Wearer::*into;
  double low, high;  ///< mm, from a child of 80 cm to the largest sizes that are sold
};

constexpr Needed kNeeded[] = {{Measure::kHeight, &Wearer::height, 700, 2300},
                              {Measure::kBust, &Wearer::bust, 400, 2000},
                              {Measure::kUnderbust, &Wearer::underbust, 350, 2000},
                              {Measure::kWaist, &Wearer::waist, 350, 2000},
                              {Measure::kHip, &Wearer::hip, 400, 2000},
                              {Measure::kNeck, &Wearer::neck, 180, 700},
                              {Measure::kShoulderWidth, &Wearer::shoulder_width, 150, 700},
                              {Measure::kUpperArm, &Wearer::upper_arm, 110, 700},
                              {Measure::kWrist, &Wearer::wrist, 80, 350},
                              {Measure::kArmLength, &Wearer::arm_length, 200, 900},
                              {Measure::kThigh, &Wearer::thigh, 200, 1100},
                              {Measure::kInseam, &Wearer::inseam, 250, 1200}};

}  // namespace

Result<Wearer> wearer_of(const measure::BodyMeasures& taken) {
  Wearer out;
  for (const Needed& n : kNeeded) {
    const std::string name(measure::measure_name(n.measure));
    if (!taken[n.measure]) return Error{"draft.measure", "the body's " + name + " could not be taken", name};
    const double mm = mm_from_metres(taken[n.measure]->value);
    if (!(mm >= n.low && mm <= n.high)) {
      return Error{"draft.measure",
                   name + " is " + fixed_text(mm, 0) + " mm; patterns are drafted for " +
                       fixed_text(n.low, 0) + " to " + fixed_text(n.high, 0) + " mm",
                   name};
    }
    out.*n.into = mm;
  }
  out.nape_height = mm_from_metres(taken.points.nape.y);
  out.armpit_height = mm_from_metres(taken.points.armpit_height);
  out.bust_height = mm_from_metres(taken.points.bust_height);
  out.waist_height = mm_from_metres(taken.points.waist_height);
  out.hip_height = mm_from_metres(taken.points.hip_height);
  const bool in_order = out.nape_height > out.armpit_height && out.armpit_height > out.waist_height &&
                        out.waist_height > out.hip_height && out.hip_height > out.inseam;
  if (!in_order) {
    return Error{"draft.measure", "nape, armpits, waist, hips and crotch do not follow each other downwards",
                 "height"};
  }
  return out;
}

}  // namespace toile::draft
