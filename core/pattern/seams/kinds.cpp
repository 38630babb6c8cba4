#include "core/pattern/seams/kinds.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/armholes.h"
#include "core/pattern/seams/bodice.h"
#include "core/pattern/seams/cuts.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/never_meet.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Whether the two pieces are as large as each other: gores stand side by side.
bool gores(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const double x = m.girth[a.panel], y = m.girth[b.panel];
  return std::abs(x - y) < kPairWeights.gores * std::max(x, y);
}

/// Whether `cuff` is the upper end of what hangs from the sleeve that `end` is on, and that the opening of
/// the sleeve: sleeves without a grain line mostly lie, with it to a side.
bool is_cuffed(const SeamModel& m, const SeamRun& end, const SeamRun& cuff) {
  const bool lies = m.words[end.panel].kind == PieceKind::kSleeve && !m.upright[end.panel];
  return lies && cuff.up > kPairWeights.facing && std::abs(end.up) < kPairWeights.lying &&
         hangs_from(m, cuff.panel, end.panel) > 0;
}

/// A piece of two edges has its sides somewhere on them, and none of the two is an upper or lower end.
/// A cuff with round ends is one that hangs by its straight edge all the same.
bool has_no_sides(const SeamModel& m, const SeamRun& run) {
  return m.lines[run.panel] < 3 && m.words[run.panel].kind != PieceKind::kCuff;
}

/// Whether both are of gores that numbers tell apart.
bool in_one_row(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  return m.rows[a.panel].row != kNone && m.rows[a.panel].row == m.rows[b.panel].row;
}

/// Whether the run is the upper edge of a back that hangs from a yoke, over both shoulders or the back's own:
/// the neck is the yoke's.
bool is_below_yoke(const SeamModel& m, const SeamRun& run) {
  if (m.words[run.panel].face >= 0 || run.up < kPairWeights.facing_fully) return false;
  if (run.turn.back() < kPairWeights.neck_deg) return false;  // hollow, as a neck
  return std::any_of(m.words.begin(), m.words.end(),
                     [](const PieceWords& w) { return w.yoke && w.face <= 0 && !w.layer; });
}

/// Whether the run is of a bodice or its yoke and cannot be at its neck: it faces the side, slopes as a
/// shoulder, or is the hem, or comes up from there; bands go up fronts in halves.
bool is_off_neck(const SeamModel& m, const SeamRun& run) {
  const PieceWords& words = m.words[run.panel];
  const bool hem = m.upright[run.panel] && run.up < -kPairWeights.facing_fully;
  if (words.yoke) return run.line_turn > kPairWeights.neck_deg;  // its neck is hollow
  if (words.kind != PieceKind::kTorso) return false;
  const bool parted_front = words.face >= 0 && m.twin[run.panel] != run.panel;
  constexpr double kShort = 40;  // mm: so short a part of a neck is as straight as a shoulder
  const bool whole = run.from == 0 && run.to == 1;
  const bool of_hollow = !whole && run.line_turn < kPairWeights.neck_deg;
  return hem || is_below_yoke(m, run) || from_side(m, run) < -kPairWeights.off_neck ||
         ((whole || run.length > kShort) && !of_hollow && is_shoulder(m, run)) ||
         (!parted_front && begins_at_hem(m, run));
}

/// Whether the runs are of a bodice and of a collar that sits on a stand, which goes around the neck: only
/// lapels meet such a collar.
bool passes_stand(const SeamModel& m, const SeamRun& collar, const SeamRun& torso) {
  const PieceWords &upper = m.words[collar.panel], &lower = m.words[torso.panel];
  if (upper.kind != PieceKind::kCollar || upper.stand || upper.layer) return false;
  const bool bodice = lower.kind == PieceKind::kTorso && (lower.face < 0 || !is_lapel(m, torso.panel));
  return (lower.yoke || bodice) && std::any_of(m.words.begin(), m.words.end(), [](const PieceWords& w) {
           return w.kind == PieceKind::kCollar && w.stand && !w.layer;
         });
}

bool on_limb(const PieceWords& words) { return words.limb || words.leg; }

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
  const double along = (dot(whole.at[SeamRun::kSamples / 2], right) - low) / (high - low);
  const double place = (static_cast<double>(row.place) + 0.5) / static_cast<double>(row.size);
  return kPairWeights.insert_place * std::abs(place - (m.words[whole.panel].face < 0 ? 1 - along : along));
}

/// Pieces of a collar meet at short ends; a lapel's long edges go to the neck, or to nothing.
bool is_long_in_collar(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const auto is_long = [&](const SeamRun& r) {
    return r.length > kPairWeights.collar_end * m.girth[r.panel];
  };
  return is_long(a) || is_long(b);
}

/// Whether the runs are those along which a collar sits on its stand: drafted as one line.
bool is_fold_on_stand(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  return m.words[a.panel].stand != m.words[b.panel].stand &&
         std::abs(a.length - b.length) < kPairWeights.fold_on_stand * a.length;
}

/// Whether the run is the outer edge of a collar that goes around its points or its round ends.
bool is_outer_of_collar(const SeamModel& m, const SeamRun& run) {
  return m.words[run.panel].kind == PieceKind::kCollar && run.turn.back() > kPairWeights.collar_bulges_deg;
}

/// Whether both pieces are known to be of one kind, which lie alike: or fronts and backs of a garment that
/// names no kinds.
bool is_named_alike(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (x.kind != y.kind || is_neck(x.kind)) return false;
  return x.kind != PieceKind::kOther || (x.face * y.face != 0 && !x.layer && !y.layer);
}

/// Whether an edge beside the run is hollow: a neck, or the waist of a circle skirt.
bool is_beside_hollow(const SeamModel& m, const SeamRun& run) {
  const auto hollow = [](const SeamRun& r) { return r.turn.back() < kPairWeights.neck_deg; };
  return hollow(m.runs[run.next]) || hollow(run_before(m, run));
}

/// What is said of two edges that are both level and up: two waists are never sewn together. But a front's
/// and a back's that leave a neck between them are shoulders that slope little, those beside a hollow neck
/// are a kimono's or a cape's, and beside a waist they are the ends of a skirt that is cut as half a circle.
double level_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (x.kind == PieceKind::kLegs && y.kind == PieceKind::kLegs) return kPairWeights.never_meet;
  const bool torsos = x.kind == PieceKind::kTorso && y.kind == PieceKind::kTorso;
  if (torsos && x.face * y.face < 0 && leaves_neck(m, a) && leaves_neck(m, b))
    return kPairWeights.torsos_shoulder;
  const bool beside = is_beside_hollow(m, a) && is_beside_hollow(m, b);
  const auto unnamed = [](const PieceWords& w) { return w.guessed || w.kind == PieceKind::kOther; };
  if (beside && x.face * y.face < 0 && unnamed(x) && unnamed(y)) return kPairWeights.level_shoulder;
  if (beside && a.panel == b.panel && x.kind == PieceKind::kSkirt && x.face == 0) return 0;
  return in_one_row(m, a, b) ? kPairWeights.waists_in_row : kPairWeights.two_waists;
}

/// Whether the piece is of a skirt or of legs that hang from a bodice.
bool is_below_bodice(const SeamModel& m, Index panel) {
  const PieceKind kind = m.words[panel].kind;
  if (kind != PieceKind::kSkirt && kind != PieceKind::kLegs) return false;
  return std::any_of(m.words.begin(), m.words.end(),
                     [](const PieceWords& w) { return w.kind == PieceKind::kTorso && !w.layer; });
}

/// A strap is sewn to something by its ends.
double strap_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const bool first = m.words[a.panel].kind == PieceKind::kStrap;
  const SeamRun &strap = first ? a : b, &other = first ? b : a;
  if (m.words[strap.panel].over_shoulder && is_below_bodice(m, other.panel)) return kPairWeights.never_meet;
  const bool is_end = strap.length < kPairWeights.strap_end * m.girth[strap.panel];
  const bool closes = m.words[other.panel].kind == PieceKind::kBand && other.from == 0 && other.to == 1 &&
                      other.length < kPairWeights.strap_end * m.girth[other.panel];
  return is_end && !closes ? 0 : kPairWeights.never_meet;
}

/// Whether the runs are the upper edge of a band and the hem of a leg that it is far too long for, as
/// waistbands are.
bool is_waist_on_leg(const SeamModel& m, const SeamRun& band, const SeamRun& leg) {
  return m.words[band.panel].kind == PieceKind::kBand && m.words[leg.panel].kind == PieceKind::kLegs &&
         band.up > kPairWeights.facing && leg.up < -kPairWeights.facing &&
         m.girth[band.panel] / 2 > kPairWeights.waist_longer * leg.length;
}

/// Whether the runs are a collar's and the upper end of a sleeve that goes up to the neck between front and
/// back.
bool is_raglan_neck(const SeamModel& m, const SeamRun& collar, const SeamRun& sleeve) {
  return is_neck(m.words[collar.panel].kind) && sleeve.raglan_top;
}

/// Whether a front's middle would be sewn to a back's flank or side, or the other way round, although both
/// have flanks of their own to go to: princess seams and gores keep to their face of the body.
bool passes_flank(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (x.kind != y.kind || x.layer || y.layer || x.face * y.face >= 0) return false;
  const auto has_flank = [&](int face) {
    return std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& w) {
      return w.flank && w.face == face && w.kind == x.kind && !w.layer;
    });
  };
  if (!has_flank(x.face) || !has_flank(y.face)) return false;
  if (x.flank != y.flank) return true;
  return !x.flank && begins_at_hem(m, a) && begins_at_hem(m, b);
}

/// Whether the runs are a bodice's hem and a bodice's neck.
bool is_hem_on_neck(const SeamModel& m, const SeamRun& run, const SeamRun& neck) {
  return m.words[run.panel].kind == PieceKind::kTorso && m.upright[run.panel] &&
         run.up < -kPairWeights.armhole_slope && is_neckline(m, neck);
}

/// Whether the run may be a brief's crotch: short, between the openings for the legs.
bool is_crotch(const SeamModel& m, const SeamRun& run) {
  return run.length < kPairWeights.crotch * m.girth[run.panel] && lies_between_hollows(m, run);
}

}  // namespace

int told_to_hang(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  if (a.panel == b.panel) return 0;
  if (is_cuffed(m, a, b) || is_cuffed(m, b, a)) return 1;
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  if (std::min(a.up, b.up) > -kPairWeights.facing || std::max(a.up, b.up) < kPairWeights.facing) return 0;
  const PieceKind ka = m.words[a.panel].kind, kb = m.words[b.panel].kind;
  if (a.side || b.side || has_no_sides(m, a) || has_no_sides(m, b)) return 0;
  if (ka == kb && m.rows[a.panel].row == m.rows[b.panel].row && gores(m, a, b)) return 0;
  return a.up > 0 ? hangs_from(m, a.panel, b.panel) : hangs_from(m, b.panel, a.panel);
}

bool is_cap(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  if (m.tailored) return false;
  const PieceKind ka = m.words[a.panel].kind, kb = m.words[b.panel].kind;
  return (ka == PieceKind::kSleeve && kb == PieceKind::kTorso && a.length > b.length) ||
         (kb == PieceKind::kSleeve && ka == PieceKind::kTorso && b.length > a.length);
}

bool on_neck(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  return is_neck(m.words[a.panel].kind) || is_neck(m.words[b.panel].kind);
}

bool are_torsos(const SeamModel& m, Index i, Index j) {
  return m.words[m.runs[i].panel].kind == PieceKind::kTorso &&
         m.words[m.runs[j].panel].kind == PieceKind::kTorso;
}

double middle_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  const double ia = inwards(m, a), ib = inwards(m, b);
  const bool torsos = x.kind == PieceKind::kTorso && y.kind == PieceKind::kTorso;
  const bool own = torsos && x.side == y.side && std::min(ia, ib) > kPairWeights.fully_inner;
  const bool across = x.side != y.side && std::max(ia, ib) < -kPairWeights.inner;
  const auto is_outer = [&](const SeamRun& run) {  // which way the neck lies is surer than left and right
    return slopes_to(m, run.panel) * faces_right(m, run) < -kPairWeights.fully_inner && begins_at_hem(m, run);
  };
  const bool fronts = x.side != y.side && x.face > 0 && y.face > 0 && has_whole_back(m);
  const bool halves =
      m.twin[a.panel] == b.panel && x.side == 0 && x.face * y.face > 0 && has_face(m, -x.face);
  if (torsos && (fronts || halves) && is_outer(a) && is_outer(b)) return kPairWeights.outer_sides;
  return own || across ? kPairWeights.not_middle : 0;
}

bool takes_both_halves(const SeamModel& m, Index i, Index j) {
  const auto whole = [&](Index r) { return m.runs[r].from == 0 && m.runs[r].to == 1; };
  const auto takes = [&](Index half, Index all) {
    // The middle of a band between its notches is of both halves, too.
    if (!whole(all))
      return m.mirror[all] == all && is_half(m, m.runs[half].panel) && goes_all_around(m, m.runs[all].panel);
    return (is_half(m, m.runs[half].panel) && meets_halves(m, all)) ||
           (goes_all_around(m, m.runs[all].panel) && m.words[m.runs[half].panel].face != 0);
  };
  return takes(i, j) || takes(j, i);
}

double kind_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, int hangs) {
  if (never_meet(m, a, b)) return kPairWeights.never_meet;
  const PieceKind ka = m.words[a.panel].kind, kb = m.words[b.panel].kind;
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (ka == PieceKind::kStrap && kb == PieceKind::kStrap) return kPairWeights.two_straps;
  if (is_raglan_neck(m, a, b) || is_raglan_neck(m, b, a)) return 0;
  const bool cut_on =
      m.cut_on && (hangs_from(m, a.panel, b.panel) > 0 || hangs_from(m, b.panel, a.panel) > 0);
  if ((x.yoke && kb == PieceKind::kCuff) || (y.yoke && ka == PieceKind::kCuff))
    return kPairWeights.never_meet;
  if ((!ever_meet(ka, kb) && !cut_on) || (on_limb(x) && on_limb(y) && x.leg != y.leg))
    return kPairWeights.never_meet;
  if (ka == PieceKind::kStrap || kb == PieceKind::kStrap) return strap_merit(m, a, b);
  if (is_for_arm(m, a) && is_for_arm(m, b)) return kPairWeights.never_meet;
  if (is_off_armhole_end(m, a, b) || is_off_armhole_end(m, b, a)) return kPairWeights.never_meet;
  const bool left_and_right = m.twin[a.panel] == b.panel && a.panel != b.panel && x.face * y.face >= 0;
  if (left_and_right && (x.flank || (x.limb && y.limb))) return kPairWeights.both_sleeves;
  if ((is_neck(ka) && (y.flank || kb == PieceKind::kSleeve)) ||
      (is_neck(kb) && (x.flank || ka == PieceKind::kSleeve)))
    return kPairWeights.never_meet;  // it is under the arm, or around it
  if (passes_flank(m, a, b) || is_hem_on_neck(m, a, b) || is_hem_on_neck(m, b, a))
    return kPairWeights.never_meet;
  if (ka == PieceKind::kInsert || kb == PieceKind::kInsert)
    return kPairWeights.insert_face * x.face * y.face + insert_merit(m, a, b);
  if (ka == PieceKind::kSleeve && kb == PieceKind::kSleeve)
    return !a.cap && !b.cap ? 0 : m.tailored ? kPairWeights.never_meet : kPairWeights.cap_to_sleeve;
  if (ka == PieceKind::kCollar && kb == PieceKind::kCollar && x.layer != y.layer)
    return kPairWeights.never_meet;  // an under collar takes nothing from the collar that it lies below
  if (ka == PieceKind::kCollar && kb == PieceKind::kCollar)
    return is_long_in_collar(m, a, b) && !is_fold_on_stand(m, a, b) ? kPairWeights.collar_long : 0;
  if (ka == PieceKind::kTorso && kb == PieceKind::kSleeve) return armhole_merit(m, a, b);
  if (kb == PieceKind::kTorso && ka == PieceKind::kSleeve) return armhole_merit(m, b, a);
  const auto closed_middle = [&](const SeamRun& r) { return !m.opens[r.panel] && is_middle(m, r); };
  if ((is_neck(ka) && kb == PieceKind::kTorso && closed_middle(b)) ||
      (is_neck(kb) && ka == PieceKind::kTorso && closed_middle(a)))
    return kPairWeights.not_middle;
  if ((is_outer_of_collar(m, a) && kb == PieceKind::kTorso) ||
      (is_outer_of_collar(m, b) && ka == PieceKind::kTorso))
    return kPairWeights.never_meet;
  if ((is_neck(ka) && is_off_neck(m, b)) || (is_neck(kb) && is_off_neck(m, a)) || passes_stand(m, a, b) ||
      passes_stand(m, b, a))
    return kPairWeights.never_meet;
  const bool upright = m.upright[a.panel] && m.upright[b.panel];
  if (hangs > 0) return kPairWeights.hangs + (upright ? 0 : kPairWeights.hanging_face * x.face * y.face);
  if (is_waist_on_leg(m, a, b) || is_waist_on_leg(m, b, a)) return kPairWeights.never_meet;
  if (hangs < 0) return kPairWeights.hangs_not;
  const bool hanging = ka != kb && (hangs_from(ka, kb) > 0 || hangs_from(kb, ka) > 0);
  return hanging && upright && !is_neck(ka) && !is_neck(kb) ? kPairWeights.only_hangs : 0;
}

bool sweeps_to_wrist(const SeamModel& m, const SeamRun& run) {
  constexpr double kWide = -45, kGoesOn = 50;  // degrees
  if (m.words[run.panel].kind != PieceKind::kTorso || run.turn.back() > kWide) return false;
  const SeamRun &after = m.runs[run.next], &before = run_before(m, run);
  const auto goes_on = [](double corner) { return std::abs(corner - 180) < kGoesOn; };
  return begins_at_hem(m, run) || (goes_on(after.angle) && begins_at_hem(m, after)) ||
         (goes_on(run.angle) && begins_at_hem(m, before));
}

double facing_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  constexpr double mostly = kPairWeights.facing, fully = kPairWeights.facing_fully;
  if (!m.upright[a.panel] || !m.upright[b.panel]) return 0;
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  const double ua = a.up, ub = b.up;
  if (ua < -mostly && ub < -mostly) {
    const bool meet = (is_crotch(m, a) && is_crotch(m, b)) || (is_below_arm(m, a) && is_below_arm(m, b)) ||
                      (sweeps_to_wrist(m, a) && sweeps_to_wrist(m, b));
    return meet ? 0 : kPairWeights.two_hems;
  }
  if (ua > fully && ub > fully) return level_merit(m, a, b);
  const bool halves = m.twin[a.panel] == b.panel && a.panel != b.panel;
  const bool mirrored = a.mirror_panel == b.panel && a.mirror_edge == b.edge;
  if (std::min(ua, ub) > mostly && halves && !mirrored) return kPairWeights.two_waists;
  const double level = std::max(std::abs(ua), std::abs(ub)), upright = std::min(std::abs(ua), std::abs(ub));
  if (level > fully && upright < kPairWeights.side_up && is_named_alike(m, a, b))
    return kPairWeights.side_to_hem;
  if (std::min(ua, ub) > -mostly || std::max(ua, ub) < mostly) return 0;
  if (a.panel == b.panel) return kPairWeights.hem_to_own_waist;
  if (m.twin[a.panel] == b.panel) return kPairWeights.hem_to_twins_waist;
  const bool larger_hangs = (m.girth[a.panel] > m.girth[b.panel]) == (ua > 0);
  const int faces = x.face * y.face;
  if (faces < 0 && x.kind == PieceKind::kOther && is_named_alike(m, a, b)) return kPairWeights.hangs_across;
  return (larger_hangs ? kPairWeights.larger_hangs : kPairWeights.smaller_hangs) +
         kPairWeights.hanging_face * faces;
}

double name_merit(const PieceWords& a, const PieceWords& b, bool twins, bool alike, bool middle) {
  double merit = 0;
  if (twins && a.flank) return kPairWeights.both_sleeves;
  if (alike && a.limb && b.limb && a.face * b.face >= 0 && a.side * b.side <= 0)
    return kPairWeights.both_sleeves;
  if (a.side * b.side > 0) merit += kPairWeights.same_side;
  if (a.side * b.side < 0)
    merit += a.limb && b.limb                        ? kPairWeights.other_side_limbs
             : a.limb || b.limb                      ? kPairWeights.other_side_limb
             : twins || (middle && a.face == b.face) ? 0
                                                     : kPairWeights.other_side;
  if (a.limb != b.limb) merit += kPairWeights.limb_face * a.face * b.face;
  return merit;
}

double row_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceRow &x = m.rows[a.panel], &y = m.rows[b.panel];
  if (x.row == kNone || x.row != y.row || x.place == y.place) return 0;
  const bool after = y.place - x.place == 1 || x.place - y.place == x.size - 1;
  const bool before = x.place - y.place == 1 || y.place - x.place == x.size - 1;
  if (!after && !before) return kPairWeights.not_in_order;
  if (after && before) return kPairWeights.next_in_row;
  // Numbers run from left to right, as writing does.
  const SeamRun &first = after ? a : b, &second = after ? b : a;
  return kPairWeights.next_in_row * (faces_right(m, first) - faces_right(m, second)) / 2;
}

}  // namespace toile::seams
