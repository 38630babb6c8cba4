#include "core/body/measure/trunk_levels.h"

#include <algorithm>
#include <cmath>

#include "core/body/measure/cut_points.h"
#include "core/geometry/convex_hull.h"

namespace toile::measure {
namespace {

// Shares of the stature. A level is 3 mm above the last on a grown-up.
constexpr double kLevelStep = 0.0018;
constexpr double kTrunkLow = 0.36, kTrunkHigh = 0.86;

}  // namespace

TrunkLevels::TrunkLevels(const MeshCutter& level, double stature, double middle)
    : level_(level), stature_(stature), middle_(middle) {
  for (double y = kTrunkLow * stature_; y < kTrunkHigh * stature_; y += step()) levels_.push_back(at(y));
}

double TrunkLevels::step() const { return kLevelStep * stature_; }

std::size_t TrunkLevels::index_of(double y) const {
  const double i = (y - levels_.front().y) / step();
  return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(levels_.size() - 1)));
}

std::vector<Vec3> TrunkLevels::points_at(double y) const { return middle_points(level_.at(y), middle_); }

TrunkLevel TrunkLevels::at(double y) const {
  const std::vector<Vec3> points = points_at(y);
  TrunkLevel l{y, geometry::hull_perimeter(flat(points)), 0, -HUGE_VAL, HUGE_VAL};
  for (const Vec3& p : points) {
    l.half = std::max(l.half, std::abs(p.x - middle_));
    l.front = std::max(l.front, p.z);
    l.back = std::min(l.back, p.z);
  }
  return l;
}

}  // namespace toile::measure
