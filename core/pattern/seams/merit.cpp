// What speaks for a pair of runs by itself.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/pattern/seams/cuts.h"
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

bool is_neck(PieceKind kind) { return kind == PieceKind::kCollar || kind == PieceKind::kHood; }

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

/// Whether the two pieces are as large as each other: gores stand side by side.
bool gores(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const double x = m.girth[a.panel], y = m.girth[b.panel];
  return std::abs(x - y) < kWeights.gores * std::max(x, y);
}

/// Whether `cuff` is the upper end of what hangs from the sleeve that `end` is on, and that the opening of
/// the sleeve: sleeves without a grain line mostly lie, with it to a side.
bool is_cuffed(const SeamModel& m, const SeamRun& end, const SeamRun& cuff) {
  const bool lies = m.words[end.panel].kind == PieceKind::kSleeve && !m.upright[end.panel];
  return lies && cuff.up > kWeights.facing && std::abs(end.up) < kWeights.lying &&
         hangs_from(m, cuff.panel, end.panel) > 0;
}

/// A piece of two edges has its sides somewhere on them, and none of the two is an upper or lower end.
bool has_no_sides(const SeamModel& m, const SeamRun& run) { return m.lines[run.panel] < 3; }

/// Whether one of the runs is the lower end of a piece and the other the upper one of a piece that hangs from
/// it, by their names: +1; −1 where they say the contrary; else 0.
int told_to_hang(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  if (a.panel == b.panel) return 0;
  if (is_cuffed(m, a, b) || is_cuffed(m, b, a)) return 1;
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  if (std::min(a.up, b.up) > -kWeights.facing || std::max(a.up, b.up) < kWeights.facing) return 0;
  const PieceKind ka = m.words[a.panel].kind, kb = m.words[b.panel].kind;
  if (a.side || b.side || has_no_sides(m, a) || has_no_sides(m, b)) return 0;
  if (ka == kb && m.rows[a.panel].row == m.rows[b.panel].row && gores(m, a, b)) return 0;
  return a.up > 0 ? hangs_from(m, a.panel, b.panel) : hangs_from(m, b.panel, a.panel);
}

/// Whether a sleeve is sewn to a bodice, which is no longer than it: caps are often gathered.
bool is_cap(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceKind ka = m.words[a.panel].kind, kb = m.words[b.panel].kind;
  return (ka == PieceKind::kSleeve && kb == PieceKind::kTorso && a.length > b.length) ||
         (kb == PieceKind::kSleeve && ka == PieceKind::kTorso && b.length > a.length);
}

/// Whether the piece turns in at an end of the run, as at the corner of a square neck.
bool turns_in(const SeamModel& m, const SeamRun& run) {
  const auto in = [](double angle) {
    return angle > kWeights.turns_in_deg && angle < 360 - kWeights.turns_in_deg / 3;
  };
  return in(run.angle) || in(m.runs[run.next].angle);
}

/// Whether the run may lie in the middle of the body: straight along the grain.
bool is_middle(const SeamModel& m, const SeamRun& run) {
  return run.straight && rise(m, run) > kWeights.twin_straight_rise;
}

/// How much the run faces the middle of the body, -1 to 1, if its piece is a side's front or back, seen from
/// outside; 0 where that is not known.
double inwards(const SeamModel& m, const SeamRun& run) {
  const PieceWords& words = m.words[run.panel];
  return m.handed * words.side * words.face * faces_right(m, run);
}

bool are_torsos(const SeamModel& m, Index i, Index j) {
  return m.words[m.runs[i].panel].kind == PieceKind::kTorso &&
         m.words[m.runs[j].panel].kind == PieceKind::kTorso;
}

bool on_limb(const PieceWords& words) { return words.limb || words.leg; }

/// A side's edges in the middle of the body go to the other side's, not to its own; its other edges do not.
double middle_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  const double ia = inwards(m, a), ib = inwards(m, b);
  const bool torsos = x.kind == PieceKind::kTorso && y.kind == PieceKind::kTorso;
  const bool own = torsos && x.side == y.side && std::min(ia, ib) > kWeights.fully_inner;
  const bool across = x.side != y.side && std::max(ia, ib) < -kWeights.inner;
  return own || across ? kWeights.not_middle : 0;
}

/// A sleeve is sewn with its cap to a hollow edge of a bodice that does not face the middle.
double armhole_merit(const SeamModel& m, const SeamRun& torso, const SeamRun& sleeve) {
  const bool hollow = torso.turn.back() < kWeights.twin_hollow_deg && inwards(m, torso) < kWeights.inner;
  return (hollow ? kWeights.armhole : -kWeights.armhole) + (sleeve.cap ? kWeights.cap : -kWeights.cap);
}

/// Numbers of inserts run to the right, seen from the front, as the places do that they are let into.
double insert_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const bool first = m.words[a.panel].kind == PieceKind::kInsert;
  const SeamRun &insert = first ? a : b, &whole = first ? b : a;
  const PieceRow& row = m.rows[insert.panel];
  if (row.row == kNone || row.size < 2 || m.words[whole.panel].kind == PieceKind::kInsert) return 0;
  const Vec2 up = m.up[whole.panel], right{up.y, -up.x};
  double low = 1e30, high = -1e30;
  for (const SeamRun& run : m.runs) {
    if (run.panel != whole.panel) continue;
    low = std::min(low, dot(run.at[0], right));
    high = std::max(high, dot(run.at[0], right));
  }
  const double along = (dot(whole.at[kSamples / 2], right) - low) / (high - low);
  const double place = (static_cast<double>(row.place) + 0.5) / static_cast<double>(row.size);
  return kWeights.insert_place * std::abs(place - (m.words[whole.panel].face < 0 ? 1 - along : along));
}

/// Whether one half, of a bodice or of trousers, would have all of an edge that both halves come to.
bool takes_both_halves(const SeamModel& m, Index i, Index j) {
  const auto whole = [&](Index r) { return m.runs[r].from == 0 && m.runs[r].to == 1; };
  const auto takes = [&](Index half, Index all) {
    return whole(all) && is_half(m, m.runs[half].panel) && meets_halves(m, all);
  };
  return takes(i, j) || takes(j, i);
}

/// Pieces of a collar meet at short ends; a lapel's long edges go to the neck, or to nothing.
bool is_long_in_collar(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const auto is_long = [&](const SeamRun& r) { return r.length > kWeights.collar_end * m.girth[r.panel]; };
  return is_long(a) || is_long(b);
}

/// What the kinds of the two pieces say.
double kind_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, int hangs) {
  const PieceKind ka = m.words[a.panel].kind, kb = m.words[b.panel].kind;
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (!ever_meet(ka, kb) || (on_limb(x) && on_limb(y) && x.leg != y.leg)) return kWeights.never_meet;
  if (ka == PieceKind::kInsert || kb == PieceKind::kInsert)
    return kWeights.insert_face * x.face * y.face + insert_merit(m, a, b);
  if (ka == PieceKind::kSleeve && kb == PieceKind::kSleeve)
    return a.cap || b.cap ? kWeights.cap_to_sleeve : 0;
  if (ka == PieceKind::kCollar && kb == PieceKind::kCollar)
    return is_long_in_collar(m, a, b) ? kWeights.collar_long : 0;
  if (ka == PieceKind::kTorso && kb == PieceKind::kSleeve) return armhole_merit(m, a, b);
  if (kb == PieceKind::kTorso && ka == PieceKind::kSleeve) return armhole_merit(m, b, a);
  if ((is_neck(ka) && kb == PieceKind::kTorso && is_middle(m, b)) ||
      (is_neck(kb) && ka == PieceKind::kTorso && is_middle(m, a)))
    return kWeights.not_middle;
  const bool upright = m.upright[a.panel] && m.upright[b.panel];
  if (hangs > 0) return kWeights.hangs + (upright ? 0 : kWeights.hanging_face * x.face * y.face);
  if (hangs < 0) return kWeights.hangs_not;
  const bool hanging = ka != kb && (hangs_from(ka, kb) > 0 || hangs_from(kb, ka) > 0);
  return hanging && upright && !is_neck(ka) && !is_neck(kb) ? kWeights.only_hangs : 0;
}

/// Whether both pieces are known to be of one kind, which lie alike: or fronts and backs of a garment that
/// names no kinds.
bool is_named_alike(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (x.kind != y.kind || is_neck(x.kind)) return false;
  return x.kind != PieceKind::kOther || (x.face * y.face != 0 && !x.layer && !y.layer);
}

double facing_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  constexpr double mostly = kWeights.facing, fully = kWeights.facing_fully;
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  const double ua = a.up, ub = b.up;
  if (ua < -mostly && ub < -mostly) return kWeights.two_hems;
  if (ua > fully && ub > fully) return kWeights.two_waists;
  const double level = std::max(std::abs(ua), std::abs(ub)), upright = std::min(std::abs(ua), std::abs(ub));
  if (level > fully && upright < kWeights.side_up && is_named_alike(m, a, b)) return kWeights.side_to_hem;
  if (std::min(ua, ub) > -mostly || std::max(ua, ub) < mostly) return 0;
  if (a.panel == b.panel) return kWeights.hem_to_own_waist;
  const bool larger_hangs = (m.girth[a.panel] > m.girth[b.panel]) == (ua > 0);
  const int faces = m.words[a.panel].face * m.words[b.panel].face;
  return (larger_hangs ? kWeights.larger_hangs : kWeights.smaller_hangs) + kWeights.hanging_face * faces;
}

/// `alike`: the two edges are the same one of two pieces that are drawn alike; `middle`: both may lie in the
/// middle of the body.
double name_merit(const PieceWords& a, const PieceWords& b, bool twins, bool alike, bool middle) {
  double merit = 0;
  if (twins && a.flank) return kWeights.both_sleeves;
  if (alike && a.limb && b.limb && a.face * b.face >= 0 && a.side * b.side <= 0) return kWeights.both_sleeves;
  if (a.side * b.side > 0) merit += kWeights.same_side;
  if (a.side * b.side < 0)
    merit += a.limb && b.limb                        ? kWeights.other_side_limbs
             : a.limb || b.limb                      ? kWeights.other_side_limb
             : twins || (middle && a.face == b.face) ? 0
                                                     : kWeights.other_side;
  if (a.limb != b.limb) merit += kWeights.limb_face * a.face * b.face;
  return merit;
}

/// Two edges that run into a narrow corner: what is no dart is a slit, or another piece is let in.
bool is_slit(const SeamModel& m, const SeamRun& a, Index i, const SeamRun& b, Index j) {
  return (a.next == j && m.runs[j].angle > kWeights.slit_deg) ||
         (b.next == i && m.runs[i].angle > kWeights.slit_deg);
}

/// Pieces of a row are sewn in their order.
double row_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceRow &x = m.rows[a.panel], &y = m.rows[b.panel];
  if (x.row == kNone || x.row != y.row || x.place == y.place) return 0;
  const bool after = y.place - x.place == 1 || x.place - y.place == x.size - 1;
  const bool before = x.place - y.place == 1 || y.place - x.place == x.size - 1;
  if (!after && !before) return kWeights.not_in_order;
  if (after && before) return kWeights.next_in_row;
  // Numbers run from left to right, as writing does.
  const SeamRun &first = after ? a : b, &second = after ? b : a;
  return kWeights.next_in_row * (faces_right(m, first) - faces_right(m, second)) / 2;
}

/// Whether the run is as the middle of the body is, and `other` is so as well, behind it and longer.
bool is_before_middle(const SeamModel& m, const SeamRun& run, const SeamRun& other) {
  const Vec2 out = normalized(-perpendicular(chord(other)));
  return is_middle(m, run) && is_middle(m, other) && run.mirror_edge != kNone && other.length > run.length &&
         faces_right(m, run) * faces_right(m, other) > 0 &&
         dot(run.at[kSamples / 2] - other.at[kSamples / 2], out) > kWeights.vent_out_mm;
}

/// Whether the run stands out by a step from a longer one that may lie in the middle: so do vents and flies.
bool stands_out(const SeamModel& m, const SeamRun& run) {
  const auto is_step = [&](const SeamRun& step) {
    return step.length < run.length / 2 && rise(m, step) < kWeights.facing;
  };
  const SeamRun& after = m.runs[run.next];
  if (is_step(after) && is_before_middle(m, run, m.runs[after.next])) return true;
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    const SeamRun& step = m.runs[other.next];
    return other.panel == run.panel && &m.runs[step.next] == &run && is_step(step) &&
           is_before_middle(m, run, other);
  });
}

/// Whether a run twice as long faces the same side of its piece, along the grain as well: beside the middle
/// of a back, a shorter edge is that of a vent or a fly.
bool is_vent(const SeamModel& m, const SeamRun& run) {
  const double side = faces_right(m, run);
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.length > 2 * run.length && other.mirror_edge != kNone &&
           std::abs(other.turn.back()) < kWeights.curved_deg &&
           rise(m, other) > kWeights.twin_straight_rise &&
           side * faces_right(m, other) > kWeights.facing * kWeights.facing;
  });
}

/// Mirrored pieces meet in a straight line along the grain, as at a centre front, rather than along a hollow
/// (a neck, an armhole) or across the grain (a hem).
double twin_merit(const SeamModel& m, const SeamRun& run, double along_grain) {
  const PieceKind kind = m.words[run.panel].kind;
  const bool round = run.turn.back() > kWeights.twin_round_deg;
  double merit =
      (round ? kWeights.twin_across_round : kWeights.twin_across) * (1 - along_grain * along_grain);
  if (bend_of(run) < kWeights.straight_deg && along_grain > kWeights.twin_straight_rise && !is_vent(m, run) &&
      !stands_out(m, run))
    merit += kind == PieceKind::kHood ? kWeights.twin_face : kWeights.twin_straight;
  if (run.turn.back() < kWeights.twin_hollow_deg && kind == PieceKind::kLegs)
    merit += kWeights.twin_crotch;
  else if (run.turn.back() < kWeights.twin_hollow_deg)
    merit += kWeights.twin_hollow *
             std::clamp((kWeights.twin_upright_rise - along_grain) / kWeights.twin_upright_width, 0.0, 1.0);
  if (run.open_front) merit += kWeights.twin_round_front;
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

/// Whether the run is a half of an edge that mirrors itself.
bool ends_in_middle(const SeamModel& m, const SeamRun& run) {
  return m.twin[run.panel] == run.panel && run.mirror_edge == run.edge && run.to - run.from == 0.5;
}

/// Ends of both runs that meet and are cuts: nothing is there to cut them for.
int cut_ends_that_meet(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along) {
  if (ends_in_middle(m, a) && ends_in_middle(m, b)) return 0;
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
double length_part(const SeamModel& m, Index i, Index j, bool lengths, bool counterparts, bool gathers) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  double merit = lengths ? length_merit(a.length, b.length) : 0;
  if (gathers && lengths && difference(a, b) < kWeights.gathered_most)
    merit = std::max(merit, kWeights.gathered_least - kWeights.gathered_slope * difference(a, b));
  // Mirrored edges are of one length whether they are sewn or not: that says little.
  if (m.mirror[i] == j || a.panel == b.panel) merit = std::min(merit, kWeights.most_of_twins);
  if (lengths && counterparts) merit = std::min(merit, kWeights.most_of_counterparts);
  const bool straight = a.straight && b.straight;
  const double fair = straight ? kWeights.fair_straight : kWeights.fair_curved, off = difference(a, b);
  const bool known = m.upright[a.panel] && m.upright[b.panel];
  if (known && std::min(rise(m, a), rise(m, b)) > kWeights.upright)
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
  if (mirrored && words.face != 0) return kWeights.own_front;
  const bool tube =
      mirrored && a.straight && b.straight && std::min(rise(m, a), rise(m, b)) > kWeights.own_tube_rise;
  return tube ? kWeights.own_tube : kWeights.own_piece;
}

}  // namespace

std::array<double, 2> pair_merit(const SeamModel& m, Index i, Index j, bool lengths) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  const bool twins = m.mirror[i] == j;
  const std::vector<Index>& alike = m.counterparts[i];
  const bool counterparts = std::find(alike.begin(), alike.end(), j) != alike.end();
  const int hangs = told_to_hang(m, a, b);
  const bool gathers = hangs > 0 || is_cap(m, a, b);
  double merit = length_part(m, i, j, lengths, counterparts, gathers) + shape_merit(a, b) +
                 facing_merit(m, a, b) + kind_merit(m, a, b, hangs);
  if (hangs > 0 && takes_both_halves(m, i, j)) merit += kWeights.half_takes_all;
  if (!twins && std::max(a.turn.back(), b.turn.back()) < kWeights.hollow_deg)
    merit += are_torsos(m, i, j) ? kWeights.two_armholes : kWeights.two_hollows;
  if (turns_in(m, a) && turns_in(m, b)) merit += kWeights.two_corners;
  merit += row_merit(m, a, b);
  if (a.panel == b.panel) {
    merit += own_piece_part(m, i, j) + (is_slit(m, a, i, b, j) ? kWeights.slit : 0);
  } else {
    merit += name_merit(m.words[a.panel], m.words[b.panel], twins, twins || counterparts,
                        is_middle(m, a) && is_middle(m, b));
    merit += middle_merit(m, a, b);
    if (twins)
      merit += twin_merit(m, a, rise(m, a));
    else if (stands_out(m, a) || stands_out(m, b))
      merit += kWeights.vent;
  }
  std::array<double, 2> both{};
  for (const bool along : {false, true})
    both[along] = merit + kWeights.height * height_merit(m, a, b, along) + notch_merit(a, b, along) +
                  kWeights.cut_to_cut * cut_ends_that_meet(m, a, b, along);
  // Parts were cut to fit: that they agree says less, and together they are one coincidence.
  if (lengths && (is_cut(a) || is_cut(b)))
    for (double& x : both)
      x = std::min(x, weight_of_part(a, b) * x) +
          (!gathers && difference(a, b) > kWeights.cut_ease ? kWeights.cut_differs : 0);
  return both;
}

}  // namespace toile::seams
