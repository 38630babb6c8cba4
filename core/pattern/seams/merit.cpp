// What speaks for a pair of runs by itself.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr std::size_t kSamples = SeamRun::kSamples;

constexpr const PairWeights& kWeights = kPairWeights;

/// Straight lines through the steps, level outside them.
template <std::size_t N>
double along_steps(const WeightStep (&steps)[N], double x) {
  if (x <= steps[0].at) return steps[0].value;
  for (std::size_t i = 1; i < N; ++i) {
    if (x > steps[i].at) continue;
    const WeightStep &p = steps[i - 1], &q = steps[i];
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
  const double bend_a = bend_of(a), bend_b = bend_of(b);
  const double least = std::min(bend_a, bend_b);
  if (least > kWeights.curved_deg) {
    const double off = std::min(bend_difference(a, b, 1), bend_difference(a, b, -1));
    return off < kWeights.like_deg ? kWeights.like_curves : 0;
  }
  const bool unlike = least < kWeights.straight_deg && std::max(bend_a, bend_b) > kWeights.round_deg;
  return unlike ? kWeights.straight_to_round : 0;
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
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  std::array<double, kSamples> ha{}, hb{};
  const double sa = heights(m, a, ha), sb = heights(m, b, hb);
  if (sa < kWeights.level * a.length || sb < kWeights.level * b.length) return 0;
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
  constexpr double mostly = kWeights.facing, fully = kWeights.facing_fully;
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  const double ua = facing_up(m, a), ub = facing_up(m, b);
  if (ua < -mostly && ub < -mostly) return kWeights.two_hems;
  if (ua > fully && ub > fully) return kWeights.two_waists;
  if (std::min(ua, ub) > -mostly || std::max(ua, ub) < mostly) return 0;
  if (a.panel == b.panel) return kWeights.hem_to_own_waist;
  const bool larger_hangs = (m.girth[a.panel] > m.girth[b.panel]) == (ua > 0);
  const int faces = m.words[a.panel].face * m.words[b.panel].face;
  return (larger_hangs ? kWeights.larger_hangs : kWeights.smaller_hangs) + kWeights.hanging_face * faces;
}

/// `alike`: the two edges are the same one of two pieces that are drawn alike.
double name_merit(const PieceWords& a, const PieceWords& b, bool twins, bool alike) {
  double merit = 0;
  if (alike && a.limb && b.limb && a.face * b.face >= 0 && a.side * b.side <= 0) return kWeights.both_sleeves;
  if (a.side * b.side > 0) merit += kWeights.same_side;
  if (a.side * b.side < 0)
    merit += a.limb && b.limb   ? kWeights.other_side_limbs
             : a.limb || b.limb ? kWeights.other_side_limb
             : twins            ? 0
                                : kWeights.other_side;
  if (a.limb != b.limb) merit += kWeights.limb_face * a.face * b.face;
  return merit;
}

bool is_dart(const SeamModel& m, Index a, Index b) {
  constexpr double least = 360 - kWeights.dart_deg, most = 360 - kWeights.dart_least_deg;
  const auto at = [&](Index leg, Index other) {
    const double angle = m.runs[other].angle;
    return m.runs[leg].next == other && angle > least && angle < most;
  };
  const double la = m.runs[a].length, lb = m.runs[b].length;
  return m.runs[a].panel == m.runs[b].panel && (at(a, b) || at(b, a)) &&
         std::abs(la - lb) < kWeights.dart_ease * std::max(la, lb);
}

/// Mirrored pieces meet in a straight line along the grain, as at a centre front, rather than along a hollow
/// (a neck, an armhole) or across the grain (a hem).
double twin_merit(const SeamRun& run, double along_grain) {
  const bool round = run.turn.back() > kWeights.twin_round_deg;
  double merit =
      (round ? kWeights.twin_across_round : kWeights.twin_across) * (1 - along_grain * along_grain);
  if (bend_of(run) < kWeights.straight_deg && along_grain > kWeights.twin_straight_rise)
    merit += kWeights.twin_straight;
  if (run.turn.back() < kWeights.twin_hollow_deg)
    merit += kWeights.twin_hollow *
             std::clamp((kWeights.twin_upright_rise - along_grain) / kWeights.twin_upright_width, 0.0, 1.0);
  return merit;
}

double difference(const SeamRun& a, const SeamRun& b) {
  return std::abs(a.length - b.length) / std::max(a.length, b.length);
}

/// Notches that meet speak for the pair, those that are left over a little against it.
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

double weight_of_part(const SeamRun& a, const SeamRun& b) {
  return std::min(kWeights.part_most,
                  kWeights.part_least + kWeights.part_per_share * std::min(a.to - a.from, b.to - b.from));
}

/// Ends of both runs that meet and are cuts: nothing is there to cut them for.
int cut_ends_that_meet(const SeamRun& a, const SeamRun& b, bool along) {
  const bool b_start = b.from > 0, b_end = b.to < 1;
  return (a.from > 0 && (along ? b_start : b_end)) + (a.to < 1 && (along ? b_end : b_start));
}

}  // namespace

double length_merit(double a, double b) {
  const double longer = std::max(a, b);
  const double merit =
      along_steps(kWeights.length, std::max(0.0, std::abs(a - b) - kWeights.drawn_mm) / longer);
  return merit > 0 ? merit * std::min(1.0, longer / kWeights.short_mm) : merit;
}

namespace {

bool is_cut(const SeamRun& run) { return run.from > 0 || run.to < 1; }

/// What the lengths say, `lengths` or not: along the grain cloth is gathered seldom.
double length_part(const SeamModel& m, Index i, Index j, bool lengths, bool counterparts) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  double merit = lengths ? length_merit(a.length, b.length) : 0;
  // Mirrored edges are of one length whether they are sewn or not: that says little.
  if (m.mirror[i] == j || a.panel == b.panel) merit = std::min(merit, kWeights.most_of_twins);
  if (lengths && counterparts) merit = std::min(merit, kWeights.most_of_counterparts);
  const bool straight = a.straight && b.straight;
  const double fair = straight ? kWeights.fair_straight : kWeights.fair_curved, off = difference(a, b);
  if (std::min(rise(m, a), rise(m, b)) > kWeights.upright)
    merit -= kWeights.ease_upright * std::clamp(off / fair - kWeights.ease_begins, 0.0, 1.0);
  if (lengths && straight && off < kWeights.gathered)
    merit -= kWeights.inexact * std::clamp(off / kWeights.inexact_share - kWeights.inexact_begins, 0.0, 1.0);
  return merit;
}

/// What speaks for sewing a piece to itself: bands and sleeves are tubes, a front is none.
double own_piece_part(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const PieceWords& words = m.words[a.panel];
  const bool mirrored = m.mirror[i] == j;
  if (mirrored && words.face != 0 && !words.limb) return kWeights.own_front;
  const bool tube =
      mirrored && a.straight && b.straight && std::min(rise(m, a), rise(m, b)) > kWeights.own_tube_rise;
  return tube ? kWeights.own_tube : kWeights.own_piece;
}

}  // namespace

std::array<double, 2> pair_merit(const SeamModel& m, Index i, Index j, bool lengths) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  if (is_dart(m, i, j)) {
    const double merit = lengths ? length_merit(a.length, b.length) : 0;
    return {merit + kWeights.dart, merit - kWeights.dart};
  }
  const bool twins = m.mirror[i] == j;
  const std::vector<Index>& alike = m.counterparts[i];
  const bool counterparts = std::find(alike.begin(), alike.end(), j) != alike.end();
  double merit = length_part(m, i, j, lengths, counterparts) + shape_merit(a, b) + facing_merit(m, a, b);
  if (!twins && std::max(a.turn.back(), b.turn.back()) < kWeights.hollow_deg) merit += kWeights.two_hollows;
  if (a.panel == b.panel) {
    merit += own_piece_part(m, i, j);
  } else {
    merit += name_merit(m.words[a.panel], m.words[b.panel], twins, twins || counterparts);
    if (twins) merit += twin_merit(a, rise(m, a));
  }
  std::array<double, 2> both{};
  for (const bool along : {false, true})
    both[along] = merit + kWeights.height * height_merit(m, a, b, along) + notch_merit(a, b, along) +
                  kWeights.cut_to_cut * cut_ends_that_meet(a, b, along);
  // Parts were cut to fit: that they agree says less, and together they are one coincidence.
  if (lengths && (is_cut(a) || is_cut(b)))
    for (double& x : both)
      x = std::min(x, weight_of_part(a, b) * x) +
          (difference(a, b) > kWeights.cut_ease ? kWeights.cut_differs : 0);
  return both;
}

}  // namespace toile::seams
