#include "core/pattern/seams/shapes.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Mean difference in degrees between the turning of a and that of b run backwards, times `sign`.
double bend_difference(const SeamRun& a, const SeamRun& b, double sign) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < SeamRun::kSamples; ++k) {
    const double back = sign * (b.turn[SeamRun::kSamples - 2] - b.turn[SeamRun::kSamples - 2 - k]);
    sum += std::abs(a.turn[k] - back);
  }
  return sum / (SeamRun::kSamples - 1);
}

/// Height of each sample along the grain over the run's mean, and the root mean square of it.
double heights(const SeamModel& m, const SeamRun& run, std::array<double, SeamRun::kSamples>& h) {
  double mean = 0, square = 0;
  for (std::size_t i = 0; i < SeamRun::kSamples; ++i)
    mean += (h[i] = dot(run.at[i], m.up[run.panel])) / SeamRun::kSamples;
  for (double& x : h) {
    x -= mean;
    square += x * x / SeamRun::kSamples;
  }
  return std::sqrt(square);
}

}  // namespace

Vec2 chord(const SeamRun& run) { return run.at[SeamRun::kSamples - 1] - run.at[0]; }

double bend_of(const SeamRun& run) {
  const auto [low, high] = std::minmax_element(run.turn.begin(), run.turn.end());
  return *high - *low;
}

double shape_merit(const SeamRun& a, const SeamRun& b) {
  const double bend_a = bend_of(a), bend_b = bend_of(b);
  const double least = std::min(bend_a, bend_b);
  if (least > kPairWeights.curved_deg) {
    const double off = std::min(bend_difference(a, b, 1), bend_difference(a, b, -1));
    return off < kPairWeights.like_deg ? kPairWeights.like_curves : 0;
  }
  const bool unlike = least < kPairWeights.straight_deg && std::max(bend_a, bend_b) > kPairWeights.round_deg;
  return unlike ? kPairWeights.straight_to_round : 0;
}

double height_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along) {
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  std::array<double, SeamRun::kSamples> ha{}, hb{};
  const double sa = heights(m, a, ha), sb = heights(m, b, hb);
  if (sa < kPairWeights.level * a.length || sb < kPairWeights.level * b.length) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < SeamRun::kSamples; ++i)
    sum += ha[i] * hb[along ? i : SeamRun::kSamples - 1 - i] / SeamRun::kSamples;
  return sum / (sa * sb);
}

double rise(const SeamModel& m, const SeamRun& run) {
  return std::abs(dot(normalized(chord(run)), m.up[run.panel]));
}

double difference(const SeamRun& a, const SeamRun& b) {
  return std::abs(a.length - b.length) / std::max(a.length, b.length);
}

bool is_middle(const SeamModel& m, const SeamRun& run) {
  return run.straight && rise(m, run) > kPairWeights.twin_straight_rise;
}

bool is_slit(const SeamModel& m, const SeamRun& a, Index i, const SeamRun& b, Index j) {
  return (a.next == j && m.runs[j].angle > kPairWeights.slit_deg) ||
         (b.next == i && m.runs[i].angle > kPairWeights.slit_deg);
}

double notch_merit(const SeamRun& a, const SeamRun& b, bool along) {
  if (a.notches.empty() && b.notches.empty()) return 0;
  std::size_t met = 0;
  for (const double n : a.notches) {
    const double there = along ? n : b.length - n;
    const double other_end = along ? n + b.length - a.length : a.length - n;
    met += std::any_of(b.notches.begin(), b.notches.end(), [&](double x) {
      return std::min(std::abs(x - there), std::abs(x - other_end)) <= kPairWeights.notch_mm;
    });
  }
  const auto all = static_cast<double>(a.notches.size() + b.notches.size());
  return std::min(kPairWeights.notches_most, kPairWeights.notch_meets * static_cast<double>(met)) +
         kPairWeights.notch_alone * std::max(0.0, all - 2.0 * static_cast<double>(met));
}

bool begins_at_hem(const SeamModel& m, const SeamRun& run) {
  const auto is_hem = [&](const SeamRun& other) {
    const double beside = std::max(m.runs[other.next].up, run_before(m, other).up);
    const bool crotch = lies_between_hollows(m, other) && beside < kPairWeights.leg_opening_up &&
                        other.length < kPairWeights.crotch * m.girth[other.panel];
    return m.upright[other.panel] && other.up < -kPairWeights.facing && !crotch;
  };
  return is_hem(m.runs[run.next]) || is_hem(run_before(m, run));
}

int half_of(const SeamModel& m, Index r) {
  const SeamRun& run = m.runs[r];
  const Index image = m.mirror[r];
  if (m.twin[run.panel] != run.panel || image == kNone || image == r || !m.upright[run.panel]) return 0;
  const Vec2 up = m.up[run.panel], right{up.y, -up.x};
  constexpr std::size_t kMiddle = SeamRun::kSamples / 2;
  return dot(run.at[kMiddle] - m.runs[image].at[kMiddle], right) > 0 ? 1 : -1;
}

}  // namespace toile::seams
