#include "core/drape/settle.h"

#include <algorithm>
#include <cmath>

namespace toile {

namespace {
constexpr double kWindow = 0.05;  // s
constexpr std::size_t kQuietWindows = SettleState::kMostWindows;
/// Of the speed at which cloth counts as at rest, what may be drift.
constexpr double kDriftShare = 0.3;
/// The same for 99 vertices of a hundred: a corner that creeps is little of the cloth, but goes far.
constexpr double kUsualDriftShare = 0.6;

struct Speeds {
  double rms = 0, most = 0;
};

/// What 99 of a hundred vertices stay under.
double usual_speed(std::span<const Vec3> from, std::span<const Vec3> to, double seconds) {
  if (to.empty()) return 0;
  std::vector<double> squares;
  squares.reserve(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) squares.push_back(dot(to[i] - from[i], to[i] - from[i]));
  const auto at = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() - 1 - squares.size() / 100);
  std::nth_element(squares.begin(), at, squares.end());
  return std::sqrt(*at) / seconds;
}

Speeds speeds_between(std::span<const Vec3> from, std::span<const Vec3> to, double seconds) {
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const Vec3 d = to[i] - from[i];
    sum += dot(d, d), most = std::max(most, dot(d, d));
  }
  const double rms = to.empty() ? 0 : std::sqrt(sum / static_cast<double>(to.size()));
  return {rms / seconds, std::sqrt(most) / seconds};
}
}  // namespace

SettleWatch::SettleWatch(double time_step, double speed)
    : time_step_(time_step),
      speed_(speed),
      window_steps_(std::max(1, static_cast<int>(kWindow / time_step))) {}

void SettleWatch::restart(std::span<const Vec3> x) {
  seen_ = {};
  seen_.window_start.assign(x.begin(), x.end());
  seen_.drift_start = seen_.window_start;
}

void SettleWatch::observe(std::span<const Vec3> x) {
  if (seen_.window_start.size() != x.size()) restart(x);
  if (++seen_.step % window_steps_ != 0) return;
  const double seconds = window_steps_ * time_step_;
  const Speeds speeds = speeds_between(seen_.window_start, x, seconds);
  if (seen_.rms.size() == SettleState::kMostWindows) seen_.rms.erase(seen_.rms.begin());
  seen_.rms.push_back(speeds.rms);
  seen_.max_speed = speeds.most;
  seen_.window_start.assign(x.begin(), x.end());
  constexpr int kRow = static_cast<int>(kQuietWindows);
  if (seen_.step % (kRow * window_steps_) != 0) return;
  seen_.drift = speeds_between(seen_.drift_start, x, kRow * seconds).rms;
  seen_.usual_drift = usual_speed(seen_.drift_start, x, kRow * seconds);
  seen_.drift_start = seen_.window_start;
}

bool SettleWatch::settled() const {
  if (seen_.rms.size() < kQuietWindows) return false;
  const double* last = seen_.rms.data() + seen_.rms.size() - kQuietWindows;
  const bool slow = std::all_of(last, last + kQuietWindows, [&](double v) { return v < speed_; });
  return slow && seen_.drift <= kDriftShare * speed_ && seen_.usual_drift <= kUsualDriftShare * speed_ &&
         last[2] + last[3] <= 1.2 * (last[0] + last[1]);
}

}  // namespace toile
