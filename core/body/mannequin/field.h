#pragma once

#include <vector>

#include "core/body/mannequin/field_sample.h"
#include "core/body/mannequin/loft.h"
#include "core/body/mannequin/shape.h"

namespace toile::mannequin {

/// A body as an implicit surface: lofts joined by smooth unions, then sculpted by strokes. Lengths are
/// fractions of the stature; floor at y = 0, mid-line at x = 0, front towards +z.
class BodyField {
 public:
  explicit BodyField(const BodyShape& shape);

  FieldSample at(Vec3 p) const;

  /// Wanted edge length at p as a fraction of the trunk's: finer at hands, feet and head. `detail`, 0 to 1,
  /// says how much of the triangles the face may have.
  double fineness(Vec3 p, double detail) const;

  double half_breadth() const { return half_breadth_; }  ///< of the box around everything
  const PlacedFigure& placed() const { return figure_; }

 private:
  struct Part {
    Loft loft;
    Vec3 origin, u, v, t;
    double blend;  ///< radius of the union with what came before
  };
  struct Ridge {
    Vec3 a, axis;
    double per_length2, radius, height;
  };

  FieldSample half_at(Vec3 p) const;
  static void join(FieldSample& body, const Part& part, Vec3 p);
  void sculpt(FieldSample& body, Vec3 p) const;
  void sort_ridges();

  PlacedFigure figure_;
  std::vector<Part> parts_;  ///< torso and leg first
  std::vector<Ridge> ridges_;
  std::vector<std::vector<Index>> ridges_by_height_;
  double half_breadth_ = 0, chin_ = 0, crotch_ = 0, nose_z_ = 0;
};

}  // namespace toile::mannequin
