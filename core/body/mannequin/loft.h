#pragma once
// A loft is a row of rounded sections along a straight line: a limb, the trunk, a foot.

#include <span>
#include <vector>

#include "core/body/mannequin/field_sample.h"

namespace toile::mannequin {

/// One section across the line at `t`. Its half width runs along u; along v it may be deeper in front (v > 0)
/// than behind. Squareness mixes the L2 norm (0, an ellipse) with the L4 norm (1, nearly a rectangle), which
/// does a superellipse's work with square roots only: those round alike on every processor.
struct LoftSection {
  double t = 0;
  double u = 0, v = 0;  ///< centre
  double half = 0, front = 0, back = 0;
  double square_front = 0, square_back = 0;
};

struct LoftShape {
  double smoothing = 0;  ///< standard deviation, in units of t, of the blur along the line
  double cap_start = 0;  ///< length in which the start closes to a dome
  double cap_end = 0;
};

class Loft {
 public:
  /// REQUIRES two rows or more with rising t. Rows are joined by a monotone cubic, then blurred.
  Loft(std::span<const LoftSection> rows, const LoftShape& shape);

  /// The loft's field at (u, v, t), divided by its gradient's length so that blends come out even. The
  /// gradient is in the same frame.
  FieldSample at(Vec3 uvt) const;

  double start() const { return start_; }
  double end() const { return end_; }
  /// Greatest distance of any section's rim from the line, used to skip far lofts.
  double reach() const { return reach_; }

 private:
  LoftSection section(double t, LoftSection* slope) const;

  double start_, end_, step_;
  LoftShape shape_;
  std::vector<LoftSection> table_;
  double reach_ = 0;
};

}  // namespace toile::mannequin
