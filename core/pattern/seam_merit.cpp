// What speaks for a pair of runs by itself.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/pattern/seam_gluing.h"

namespace toile {
namespace {

constexpr std::size_t kSamples = SeamRun::kSamples;

struct Step {
  double at, value;
};

/// Straight lines through the steps, level outside them.
template <std::size_t N>
double along_steps(const Step (&steps)[N], double x) {
  if (x <= steps[0].at) return steps[0].value;
  for (std::size_t i = 1; i < N; ++i) {
    if (x > steps[i].at) continue;
    const Step &p = steps[i - 1], &q = steps[i];
    return p.value + (x - p.at) / (q.at - p.at) * (q.value - p.value);
  }
  return steps[N - 1].value;
}

double bend_of(const SeamRun& run) {
  const auto [low, high] = std::minmax_element(run.turn.begin(), run.turn.end());
  return *high - *low;
}

/// Mean difference in degrees between the turning of a and that of b run backwards, times `sign`.
double bend_difference(const SeamRun& a, const SeamRun& b, double sign) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < kSamples; ++k) {
    const double back = sign * (b.turn[kSamples - 2] - b.turn[kSamples - 2 - k]);
    sum += std::abs(a.turn[k] - back);
  }
  return sum / (kSamples - 1);
}

double shape_merit(const SeamRun& a, const SeamRun& b) {
  constexpr double kCurved = 25, kStraight = 8, kRound = 60, kLike = 8;  // degrees
  const double bend_a = bend_of(a), bend_b = bend_of(b);
  if (std::min(bend_a, bend_b) > kCurved)
    return std::min(bend_difference(a, b, 1), bend_difference(a, b, -1)) < kLike ? 0.8 : 0;
  return std::min(bend_a, bend_b) < kStraight && std::max(bend_a, bend_b) > kRound ? -1.2 : 0;
}

Vec2 chord(const SeamRun& run) { return run.at[kSamples - 1] - run.at[0]; }

/// Height of each sample along the grain over the run's mean, and the root mean square of it.
double heights(const SeamModel& m, const SeamRun& run, std::array<double, kSamples>& h) {
  double mean = 0, square = 0;
  for (std::size_t i = 0; i < kSamples; ++i) mean += (h[i] = dot(run.at[i], m.up[run.panel])) / kSamples;
  for (double& x : h) x -= mean, square += x * x / kSamples;
  return std::sqrt(square);
}

/// Pieces mostly lie as they are worn, so that the upper ends of two edges belong together.
double height_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along) {
  constexpr double kLevel = 0.08;  // of the length: an even slope has 0.29
  std::array<double, kSamples> ha{}, hb{};
  const double sa = heights(m, a, ha), sb = heights(m, b, hb);
  if (sa < kLevel * a.length || sb < kLevel * b.length) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < kSamples; ++i) sum += ha[i] * hb[along ? i : kSamples - 1 - i] / kSamples;
  return sum / (sa * sb);
}

/// How much the cloth's outside at the run faces up along the grain, -1 to 1.
double facing_up(const SeamModel& m, const SeamRun& run) {
  return dot(normalized(-perpendicular(chord(run))), m.up[run.panel]);
}

double facing_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  constexpr double kMostly = 0.8;
  const double ua = facing_up(m, a), ub = facing_up(m, b);
  if (ua < -kMostly && ub < -kMostly) return -1.5;  // two hems
  if (std::min(ua, ub) < -kMostly && std::max(ua, ub) > kMostly) return a.panel == b.panel ? -3 : 0.4;
  return 0;
}

double name_merit(const PieceWords& a, const PieceWords& b, bool twins) {
  double merit = 0;
  if (a.side * b.side > 0) merit += 0.5;
  if (a.side * b.side < 0) merit -= a.limb || b.limb ? 4 : twins ? 0 : 2;
  if (a.face * b.face < 0) merit += 0.4;
  return merit;
}

bool is_dart(const SeamModel& m, Index a, Index b) {
  constexpr double kWidest = 50;  // degrees between the legs
  const auto at = [&](Index leg, Index other) {
    const double angle = m.runs[other].angle;
    return m.runs[leg].next == other && angle > 360 - kWidest && angle < 359.5;
  };
  const double la = m.runs[a].length, lb = m.runs[b].length;
  return m.runs[a].panel == m.runs[b].panel && (at(a, b) || at(b, a)) &&
         std::abs(la - lb) < 0.04 * std::max(la, lb);
}

/// Notches that meet within 5 mm speak for the pair, those that are left over a little against it.
double notch_merit(const SeamRun& a, const SeamRun& b, bool along) {
  constexpr double kMeet = 5;  // mm
  if (a.notches.empty() && b.notches.empty()) return 0;
  std::size_t met = 0;
  for (const double n : a.notches) {
    const double there = along ? n : b.length - n;
    const double other_end = along ? n + b.length - a.length : a.length - n;
    met += std::any_of(b.notches.begin(), b.notches.end(), [&](double x) {
      return std::min(std::abs(x - there), std::abs(x - other_end)) <= kMeet;
    });
  }
  const auto all = static_cast<double>(a.notches.size() + b.notches.size());
  return std::min(3.0, 1.5 * static_cast<double>(met)) -
         0.3 * std::max(0.0, all - 2.0 * static_cast<double>(met));
}

}  // namespace

double length_merit(double a, double b) {
  static constexpr Step kSteps[] = {{0, 6},     {0.003, 5.7}, {0.01, 5},  {0.03, 3.5}, {0.06, 2.2},
                                    {0.1, 0.8}, {0.2, -1},    {0.35, -2}, {0.5, -3.5}, {0.7, -8}};
  constexpr double kDrawn = 0.5, kShort = 15;  // mm: how truly lengths are drawn; what is like by chance
  const double longer = std::max(a, b);
  const double merit = along_steps(kSteps, std::max(0.0, std::abs(a - b) - kDrawn) / longer);
  return merit > 0 ? merit * std::min(1.0, longer / kShort) : merit;
}

std::array<double, 2> pair_merit(const SeamModel& m, Index i, Index j, bool lengths) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const bool twins = m.mirror[i] == j;
  double merit = lengths ? length_merit(a.length, b.length) : 0;
  if (is_dart(m, i, j)) return {merit + 3, merit - 3};
  merit += shape_merit(a, b) + facing_merit(m, a, b);
  if (a.panel == b.panel) {
    merit -= 1;
  } else {
    merit += name_merit(m.words[a.panel], m.words[b.panel], twins);
    const bool upright = std::abs(dot(normalized(chord(a)), m.up[a.panel])) > 0.5;
    if (twins && !upright) merit -= 1;
  }
  std::array<double, 2> both{};
  for (const bool along : {false, true})
    both[along] = merit + 0.8 * height_merit(m, a, b, along) + notch_merit(a, b, along);
  return both;
}

}  // namespace toile
