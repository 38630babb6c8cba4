#pragma once

#include "core/body/body_field.h"

namespace toile {

/// Girths as fractions of the stature.
struct TrunkTargets {
  double bust = kBustGirth, waist = kWaistGirth, hip = kHipGirth;
};

/// Bust and hip as the widest girth, waist as the narrowest, of the field itself, looked for where
/// trunk_girths() looks. Hull perimeters of slices of the trunk without arms.
TrunkTargets trunk_girths(const BodyField& field);

/// The shape whose field has these girths, arms as in `start`. Sections are scaled by asked over got until
/// they meet; extremes of asked girths may leave a rest, which the caller sees on the finished mesh.
BodyShape solve_shape(const TrunkTargets& targets, BodyShape start);

/// One correction of a shape: each factor times asked over got.
BodyShape corrected(BodyShape shape, const TrunkTargets& asked, const TrunkTargets& got);

}  // namespace toile
