#include "core/drape/settle.h"

#include <algorithm>
#include <cmath>

namespace toile {

namespace {
constexpr double kWindow = 0.05;  // s
constexpr int kQuietWindows = 4;
}  // namespace

SettleWatch::SettleWatch(double time_step, double speed)
    : time_step_(time_step),
      speed_(speed),
      window_steps_(std::max(1, static_cast<int>(kWindow / time_step))) {}

void SettleWatch::restart(std::span<const Vec3> x) {
  step_ = 0;
  rms_.clear();
  max_speed_ = 0;
  window_start_.assign(x.begin(), x.end());
}

void SettleWatch::observe(std::span<const Vec3> x) {
  if (window_start_.size() != x.size()) restart(x);
  if (++step_ % window_steps_ != 0) return;
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 d = x[i] - window_start_[i];
    sum += dot(d, d), most = std::max(most, dot(d, d));
  }
  const double seconds = window_steps_ * time_step_;
  rms_.push_back(x.empty() ? 0 : std::sqrt(sum / static_cast<double>(x.size())) / seconds);
  max_speed_ = std::sqrt(most) / seconds;
  window_start_.assign(x.begin(), x.end());
}

bool SettleWatch::settled() const {
  if (rms_.size() < kQuietWindows) return false;
  const double* last = rms_.data() + rms_.size() - kQuietWindows;
  const bool slow = std::all_of(last, last + kQuietWindows, [&](double v) { return v < speed_; });
  return slow && last[2] + last[3] <= 1.2 * (last[0] + last[1]);
}

}  // namespace toile
