#include "core/pattern/seams/armholes.h"

#include "core/pattern/seams/bodice.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Whether the runs are of a side that goes up to the shoulder and of the level top of a sleeve without a
/// cap.
bool is_dropped(const SeamModel& m, const SeamRun& torso, const SeamRun& sleeve) {
  return !sleeve.cap && m.upright[sleeve.panel] && sleeve.up > kPairWeights.facing &&
         meets_shoulder(m, torso) && !begins_at_hem(m, torso);
}

/// Whether the run is of a sleeve that stands upright and none of its ends meets the seam under the arm.
bool is_off_underarm(const SeamModel& m, const SeamRun& sleeve) {
  const bool meets = (sleeve.from == 0 && begins_at_hem(m, run_before(m, sleeve))) ||
                     (sleeve.to == 1 && begins_at_hem(m, m.runs[sleeve.next]));
  return m.words[sleeve.panel].kind == PieceKind::kSleeve && m.upright[sleeve.panel] && !meets;
}

}  // namespace

bool is_below_arm(const SeamModel& m, const SeamRun& run) {
  const SeamRun& after = m.runs[run.next];
  if (after.angle > kPairWeights.turns_in_deg && begins_at_hem(m, after)) return true;
  return run.angle > kPairWeights.turns_in_deg && begins_at_hem(m, run_before(m, run));
}

bool is_raglan_slope(const SeamModel& m, const SeamRun& slope, const SeamRun& end) {
  return slope.up > kPairWeights.armhole_slope && !begins_at_hem(m, slope) && slope.length > end.length;
}

bool is_armhole_end(const SeamModel& m, const SeamRun& run) {
  const auto is_slope = [&](const SeamRun& other) { return is_raglan_slope(m, other, run); };
  const auto is_side = [&](const SeamRun& other) {  // a middle goes up to the neck
    return begins_at_hem(m, other) && from_side(m, other) <= 0;
  };
  const SeamRun &before = run_before(m, run), &after = m.runs[run.next];
  return m.words[run.panel].kind == PieceKind::kTorso && m.upright[run.panel] && !begins_at_hem(m, run) &&
         run.up > kPairWeights.facing && run.turn.back() < kPairWeights.armhole_end_deg &&
         ((is_side(before) && is_slope(after)) || (is_side(after) && is_slope(before)));
}

bool is_off_armhole_end(const SeamModel& m, const SeamRun& torso, const SeamRun& other) {
  return is_armhole_end(m, torso) && (is_neck(m.words[other.panel].kind) || is_off_underarm(m, other));
}

bool is_for_arm(const SeamModel& m, const SeamRun& run) {
  return m.words[run.panel].kind == PieceKind::kTorso && meets_shoulder(m, run);
}

bool is_set_on_turned(const SeamModel& m, const SeamRun& torso, const SeamRun& sleeve, bool along) {
  if (m.words[torso.panel].kind != PieceKind::kTorso || m.words[sleeve.panel].kind != PieceKind::kSleeve)
    return false;
  const bool half = (sleeve.from > 0) != (sleeve.to < 1);
  if (!half || !is_dropped(m, torso, sleeve)) return false;
  const bool rises = dot(torso.at.back() - torso.at.front(), m.up[torso.panel]) > 0;
  const bool shoulder_at_start = rises != along;  // of the sleeve's half
  return shoulder_at_start == (sleeve.from == 0);
}

double armhole_merit(const SeamModel& m, const SeamRun& torso, const SeamRun& sleeve) {
  const auto whole = [](const SeamRun& run) { return run.from == 0 && run.to == 1; };
  const bool differ = whole(torso) && whole(sleeve) && difference(torso, sleeve) > kPairWeights.tailored_ease;
  // Between its notches a tailored sleeve is eased by more than any other seam: it is set in as a whole.
  const auto notched = [](const SeamRun& run) { return run.from_notch || run.to_notch; };
  if (m.tailored && (!sleeve.cap || differ || notched(torso) || notched(sleeve)))
    return kPairWeights.never_meet;
  const bool wrist = m.upright[sleeve.panel] && sleeve.up < -kPairWeights.facing;
  const bool neck = m.upright[torso.panel] && torso.up > kPairWeights.facing &&
                    m.twin[torso.panel] == torso.panel && torso.mirror_edge == torso.edge;
  const bool from_hem =  // a yoke's lower edge is none
      begins_at_hem(m, torso) && torso.from == 0 && torso.to == 1 && !m.words[torso.panel].yoke;
  const bool hem = m.upright[torso.panel] && torso.up < -kPairWeights.facing && !is_below_arm(m, torso);
  if (wrist || neck || hem || from_hem || is_neckline(m, torso)) return kPairWeights.never_meet;
  const bool dropped = is_dropped(m, torso, sleeve);
  if (dropped) return kPairWeights.armhole + kPairWeights.cap;
  const bool hollow =
      torso.turn.back() < kPairWeights.twin_hollow_deg && inwards(m, torso) < kPairWeights.inner;
  return (hollow ? kPairWeights.armhole : -kPairWeights.armhole) +
         (sleeve.cap ? kPairWeights.cap : -kPairWeights.cap);
}

}  // namespace toile::seams
