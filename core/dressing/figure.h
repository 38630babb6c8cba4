#pragma once
// The body that cloth is kept out of while it is put on: drawn in at first, with room around hands and feet.

#include <optional>

#include "core/body/measure/figure.h"
#include "core/dressing/distance_field.h"

namespace toile::dressing {

/// Hands and feet as cloth should pass them: wider than they are, since fingers and toes catch it.
class Mittens {
 public:
  explicit Mittens(const measure::BodyFigure& figure);
  /// m that cloth is kept off the skin there, beside the usual.
  double room_at(Vec3 p) const;

 private:
  struct End {
    Vec3 from, along;  ///< where the limb's end begins, and which way it goes on (unit vector)
    double reach;      ///< m
  };
  std::array<End, 4> ends_;
};

/// What one pass keeps cloth out of. `field` and `mittens` must outlive it.
struct SlimFigure {
  const DistanceField* field = nullptr;
  const Mittens* mittens = nullptr;
  double slim = 0;       ///< share of its half thickness by which the body is drawn in
  double margin = 4e-3;  ///< m off its skin, and off the floor
  double floor = -1e9;   ///< m, height of the ground

  /// m, from where cloth must not be nearer; negative: it must move out by so much.
  double clearance(Vec3 p) const;
  Vec3 above_floor(Vec3 p) const;
  /// The nearest place with clearance, about: along the way out, `most` m at most; never under the floor.
  Vec3 moved_out(Vec3 p, double most) const;
};

}  // namespace toile::dressing
