#pragma once
// What goes over the shoulders while a garment is put on. Nothing holds it there: cloth that comes back to
// its length rises from where it fits tightly, the growing figure pushes it down its slopes, and straps that
// begin higher up or farther out than they hang slide off.

#include <optional>
#include <span>
#include <vector>

#include "core/body/measure/figure.h"
#include "core/dressing/certificate.h"
#include "core/dressing/figure.h"
#include "core/dressing/wearer.h"
#include "core/sewing/assembly.h"

namespace toile::dressing {

/// Whether a place is above a shoulder's slope, from beside the neck to somewhat beyond its outer end.
bool is_over_shoulder(const measure::BodyFigure& figure, Vec3 p);

/// Whether any of the cloth is.
bool goes_over_shoulders(const measure::BodyFigure& figure, std::span<const Vec3> x);

/// How far cloth that goes over a shoulder may come down until some of it lies on one, m. Nothing where no
/// cloth is above a shoulder: a skirt, a strapless bodice. `body` is the whole figure, not drawn in.
std::optional<double> room_over_shoulders(const measure::BodyFigure& figure, const SlimFigure& body,
                                          std::span<const Vec3> x);

/// Whether any cloth lies on the ridge of a shoulder, nearer to the neck than its outer end.
bool lies_on_shoulder(const measure::BodyFigure& figure, std::size_t side, std::span<const Vec3> x);

/// Whether a border goes around the arm of a side alone.
bool has_armhole(std::span<const WornRing> rings, std::size_t side);

/// How many of the shoulders are bare that a garment with an armhole there was placed above. `x`: m, one a
/// vertex of the assembly; `rings` are those of x.
int bared_shoulders(const sewing::Assembly& assembly, const measure::BodyFigure& figure,
                    std::span<const WornRing> rings, std::span<const Vec3> x);

/// How far a garment is off the middle: half of what its cloth begins farther from the neck on the wearer's
/// left than on the right, m. None where it is over one shoulder alone, or close enough to the neck on both
/// to stay on.
double off_centre(const measure::BodyFigure& figure, std::span<const Vec3> x);

/// Two hands at a garment's shoulders. `wearer` must outlive it.
class OnShoulders {
 public:
  /// `vertex_of`: shape vertex, under `count`, of each vertex of the assembly.
  OnShoulders(const sewing::Assembly& assembly, const Wearer& wearer, std::span<const Index> vertex_of,
              Index count);

  /// Brings what is over a shoulder a little back towards the neck, as near as it was placed. `x`: m, one a
  /// shape vertex.
  void hold_in(std::vector<Vec3>& x) const;
  /// Brings the garment a little down, as long as there is room over both shoulders. Sleeves stay.
  void let_down(std::vector<Vec3>& x) const;
  /// Shifts what hangs above the waist a little sideways where it hangs more on one shoulder than the other.
  void centre(std::vector<Vec3>& x) const;

 private:
  const Wearer& wearer_;
  std::vector<double> aside_;  ///< m from the middle, where each vertex was placed
  std::vector<bool> hangs_;    ///< from the shoulders; sleeves are drawn along
};

}  // namespace toile::dressing
