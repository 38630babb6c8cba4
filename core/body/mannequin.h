#pragma once

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"

namespace toile {

/// A standing woman in A-pose. Lengths in metres; girths as a tape takes them: bust and hip the widest place,
/// waist the narrowest.
struct MannequinSettings {
  double height = 1.70;                   ///< 1.2 to 2.2
  double bust = 0.90;                     ///< 0.44 to 0.75 of the height
  double waist = 0.72;                    ///< 0.33 to 0.70 of the height
  double hip = 0.96;                      ///< 0.47 to 0.75 of the height
  double arm_angle = 0.7853981633974483;  ///< radians between a hanging arm and this one, 30° to 60°
  Index triangle_count = 3300;            ///< 1,000 to 60,000; met exactly, or off by one when odd
};

/// The mannequin's skin: closed, manifold, outward triangles of even size, feet on y = 0, facing +z. Equal
/// settings give equal bytes. Errors: "mannequin.setting" (out of range), "mannequin.girths" (the three
/// girths cannot be met together to 5 mm).
Result<TriangleMesh> make_mannequin(const MannequinSettings& settings);

}  // namespace toile
