#pragma once
// Level cuts through a standing body's trunk, from the thighs to the mouth: what the tape looks for on the
// trunk, it looks for in these.

#include <cstddef>
#include <vector>

#include "core/body/measure/mesh_cut.h"

namespace toile::measure {

/// What the tape sees in one level plane, without arms that stand off. Metres.
struct TrunkLevel {
  double y = 0, girth = 0;
  double half = 0;             ///< half the breadth about the middle plane
  double front = 0, back = 0;  ///< extreme z
};

/// Keeps a reference to the cutter.
class TrunkLevels {
 public:
  /// Cuts a body of `stature` m on y = 0, whose middle plane is x = `middle`. `level` cuts upwards.
  TrunkLevels(const MeshCutter& level, double stature, double middle);

  double stature() const { return stature_; }
  double middle() const { return middle_; }
  double step() const;  ///< m from one level to the next

  const std::vector<TrunkLevel>& all() const { return levels_; }  ///< upwards, evenly
  std::size_t index_of(double y) const;                           ///< of the level at y or next below it

  /// A cut of its own at y, between the levels as well.
  TrunkLevel at(double y) const;
  std::vector<Vec3> points_at(double y) const;

  /// The level above `low` and up to `high` whose girth is better than any other's, the lowest of equals.
  template <typename Better>
  TrunkLevel extreme(double low, double high, Better better) const {
    TrunkLevel best = at(low);
    for (const TrunkLevel& l : levels_)
      if (l.y > low && l.y <= high && better(l.girth, best.girth)) best = l;
    return best;
  }

 private:
  const MeshCutter& level_;
  double stature_, middle_;
  std::vector<TrunkLevel> levels_;
};

}  // namespace toile::measure
