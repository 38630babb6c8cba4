#pragma once

#include <vector>

#include "core/body/body_tables.h"
#include "core/body/field_sample.h"
#include "core/body/loft.h"

namespace toile {

/// How the figure of the tables is stretched: factors on the trunk's sections at three heights (1 is the
/// figure of reference), and how far the arms stand off.
struct BodyShape {
  double bust = 1, waist = 1, hip = 1;
  double arm_sine = 0.7071;  ///< sine of the angle between a hanging arm and this one
};

/// The female figure as an implicit surface: lofts joined by smooth unions. Lengths are fractions of the
/// stature; floor at y = 0, mid-line at x = 0, front towards +z.
class BodyField {
 public:
  explicit BodyField(const BodyShape& shape);

  /// The whole body.
  FieldSample at(Vec3 p) const;
  /// Torso and legs only: what a tape around the trunk goes around, without arms in its way.
  FieldSample trunk_at(Vec3 p) const;

  /// Wanted edge length at p as a fraction of the trunk's: finer at hands, feet and head.
  double fineness(Vec3 p) const;

  double half_breadth() const { return half_breadth_; }  ///< of the box around everything

 private:
  struct Part {
    Loft loft;
    Vec3 origin, u, v, t;
    double blend;  ///< radius of the union with what came before
  };

  FieldSample half_at(Vec3 p, bool trunk_only) const;
  static void join(FieldSample& body, const Part& part, Vec3 p);

  std::vector<Part> parts_;  ///< trunk parts first
  size_t trunk_parts_ = 0;
  SoftEllipsoid bust_, buttock_;
  Vec3 shoulder_, arm_;  ///< joint, direction
  Vec3 thumb_[2];
  double half_breadth_ = 0;
};

}  // namespace toile
