// What speaks for a pair of runs by itself.

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/armholes.h"
#include "core/pattern/seams/folds.h"
#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/kinds.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/vents.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

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

double weight_of_part(const SeamRun& a, const SeamRun& b) {
  return std::min(
      kPairWeights.part_most,
      kPairWeights.part_least + kPairWeights.part_per_share * std::min(a.to - a.from, b.to - b.from));
}

/// Whether the run is a half of an edge that mirrors itself.
bool ends_in_middle(const SeamModel& m, const SeamRun& run) {
  return m.twin[run.panel] == run.panel && run.mirror_edge == run.edge && run.to - run.from == 0.5;
}

bool is_cut_at_start(const SeamRun& run) { return run.from > 0 && !run.from_notch; }
bool is_cut_at_end(const SeamRun& run) { return run.to < 1 && !run.to_notch; }

/// Whether an end of it is none of the drawing's, neither a corner nor a notch.
bool is_cut(const SeamRun& run) { return is_cut_at_start(run) || is_cut_at_end(run); }

/// Ends of both runs that meet and are cuts: nothing is there to cut them for.
int cut_ends_that_meet(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along) {
  if (ends_in_middle(m, a) && ends_in_middle(m, b)) return 0;
  const bool b_start = is_cut_at_start(b), b_end = is_cut_at_end(b);
  return (is_cut_at_start(a) && (along ? b_start : b_end)) + (is_cut_at_end(a) && (along ? b_end : b_start));
}

/// Whether the runs are the sides of a front and a back of which the front's is longer by what a dart for the
/// bust takes in: it may be drawn inside the piece, or be left to be eased.
bool has_bust_ease(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const int face = m.words[a.panel].face;
  const SeamRun &front = face > 0 ? a : b, &back = face > 0 ? b : a;
  return are_torsos(m, i, j) && face * m.words[b.panel].face < 0 && front.length > back.length &&
         difference(a, b) < kPairWeights.bust_ease && begins_at_hem(m, a) && begins_at_hem(m, b);
}

/// Whether the runs are the shoulders of a front and a back of which the back's is a little longer: it is
/// eased over the shoulder blade (Aldrich, Metric Pattern Cutting for Women's Wear: by some 1 cm).
bool has_shoulder_ease(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const int face = m.words[a.panel].face;
  const SeamRun &front = face > 0 ? a : b, &back = face > 0 ? b : a;
  return are_torsos(m, i, j) && face * m.words[b.panel].face < 0 && back.length > front.length &&
         difference(a, b) < kPairWeights.shoulder_ease && std::min(a.up, b.up) > kPairWeights.facing;
}

/// What the lengths say, `lengths` or not: along the grain cloth is gathered seldom.
double length_part(const SeamModel& m, Index i, Index j, bool lengths, bool counterparts, bool gathers) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  double merit = lengths ? length_merit(a.length, b.length) : 0;
  const double most = is_cap(m, a, b) ? kPairWeights.gathered_cap : kPairWeights.gathered_most;
  if (gathers && lengths && difference(a, b) < most)
    merit = std::max(merit, kPairWeights.gathered_least - kPairWeights.gathered_slope * difference(a, b));
  // Mirrored edges are of one length whether they are sewn or not: that says little.
  if (m.mirror[i] == j || a.panel == b.panel) merit = std::min(merit, kPairWeights.most_of_twins);
  if (lengths && counterparts) merit = std::min(merit, kPairWeights.most_of_counterparts);
  const bool straight = a.straight && b.straight;
  const double fair = straight ? kPairWeights.fair_straight : kPairWeights.fair_curved,
               off = difference(a, b);
  const bool known = m.upright[a.panel] && m.upright[b.panel];
  if (known && std::min(rise(m, a), rise(m, b)) > kPairWeights.upright)
    merit -= (has_bust_ease(m, i, j) ? kPairWeights.ease_bust : kPairWeights.ease_upright) *
             std::clamp(off / fair - kPairWeights.ease_begins, 0.0, 1.0);
  if (lengths && straight && off < kPairWeights.gathered && !has_shoulder_ease(m, i, j))
    merit -= kPairWeights.inexact *
             std::clamp(off / kPairWeights.inexact_share - kPairWeights.inexact_begins, 0.0, 1.0);
  return merit;
}

/// What speaks for sewing a piece to itself: bands and sleeves are tubes, a front is none.
double own_piece_part(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const PieceWords& words = m.words[a.panel];
  const bool mirrored = m.mirror[i] == j;
  const double ring = (m.girth[a.panel] - a.length - b.length) / 2;
  const bool limb = words.kind == PieceKind::kCuff || words.kind == PieceKind::kSleeve;
  if (limb && ring < kPairWeights.least_ring_mm) return kPairWeights.own_front;
  if (mirrored && (words.face != 0 || words.yoke)) return kPairWeights.own_front;
  const bool tube =
      mirrored && a.straight && b.straight && std::min(rise(m, a), rise(m, b)) > kPairWeights.own_tube_rise;
  return tube ? kPairWeights.own_tube : kPairWeights.own_piece;
}

/// Whether one of the runs is of a vent or fly, which is sewn to its mirror image at most.
bool is_of_vent(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  return m.mirror[i] != j && (stands_out(m, a) || stands_out(m, b));
}

/// Whether the seam would join the wearer's left of a front to the right of a back: seen from their right
/// sides the one's right half meets the other's left one.
bool crosses_over(const SeamModel& m, Index i, Index j, bool along) {
  if (m.words[m.runs[i].panel].face * m.words[m.runs[j].panel].face >= 0) return false;
  return half_of(m, i) * half_of(m, j) * (along ? -1 : 1) > 0;
}

/// Whether the seam would set a sleeve that names its side into the other side of a whole front or back, as
/// these are seen from outside.
bool takes_other_side(const SeamModel& m, Index limb, Index whole, bool along) {
  const PieceWords &x = m.words[m.runs[limb].panel], &y = m.words[m.runs[whole].panel];
  if (!x.limb || x.side == 0 || y.side != 0 || y.face == 0) return false;
  const int seen = half_of(m, whole) * (m.handed < 0 ? -1 : 1) * (along ? -1 : 1);
  return x.side * seen * -y.face < 0;  // a front's right half covers the wearer's left
}

}  // namespace

double length_merit(double a, double b) {
  const double longer = std::max(a, b);
  const double merit =
      along_steps(kPairWeights.length, std::max(0.0, std::abs(a - b) - kPairWeights.drawn_mm) / longer);
  return merit > 0 ? merit * std::min(1.0, longer / kPairWeights.short_mm) : merit;
}

bool never_sewn(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  return stays_open(m, a, b) || is_of_vent(m, i, j) || never_at_fold(m, a, b) ||
         kind_merit(m, a, b, told_to_hang(m, a, b)) <= kPairWeights.never_meet;
}

std::array<double, 2> pair_merit(const SeamModel& m, Index i, Index j, bool lengths) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const bool twins = m.mirror[i] == j;
  const std::vector<Index>& alike = m.counterparts[i];
  const bool counterparts = std::find(alike.begin(), alike.end(), j) != alike.end();
  const int hangs = told_to_hang(m, a, b);
  const bool of_bib = m.words[a.panel].bib || m.words[b.panel].bib;  // it takes the middle of a band
  const bool gathers = (hangs > 0 && !on_neck(m, a, b) && !of_bib) || is_cap(m, a, b);
  double merit = length_part(m, i, j, lengths, counterparts, gathers) + shape_merit(a, b) +
                 facing_merit(m, a, b) + kind_merit(m, a, b, hangs);
  if (hangs > 0 && takes_both_halves(m, i, j)) merit += kPairWeights.half_takes_all;
  const bool sweep = sweeps_to_wrist(m, a) && sweeps_to_wrist(m, b);
  const bool sides = (sweep || (begins_at_hem(m, a) && begins_at_hem(m, b))) && !twins;
  const bool torsos = are_torsos(m, i, j);  // of which no part of an armhole meets one of another
  const double turn = torsos ? std::max(a.line_turn, b.line_turn) : std::max(a.turn.back(), b.turn.back());
  if (!sides && (!twins || a.panel == b.panel) && turn < kPairWeights.hollow_deg)
    merit += torsos ? kPairWeights.two_armholes : kPairWeights.two_hollows;
  if (is_armhole_end(m, a) && is_armhole_end(m, b)) merit += kPairWeights.two_armholes;
  if (turns_in(m, a) && turns_in(m, b) && !(is_below_arm(m, a) && is_below_arm(m, b)))
    merit += kPairWeights.two_corners;
  if (stays_open(m, a, b)) merit += kPairWeights.stays_open;
  merit += row_merit(m, a, b);
  if (is_of_vent(m, i, j)) merit += kPairWeights.vent;
  if (lengths && m.raglan && on_neck(m, a, a) != on_neck(m, b, b)) merit += kPairWeights.raglan_neck;
  if (a.panel == b.panel) {
    merit += own_piece_part(m, i, j) + (is_slit(m, a, i, b, j) ? kPairWeights.slit : 0);
  } else {
    merit += name_merit(m.words[a.panel], m.words[b.panel], twins, twins || counterparts,
                        is_middle(m, a) && is_middle(m, b));
    merit += middle_merit(m, a, b);
    if (twins) merit += twin_merit(m, a, rise(m, a));
  }
  std::array<double, 2> both{};
  for (const bool along : {false, true})
    both[along] =
        merit + kPairWeights.height * height_merit(m, a, b, along) + notch_merit(a, b, along) +
        (crosses_over(m, i, j, along) ? kPairWeights.crosses_over : 0) +
        (takes_other_side(m, i, j, along) || takes_other_side(m, j, i, along)
             ? kPairWeights.sleeve_of_other_side
             : 0) +
        (is_set_on_turned(m, a, b, along) || is_set_on_turned(m, b, a, along) ? kPairWeights.never_meet : 0) +
        kPairWeights.cut_to_cut * cut_ends_that_meet(m, a, b, along);
  // Parts were cut to fit: that they agree says less, and together they are one coincidence.
  if (lengths && (is_cut(a) || is_cut(b)))
    for (double& x : both)
      x = std::min(x, weight_of_part(a, b) * x) +
          (!gathers && difference(a, b) > kPairWeights.cut_ease ? kPairWeights.cut_differs : 0);
  return both;
}

}  // namespace toile::seams
