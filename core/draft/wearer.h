#pragma once
// Whom a garment is drafted for: the measures that constructions count with.

#include "core/base/result.h"
#include "core/body/measure/measures.h"

namespace toile::draft {

/// Millimetres, as the tape takes them (measure_rule), and what follows from where it lay. The figures here
/// are of no one in particular: a woman near EU 40.
struct Wearer {
  double height = 1680, bust = 920, underbust = 817, waist = 760, hip = 1000, neck = 326;
  double shoulder_width = 365;  ///< from point to point
  double upper_arm = 271, wrist = 156, arm_length = 515;
  double thigh = 579, inseam = 761;
  double nape_height = 1430, armpit_height = 1290, bust_height = 1213, waist_height = 1083, hip_height = 877;

  double waist_to_hip() const { return waist_height - hip_height; }
  double nape_to_waist() const { return nape_height - waist_height; }
  double rise() const { return waist_height - inseam; }  ///< from the waist down to the crotch, straight
};

/// What `taken` says. Error: "draft.measure" with the measure that could not be taken, or with one that no
/// garment is drafted for.
Result<Wearer> wearer_of(const measure::BodyMeasures& taken);

}  // namespace toile::draft
