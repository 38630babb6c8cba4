#pragma once

#include "core/base/result.h"
#include "core/body/mannequin/shape.h"
#include "core/body/measure/measures.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::mannequin {

inline constexpr double kQuarterTurn = 1.5707963267948966;

/// A standing person made from measures. Lengths in metres; girths and lengths as measure_body() takes them.
struct MannequinSettings {
  Sex sex = Sex::kFemale;
  measure::MeasureSet asked;            ///< what is not asked for follows from proportions
  double arm_angle = kQuarterTurn / 2;  ///< radians between a hanging arm and this one: 30° to 60°, or 90°
  /// 1,000 to 60,000; met exactly, or off by one when odd. With fewer than 2,000 some bodies cannot be told
  /// to the millimetre, and are refused.
  Index triangle_count = 4562;
};

struct Mannequin {
  /// Closed, manifold, outward triangles of even size, feet on y = 0, facing +z.
  geometry::TriangleMesh mesh;
  measure::MeasureSet wanted;      ///< what was asked for, and what proportions gave for the rest
  measure::BodyMeasures measures;  ///< as the tape takes them back
  BodyJoints joints;               ///< m, of the side of +x
  BodyShape shape;                 ///< of which the mesh was made
};

/// Every girth asked for is met to 5 mm and every length to 10 mm, or it is an error. Equal settings give
/// equal bytes. Errors: "mannequin.setting" (out of range; place: the setting), "mannequin.measures" (the
/// measures do not go together; place: the one that is missed most).
Result<Mannequin> make_mannequin(const MannequinSettings& settings);

}  // namespace toile::mannequin
