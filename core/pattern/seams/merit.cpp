// What speaks for a pair of runs by itself.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/pattern/seams/gluing.h"

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

constexpr double kStraight = 8;  // degrees that an edge may turn by and count as straight

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
  constexpr double kCurved = 25, kRound = 60, kLike = 8;  // degrees
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
  for (double& x : h) {
    x -= mean;
    square += x * x / kSamples;
  }
  return std::sqrt(square);
}

/// Pieces mostly lie as they are worn, so that the upper ends of two edges belong together.
double height_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along) {
  constexpr double kLevel = 0.08;  // of the length: an even slope has 0.29
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  std::array<double, kSamples> ha{}, hb{};
  const double sa = heights(m, a, ha), sb = heights(m, b, hb);
  if (sa < kLevel * a.length || sb < kLevel * b.length) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < kSamples; ++i) sum += ha[i] * hb[along ? i : kSamples - 1 - i] / kSamples;
  return sum / (sa * sb);
}

/// How much the run runs along the grain, 0 to 1.
double rise(const SeamModel& m, const SeamRun& run) {
  return std::abs(dot(normalized(chord(run)), m.up[run.panel]));
}

/// How much the cloth's outside at the run faces up along the grain, -1 to 1.
double facing_up(const SeamModel& m, const SeamRun& run) {
  return dot(normalized(-perpendicular(chord(run))), m.up[run.panel]);
}

double facing_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  constexpr double kMostly = 0.8, kLevel = 0.97;
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  const double ua = facing_up(m, a), ub = facing_up(m, b);
  if (ua < -kMostly && ub < -kMostly) return -3;  // two hems
  if (ua > kLevel && ub > kLevel) return -2.5;    // two waists; shoulders slope
  if (std::min(ua, ub) > -kMostly || std::max(ua, ub) < kMostly) return 0;
  if (a.panel == b.panel) return -3;
  // What hangs below is mostly the larger: a skirt from its band.
  const bool larger_hangs = (m.girth[a.panel] > m.girth[b.panel]) == (ua > 0);
  const int faces = m.words[a.panel].face * m.words[b.panel].face;
  return (larger_hangs ? 0.8 : 0.4) + 0.5 * faces;
}

/// `alike`: the two edges are the same one of two pieces that are drawn alike.
double name_merit(const PieceWords& a, const PieceWords& b, bool twins, bool alike) {
  double merit = 0;
  if (alike && a.limb && b.limb && a.face * b.face >= 0 && a.side * b.side <= 0) return -8;  // both sleeves
  if (a.side * b.side > 0) merit += 0.5;
  if (a.side * b.side < 0) merit -= a.limb && b.limb ? 8 : a.limb || b.limb ? 4 : twins ? 0 : 2;
  if (a.limb != b.limb) merit += 1.0 * a.face * b.face;  // a sleeve's front to the front
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

constexpr double kTwins = 2.5;       ///< the most that like lengths say of mirrored edges
constexpr double kCounterparts = 5;  ///< and of the same edge of two pieces that are drawn alike
constexpr double kUpright = 0.8;     ///< rise of an edge that runs along the grain
constexpr double kCutToCut = 4;
constexpr double kHollow = -40;    ///< degrees
constexpr double kTwoHollows = 3;  ///< armholes go to caps, not to armholes
constexpr double kCutEase = 0.06;  ///< parts that differ by more were not meant
constexpr double kInexact = 2.5;   ///< straight edges are drawn to the tenth of a millimetre …
constexpr double kGathered = 0.1;  ///< … unless they are gathered

/// Mirrored pieces meet in a straight line along the grain, as at a centre front, rather than along a hollow
/// (a neck, an armhole) or across the grain (a hem).
double twin_merit(const SeamRun& run, double along_grain) {
  constexpr double kBitHollow = -25, kRound = 45;  // degrees
  const bool round = run.turn.back() > kRound;     // a hood's back, or a seam that gives shape
  double merit = -(round ? 1 : 3) * (1 - along_grain * along_grain);
  if (bend_of(run) < kStraight && along_grain > 0.9) merit += 3;
  if (run.turn.back() < kBitHollow)
    merit -= 3 * std::clamp((0.95 - along_grain) / 0.1, 0.0, 1.0);  // a crotch is upright
  return merit;
}

double difference(const SeamRun& a, const SeamRun& b) {
  return std::abs(a.length - b.length) / std::max(a.length, b.length);
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

double weight_of_part(const SeamRun& a, const SeamRun& b) {
  return std::min(0.5, 0.15 + 0.7 * std::min(a.to - a.from, b.to - b.from));
}

/// Ends of both runs that meet and are cuts: nothing is there to cut them for.
int cut_ends_that_meet(const SeamRun& a, const SeamRun& b, bool along) {
  const bool b_start = b.from > 0, b_end = b.to < 1;
  return (a.from > 0 && (along ? b_start : b_end)) + (a.to < 1 && (along ? b_end : b_start));
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

namespace {

bool is_cut(const SeamRun& run) { return run.from > 0 || run.to < 1; }

/// What the lengths say, `lengths` or not: along the grain cloth is gathered seldom.
double length_part(const SeamModel& m, Index i, Index j, bool lengths, bool counterparts) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  double merit = lengths ? length_merit(a.length, b.length) : 0;
  // Mirrored edges are of one length whether they are sewn or not: that says little.
  if (m.mirror[i] == j || a.panel == b.panel) merit = std::min(merit, kTwins);
  if (lengths && counterparts) merit = std::min(merit, kCounterparts);
  const bool straight = a.straight && b.straight;
  const double fair = straight ? 0.015 : 0.06, off = difference(a, b);
  if (std::min(rise(m, a), rise(m, b)) > kUpright) merit -= 4 * std::clamp(off / fair - 0.33, 0.0, 1.0);
  if (lengths && straight && off < kGathered) merit -= kInexact * std::clamp(off / 0.005 - 0.1, 0.0, 1.0);
  return merit;
}

/// What speaks for sewing a piece to itself: bands and sleeves are tubes, a front is none.
double own_piece_part(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const PieceWords& words = m.words[a.panel];
  const bool mirrored = m.mirror[i] == j;
  if (mirrored && words.face != 0 && !words.limb) return -3;
  return mirrored && a.straight && b.straight && std::min(rise(m, a), rise(m, b)) > 0.9 ? 1 : -1;
}

}  // namespace

std::array<double, 2> pair_merit(const SeamModel& m, Index i, Index j, bool lengths) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  if (is_dart(m, i, j)) {
    const double merit = lengths ? length_merit(a.length, b.length) : 0;
    return {merit + 3, merit - 3};
  }
  const bool twins = m.mirror[i] == j;
  const std::vector<Index>& alike = m.counterparts[i];
  const bool counterparts = std::find(alike.begin(), alike.end(), j) != alike.end();
  double merit = length_part(m, i, j, lengths, counterparts) + shape_merit(a, b) + facing_merit(m, a, b);
  if (!twins && std::max(a.turn.back(), b.turn.back()) < kHollow) merit -= kTwoHollows;
  if (a.panel == b.panel) {
    merit += own_piece_part(m, i, j);
  } else {
    merit += name_merit(m.words[a.panel], m.words[b.panel], twins, twins || counterparts);
    if (twins) merit += twin_merit(a, rise(m, a));
  }
  std::array<double, 2> both{};
  for (const bool along : {false, true})
    both[along] = merit + 0.8 * height_merit(m, a, b, along) + notch_merit(a, b, along) -
                  kCutToCut * cut_ends_that_meet(a, b, along);
  // Parts were cut to fit: that they agree says less, and together they are one coincidence.
  if (lengths && (is_cut(a) || is_cut(b)))
    for (double& x : both)
      x = std::min(x, weight_of_part(a, b) * x) - (difference(a, b) > kCutEase ? kCutToCut : 0);
  return both;
}

}  // namespace toile
