#include "core/drape/settle.h"

#include <algorithm>
#include <cmath>

#include "core/drape/rayleigh.h"

namespace toile::drape {

namespace {
constexpr double kWindow = 0.05;  // s
constexpr std::size_t kQuietWindows = SettleState::kMostWindows;
/// What way may be left, as a time at the speed of rest, in the RMS over the vertices; and to 99 of a
/// hundred: a corner that creeps is little of the cloth, but goes far.
constexpr double kWayLeft = 0.12, kUsualWayLeft = 0.3;  // s

/// Over so many windows cloth that flutters in place is watched. It may go this share of the speed of rest,
/// in the RMS and for 99 of a hundred, which is no more than kWayLeft and kUsualWayLeft allow slow cloth
/// under the least damping; meanwhile it may shake at so many times that speed.
constexpr int kLongWindows = 40;
constexpr double kLongDrift = 0.2, kLongUsualDrift = 1, kFlutter = 2;

struct Sizes {
  double rms = 0, usual = 0, most = 0;  ///< m; usual: what 99 of a hundred stay under
};

Sizes sizes_of(std::span<const float> ways) {
  std::vector<double> squares(ways.size() / 3);
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const Vec3 d{ways[3 * i], ways[3 * i + 1], ways[3 * i + 2]};
    squares[i] = dot(d, d);
    sum += squares[i];
    most = std::max(most, squares[i]);
  }
  if (squares.empty()) return {};
  const auto usual = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() - 1 - squares.size() / 100);
  std::nth_element(squares.begin(), usual, squares.end());
  return {std::sqrt(sum / static_cast<double>(squares.size())), std::sqrt(*usual), std::sqrt(most)};
}

std::vector<float> ways_between(std::span<const Vec3> from, std::span<const Vec3> to) {
  std::vector<float> ways;
  ways.reserve(3 * to.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    const Vec3 d = to[i] - from[i];
    for (const double c : {d.x, d.y, d.z}) ways.push_back(static_cast<float>(c));
  }
  return ways;
}

/// Keeps the newest.
void note(std::vector<double>& values, double value) {
  if (values.size() == kQuietWindows) values.erase(values.begin());
  values.push_back(value);
}
}  // namespace

SettleWatch::SettleWatch(double time_step, double speed)
    : time_step_(time_step),
      speed_(speed),
      window_steps_(std::max(1, static_cast<int>(kWindow / time_step))) {}

void SettleWatch::restart(std::span<const Vec3> x) {
  seen_ = {};
  seen_.window_start.assign(x.begin(), x.end());
  seen_.mark = seen_.window_start;
}

void SettleWatch::look_anew(std::span<const Vec3> x) {
  seen_.window_start.assign(x.begin(), x.end());
  seen_.ways.clear();
  seen_.rms.clear();
  seen_.rates.clear();
}

void SettleWatch::observe(std::span<const Vec3> x, double damping) {
  if (seen_.window_start.size() != x.size()) restart(x);
  if (++seen_.step % window_steps_ != 0) return;
  const double seconds = window_steps_ * time_step_;
  if (seen_.step % (kLongWindows * window_steps_) == 0) {
    const Sizes far = sizes_of(ways_between(seen_.mark, x));
    seen_.long_drift = far.rms / (kLongWindows * seconds);
    seen_.long_usual_drift = far.usual / (kLongWindows * seconds);
    seen_.mark.assign(x.begin(), x.end());
  }
  const std::vector<float> newest = ways_between(seen_.window_start, x);
  seen_.window_start.assign(x.begin(), x.end());
  const Sizes now = sizes_of(newest);
  note(seen_.rms, now.rms / seconds);
  seen_.max_speed = now.most / seconds;

  const std::size_t count = newest.size(), before = count > 0 ? seen_.ways.size() / count : 0;
  const auto window = [&](std::size_t k) {
    return std::span<const float>(seen_.ways).subspan(k * count, count);
  };
  if (before >= 2) {
    note(seen_.rates, rayleigh_rate(window(before - 2), window(before - 1), newest, seconds, damping));
  }
  if (before == kQuietWindows - 1) {
    std::vector<float> whole = newest;
    for (std::size_t k = 0; k < before; ++k) {
      const std::span<const float> way = window(k);
      for (std::size_t i = 0; i < count; ++i) whole[i] += way[i];
    }
    const Sizes drift = sizes_of(whole);
    const double row = kQuietWindows * seconds;
    seen_.drift = drift.rms / row;
    seen_.usual_drift = drift.usual / row;
    seen_.ways.erase(seen_.ways.begin(), seen_.ways.begin() + static_cast<std::ptrdiff_t>(count));
  }
  seen_.ways.insert(seen_.ways.end(), newest.begin(), newest.end());
}

/// The slowest of late: fast swings come and go, and a slow one waits behind them.
double SettleWatch::slowest_rate() const {
  return seen_.rates.empty() ? 0 : *std::min_element(seen_.rates.begin(), seen_.rates.end());
}

double SettleWatch::damping() const { return calming_damping(slowest_rate()); }

bool SettleWatch::flutters_in_place(double calm) const {
  const double speed = calm * speed_;
  return seen_.rms.size() == kQuietWindows && seen_.long_drift >= 0 &&
         seen_.long_drift <= kLongDrift * speed && seen_.long_usual_drift <= kLongUsualDrift * speed &&
         std::all_of(seen_.rms.begin(), seen_.rms.end(), [&](double v) { return v < kFlutter * speed; });
}

bool SettleWatch::settled(double damping, double calm) const {
  if (seen_.rms.size() < kQuietWindows) return false;
  const std::vector<double>& last = seen_.rms;
  const double speed = calm * speed_;
  if (flutters_in_place(calm)) return true;
  const bool slow = std::all_of(last.begin(), last.end(), [&](double v) { return v < speed; });
  return slow && way_left(seen_.drift, damping, slowest_rate()) <= kWayLeft * speed &&
         way_left(seen_.usual_drift, damping, 0) <= kUsualWayLeft * speed &&
         last[2] + last[3] <= 1.2 * (last[0] + last[1]);
}

}  // namespace toile::drape
