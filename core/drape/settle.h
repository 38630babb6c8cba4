#pragma once
// When is cloth at rest? Speeds are measured over windows of a twentieth of a second: over single steps they
// carry the jitter of contacts, and a displacement alone would pass cloth that shakes on the spot. The same
// windows tell how fast it swings, and so how much damping it wants (rayleigh.h).

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/types.h"

namespace toile::drape {

/// What a SettleWatch remembers.
struct SettleState {
  static constexpr std::size_t kMostWindows = 4;  ///< as many as settled() looks at

  int step = 0;                    ///< steps since the last restart
  std::vector<Vec3> window_start;  ///< m
  /// m, three coordinates a vertex: the ways of up to kMostWindows − 1 full windows before the newest, one
  /// window after the other, the oldest first.
  std::vector<float> ways;
  std::vector<double> rms;    ///< m/s, of the newest windows, the last one last
  double max_speed = 0;       ///< m/s
  double drift = 0;           ///< m/s RMS, over kMostWindows windows; what swings to and fro does not count
  double usual_drift = 0;     ///< m/s, what 99 vertices of a hundred stayed under over the same windows
  std::vector<double> rates;  ///< 1/s, of the newest kMostWindows windows that told one

  std::vector<Vec3> mark;  ///< m, where the cloth was when the newest long window began
  /// m/s over the last full long window, RMS and what 99 of a hundred stayed under; negative before there is
  /// one.
  double long_drift = -1, long_usual_drift = -1;
};

class SettleWatch {
 public:
  /// `speed`: RMS speed (m/s) under which the cloth counts as at rest.
  SettleWatch(double time_step, double speed);

  /// Forgets what was seen, e.g. when a hold is released.
  void restart(std::span<const Vec3> x);
  /// Begins its short windows anew, when cloth is stopped or let go; the long one goes on.
  void look_anew(std::span<const Vec3> x);
  /// Takes note of the positions after a step that was damped so (1/s).
  void observe(std::span<const Vec3> x, double damping);

  /// Slow in each of the last four windows, not speeding up, and with hardly any way left under this damping
  /// (1/s): folds that creep through a thick medium are slow, and go far once it is gone. Or hardly anywhere
  /// else than two seconds before, though it is not still: gathered frills flutter in place for ever.
  /// `calm`: share of the speed at which cloth counts as at rest.
  bool settled(double damping, double calm = 1) const;
  /// The latter: hardly anywhere else than two seconds before.
  bool flutters_in_place(double calm = 1) const;
  /// 1/s, under which the cloth comes to rest soon.
  double damping() const;
  double rms_speed() const {
    return seen_.rms.empty() ? 0 : seen_.rms.back();
  }  ///< m/s, of the last full window
  double max_speed() const { return seen_.max_speed; }

  const SettleState& state() const { return seen_; }
  void restore(SettleState state) { seen_ = std::move(state); }

 private:
  double slowest_rate() const;

  double time_step_, speed_;
  int window_steps_;
  SettleState seen_;
};

}  // namespace toile::drape
