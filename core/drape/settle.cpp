#include "core/drape/settle.h"

#include <algorithm>
#include <cmath>

namespace toile {

namespace {
constexpr double kWindow = 0.05;  // s
constexpr std::size_t kQuietWindows = SettleState::kMostWindows;
}  // namespace

SettleWatch::SettleWatch(double time_step, double speed)
    : time_step_(time_step),
      speed_(speed),
      window_steps_(std::max(1, static_cast<int>(kWindow / time_step))) {}

void SettleWatch::restart(std::span<const Vec3> x) {
  seen_ = {};
  seen_.window_start.assign(x.begin(), x.end());
}

void SettleWatch::observe(std::span<const Vec3> x) {
  if (seen_.window_start.size() != x.size()) restart(x);
  if (++seen_.step % window_steps_ != 0) return;
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 d = x[i] - seen_.window_start[i];
    sum += dot(d, d), most = std::max(most, dot(d, d));
  }
  const double seconds = window_steps_ * time_step_;
  if (seen_.rms.size() == SettleState::kMostWindows) seen_.rms.erase(seen_.rms.begin());
  seen_.rms.push_back(x.empty() ? 0 : std::sqrt(sum / static_cast<double>(x.size())) / seconds);
  seen_.max_speed = std::sqrt(most) / seconds;
  seen_.window_start.assign(x.begin(), x.end());
}

bool SettleWatch::settled() const {
  if (seen_.rms.size() < kQuietWindows) return false;
  const double* last = seen_.rms.data() + seen_.rms.size() - kQuietWindows;
  const bool slow = std::all_of(last, last + kQuietWindows, [&](double v) { return v < speed_; });
  return slow && last[2] + last[3] <= 1.2 * (last[0] + last[1]);
}

}  // namespace toile
