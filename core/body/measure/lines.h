#pragma once
// Closed lines around a standing body, as a tape would lie: the waistline, the neckline, a wrist. Cloth is
// attached to them.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/body/measure/landmarks.h"

namespace toile::measure {

/// "bust", "underbust", "waist", "high_hip", "hip": level, around the trunk, at the height of the landmarks
/// of that name. "neck": level, where it is slimmest; "neckline": slanted, through the pit of the neck and
/// the nape. "upper_arm_left", "elbow_right", "wrist_…", "thigh_…", "knee_…", "ankle_…": square to the limb.
const std::vector<std::string>& body_line_names();

/// The line's corners, m: a convex loop over hollows, counter-clockwise seen from above (from the trunk along
/// limbs), `away` (m) outside the skin, corners at least 8 mm apart. `up` (m) shifts the line's plane
/// upwards, along limbs towards the trunk. Errors: body.unknown_line, body.no_line where the plane misses
/// that part.
Result<std::vector<Vec3>> body_line(const PlaneCutter& cutter, const BodyFigure& figure,
                                    std::string_view name, double up = 0, double away = 0);

/// m, around a closed line.
double length_of_loop(const std::vector<Vec3>& loop);

}  // namespace toile::measure
