#include "core/pattern/seams/never_meet.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/round_stand.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Whether both are the long edges of one strip, which would make a hose of it.
bool are_along_strip(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  constexpr double kLong = 0.4;  // of the outline
  if (a.panel != b.panel || m.lines[a.panel] != 4) return false;
  const auto is_long = [&](const SeamRun& run) {  // or a part of one
    return run.length > kLong * (run.to - run.from) * m.girth[run.panel];
  };
  return is_long(a) && is_long(b);
}

/// Whether both are of the left and the right leg, of the same half, and lie away from the crotch.
bool are_outer_legs(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  if (a.panel == b.panel || m.twin[a.panel] != b.panel) return false;
  const auto is_outer = [&](const SeamRun& run) {
    return m.crotch_side[run.panel] * faces_right(m, run) < -kPairWeights.facing;
  };
  return is_outer(a) && is_outer(b);
}

/// Whether the run is around the face: straight, beside a longer edge of the hood that goes over the head.
bool is_face_of_hood(const SeamModel& m, const SeamRun& run) {
  constexpr double kStraight = 10, kOverHead = 30;  // degrees
  if (m.words[run.panel].kind != PieceKind::kHood || std::abs(run.turn.back()) > kStraight) return false;
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.line_turn > kOverHead && edge_length(other) > edge_length(run);
  });
}

/// Whether a hood would be sewn to the bodice by what goes around the face or over the head: it hangs there
/// by what faces down.
bool hangs_by_no_neck(const SeamModel& m, const SeamRun& hood, const SeamRun& bodice) {
  constexpr double kDown = -0.5;
  const PieceWords& words = m.words[hood.panel];
  if (words.kind != PieceKind::kHood || words.layer || m.words[bodice.panel].kind != PieceKind::kTorso)
    return false;
  return hood.up > kDown && std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& neck) {
           return neck.panel == hood.panel && neck.up < -kPairWeights.facing;
         });
}

/// Whether the two are the upper edges of a front and a back in their middles: the head goes through there.
bool shut_neck(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const auto is_upper = [&](const SeamRun& run) {
    return m.words[run.panel].kind == PieceKind::kTorso && m.upright[run.panel] &&
           run.up > kPairWeights.facing && run.mirror_panel == run.panel && run.mirror_edge == run.edge;
  };
  return m.words[a.panel].face * m.words[b.panel].face < 0 && is_upper(a) && is_upper(b);
}

/// Whether they are of two cuffs that go around a limb each: what is drawn in halves has faces.
bool are_of_two_cuffs(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  return a.panel != b.panel && x.kind == PieceKind::kCuff && y.kind == PieceKind::kCuff && x.face == 0 &&
         y.face == 0 && !x.layer && !y.layer && m.lines[a.panel] == m.lines[b.panel] &&
         equally_long(m.girth[a.panel], m.girth[b.panel]);
}

/// Whether a cuff would be closed to a ring that no hand passes.
bool is_too_tight(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  return a.panel == b.panel && m.words[a.panel].kind == PieceKind::kCuff &&
         (m.girth[a.panel] - a.length - b.length) / 2 < kPairWeights.least_ring_mm;
}

/// Whether one half of a waistband would be closed to a ring of its own: its ends are the other half's.
bool closes_half_band(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords& words = m.words[a.panel];
  return a.panel == b.panel && words.kind == PieceKind::kBand && words.side != 0 && !words.limb &&
         !words.leg && m.twin[a.panel] != kNone && m.twin[a.panel] != a.panel;
}

/// Whether the yoke of a back or a front would be closed to a ring: its ends are the sides' or the sleeves'.
bool closes_yoke(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords& words = m.words[a.panel];
  return a.panel == b.panel && words.yoke && words.face != 0 && a.mirror_panel == a.panel &&
         a.mirror_edge == b.edge;
}

/// Whether the fall of a collar on a stand would be closed to a ring: its ends lie open on the chest.
bool closes_fall(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const auto is_collar = [](const PieceWords& w) { return w.kind == PieceKind::kCollar && !w.layer; };
  const PieceWords& words = m.words[a.panel];
  return a.panel == b.panel && is_collar(words) && !words.stand &&
         std::any_of(m.words.begin(), m.words.end(),
                     [&](const PieceWords& w) { return is_collar(w) && w.stand; });
}

/// Whether a part of a skirt would be closed to a cone by its sides, although there is another one alike:
/// they are sewn to each other.
bool closes_gore(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords& words = m.words[a.panel];
  if (a.panel != b.panel || words.kind != PieceKind::kSkirt || !equally_long(a.length, b.length))
    return false;
  for (Index other = 0; other < static_cast<Index>(m.words.size()); ++other)
    if (other != a.panel && m.words[other].kind == PieceKind::kSkirt && !m.words[other].layer &&
        same_edges(m, a.panel, other))
      return true;
  return false;
}

/// Whether one is of a belt and the other of what no belt is ever sewn to: it lies around a garment, but it
/// may be what a skirt's waistband is called.
bool is_off_belt(const SeamModel& m, const SeamRun& belt, const SeamRun& other) {
  return m.words[belt.panel].belt && belt.panel != other.panel &&
         m.words[other.panel].kind != PieceKind::kSkirt;
}

/// Whether both are of the same part of sleeves that have another one, above or under the arm, before or
/// behind: each part is sewn to the other.
bool are_one_part_of_sleeve(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (x.kind != PieceKind::kSleeve || y.kind != PieceKind::kSleeve) return false;
  const auto has = [&](auto is) {
    return std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& w) {
      return w.kind == PieceKind::kSleeve && w.layer == x.layer && is(w);
    });
  };
  if (x.sleeve_part * y.sleeve_part > 0)
    return has([&](const PieceWords& w) { return w.sleeve_part == -x.sleeve_part; });
  return x.sleeve_part == 0 && x.face * y.face > 0 &&
         has([&](const PieceWords& w) { return w.face == -x.face; });
}

/// Whether yokes of the left and the right leg would meet at the shorter of their ends: they are deeper in
/// the middle of the back than at the sides.
bool meets_at_side_of_yoke(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  constexpr double kDeeper = 1.15;  // times
  const PieceWords& words = m.words[a.panel];
  const bool halves = words.yoke && words.face < 0 && a.panel != b.panel && m.twin[a.panel] == b.panel;
  if (!halves || m.lines[a.panel] != 4) return false;
  const bool legs = std::any_of(m.words.begin(), m.words.end(),
                                [](const PieceWords& w) { return w.kind == PieceKind::kLegs; });
  const SeamRun& opposite = m.runs[m.runs[a.next].next];
  return legs && opposite.panel == a.panel && opposite.length > kDeeper * a.length;
}

}  // namespace

bool never_meet(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  if (are_of_two_cuffs(m, a, b) || is_too_tight(m, a, b) || closes_half_band(m, a, b) ||
      closes_yoke(m, a, b) || closes_gore(m, a, b) || closes_fall(m, a, b) ||
      meets_at_side_of_yoke(m, a, b) || are_one_part_of_sleeve(m, a, b) || is_off_belt(m, a, b) ||
      is_off_belt(m, b, a) || misses_round_stand(m, a, b))
    return true;
  if (m.words[a.panel].bib && m.words[b.panel].bib && (a.panel == b.panel || m.twin[a.panel] != b.panel))
    return true;
  const bool shuts_hood = m.twin[a.panel] == b.panel && is_face_of_hood(m, a) && is_face_of_hood(m, b);
  if (hangs_by_no_neck(m, a, b) || hangs_by_no_neck(m, b, a)) return true;
  return shuts_hood || shut_neck(m, a, b) || are_along_strip(m, a, b) || are_outer_legs(m, a, b);
}

}  // namespace toile::seams
