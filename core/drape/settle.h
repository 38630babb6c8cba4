#pragma once
// When is cloth at rest? Speeds are measured over windows of a twentieth of a second: over single steps they
// carry the jitter of contacts, and a displacement alone would pass cloth that shakes on the spot.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile {

class SettleWatch {
 public:
  /// `speed`: RMS speed (m/s) under which the cloth counts as at rest.
  SettleWatch(double time_step, double speed);

  /// Forgets what was seen, e.g. when a hold is released.
  void restart(std::span<const Vec3> x);
  /// Takes note of the positions after a step.
  void observe(std::span<const Vec3> x);

  /// Slow in each of the last four windows, and not speeding up.
  bool settled() const;
  double rms_speed() const { return rms_.empty() ? 0 : rms_.back(); }  ///< m/s, of the last full window
  double max_speed() const { return max_speed_; }

 private:
  double time_step_, speed_;
  int window_steps_, step_ = 0;
  std::vector<Vec3> window_start_;
  std::vector<double> rms_;
  double max_speed_ = 0;
};

}  // namespace toile
