// Positions to the stream's grid and back.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.h"
#include "proto/cpp/frame_codec.h"

namespace toile::proto {
namespace {

constexpr double kFinestStep = 1e-4;      // m: half of it is below what anyone sees of cloth
constexpr double kCoarseningUnit = 1e-5;  // m: wider steps are whole multiples, so that they read well
constexpr double kRoom = 1.0;             // m: a garment falls and swings less than that
constexpr double kReach = std::numeric_limits<std::int16_t>::max();

/// Middle of an interval, on a whole millimetre.
double middle(double lo, double hi) { return std::round((lo / 2 + hi / 2) * 1e3) / 1e3; }

std::int16_t nearest(double steps) {
  constexpr double low = std::numeric_limits<std::int16_t>::min(), high = kReach;
  if (std::isnan(steps)) return 0;
  const double inside = std::clamp(steps, low, high);
  // From −32768 everything is positive, and cutting off is rounding down.
  const double half_up = inside - low + 0.5;
  return static_cast<std::int16_t>(static_cast<int>(half_up) + static_cast<int>(low));
}

}  // namespace

FrameGrid grid_for(Vec3 lo, Vec3 hi) {
  if (!is_finite(lo) || !is_finite(hi)) return {};
  FrameGrid grid{.origin = {middle(lo.x, hi.x), middle(lo.y, hi.y), middle(lo.z, hi.z)}, .step = kFinestStep};
  const Vec3 up = hi - grid.origin, down = grid.origin - lo;
  const double half = std::max({up.x, up.y, up.z, down.x, down.y, down.z}) + kRoom;
  if (half > kFinestStep * kReach) grid.step = std::ceil(half / kReach / kCoarseningUnit) * kCoarseningUnit;
  return grid;
}

std::vector<std::int16_t> quantise(std::span<const Vec3> positions, const FrameGrid& grid) {
  const double per_step = 1 / grid.step;
  std::vector<std::int16_t> numbers(3 * positions.size());
  std::int16_t* out = numbers.data();
  for (const Vec3& p : positions) {
    const Vec3 steps = (p - grid.origin) * per_step;
    *out++ = nearest(steps.x);
    *out++ = nearest(steps.y);
    *out++ = nearest(steps.z);
  }
  return numbers;
}

std::vector<Vec3> dequantise(std::span<const std::int16_t> numbers, const FrameGrid& grid) {
  TOILE_CHECK(numbers.size() % 3 == 0);
  std::vector<Vec3> positions(numbers.size() / 3);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 steps{1.0 * numbers[3 * v], 1.0 * numbers[3 * v + 1], 1.0 * numbers[3 * v + 2]};
    positions[v] = grid.origin + grid.step * steps;
  }
  return positions;
}

}  // namespace toile::proto
