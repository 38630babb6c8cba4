#include "core/drape/rayleigh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace toile::drape {

namespace {
/// Share of the critical damping. The quotient sees the fast swings rather than the slow ones, on which a
/// garment's hem waits: critical for the fast would be far too thick for those.
constexpr double kShareOfCritical = 0.3;
constexpr double kLeastDamping = 2, kMostDamping = 16;  // 1/s
/// Nothing that cloth does is taken to be slower than this: a pendulum of 40 cm.
constexpr double kSlowest = 5;  // 1/s
}  // namespace

double rayleigh_rate(std::span<const float> first, std::span<const float> second,
                     std::span<const float> third, double seconds, double damping) {
  const double bent = 1 / (seconds * seconds), slowed = damping / (2 * seconds);
  double pull = 0, motion = 0;
  for (std::size_t i = 0; i < second.size(); ++i) {
    const double u0 = first[i], u1 = second[i], u2 = third[i];
    pull -= u1 * ((u2 - 2 * u1 + u0) * bent + (u2 - u0) * slowed);
    motion += u1 * u1;
  }
  return motion > 0 && pull > 0 ? std::sqrt(pull / motion) : 0;
}

double calming_damping(double rate) {
  return std::clamp(2 * kShareOfCritical * rate, kLeastDamping, kMostDamping);
}

double way_left(double speed, double damping, double rate) {
  const double swing = std::max(rate, kSlowest);
  return speed * (damping + swing) / (swing * swing);
}

}  // namespace toile::drape
