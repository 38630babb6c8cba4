#include "core/pattern/seams/shapes.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr std::size_t kSamples = SeamRun::kSamples;

constexpr const PairWeights& kWeights = kPairWeights;

/// Mean difference in degrees between the turning of a and that of b run backwards, times `sign`.
double bend_difference(const SeamRun& a, const SeamRun& b, double sign) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < kSamples; ++k) {
    const double back = sign * (b.turn[kSamples - 2] - b.turn[kSamples - 2 - k]);
    sum += std::abs(a.turn[k] - back);
  }
  return sum / (kSamples - 1);
}

/// Height of each sample along the grain over the run's mean, and the root mean square of it.
double heights(const SeamModel& m, const SeamRun& run, std::array<double, kSamples>& h) {
  double mean = 0, square = 0;
  for (std::size_t i = 0; i < kSamples; ++i) mean += (h[i] = dot(run.at[i], m.up[run.panel])) / kSamples;
  for (double& x : h) {
    x -= mean;
    square += x * x / kSamples;
  }
  return std::sqrt(square);
}

}  // namespace

Vec2 chord(const SeamRun& run) { return run.at[kSamples - 1] - run.at[0]; }

double bend_of(const SeamRun& run) {
  const auto [low, high] = std::minmax_element(run.turn.begin(), run.turn.end());
  return *high - *low;
}

double shape_merit(const SeamRun& a, const SeamRun& b) {
  const double bend_a = bend_of(a), bend_b = bend_of(b);
  const double least = std::min(bend_a, bend_b);
  if (least > kWeights.curved_deg) {
    const double off = std::min(bend_difference(a, b, 1), bend_difference(a, b, -1));
    return off < kWeights.like_deg ? kWeights.like_curves : 0;
  }
  const bool unlike = least < kWeights.straight_deg && std::max(bend_a, bend_b) > kWeights.round_deg;
  return unlike ? kWeights.straight_to_round : 0;
}

double height_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along) {
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  std::array<double, kSamples> ha{}, hb{};
  const double sa = heights(m, a, ha), sb = heights(m, b, hb);
  if (sa < kWeights.level * a.length || sb < kWeights.level * b.length) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < kSamples; ++i) sum += ha[i] * hb[along ? i : kSamples - 1 - i] / kSamples;
  return sum / (sa * sb);
}

double rise(const SeamModel& m, const SeamRun& run) {
  return std::abs(dot(normalized(chord(run)), m.up[run.panel]));
}

double difference(const SeamRun& a, const SeamRun& b) {
  return std::abs(a.length - b.length) / std::max(a.length, b.length);
}

bool is_middle(const SeamModel& m, const SeamRun& run) {
  return run.straight && rise(m, run) > kWeights.twin_straight_rise;
}

bool is_slit(const SeamModel& m, const SeamRun& a, Index i, const SeamRun& b, Index j) {
  return (a.next == j && m.runs[j].angle > kWeights.slit_deg) ||
         (b.next == i && m.runs[i].angle > kWeights.slit_deg);
}

double notch_merit(const SeamRun& a, const SeamRun& b, bool along) {
  if (a.notches.empty() && b.notches.empty()) return 0;
  std::size_t met = 0;
  for (const double n : a.notches) {
    const double there = along ? n : b.length - n;
    const double other_end = along ? n + b.length - a.length : a.length - n;
    met += std::any_of(b.notches.begin(), b.notches.end(), [&](double x) {
      return std::min(std::abs(x - there), std::abs(x - other_end)) <= kWeights.notch_mm;
    });
  }
  const auto all = static_cast<double>(a.notches.size() + b.notches.size());
  return std::min(kWeights.notches_most, kWeights.notch_meets * static_cast<double>(met)) +
         kWeights.notch_alone * std::max(0.0, all - 2.0 * static_cast<double>(met));
}

}  // namespace toile::seams
