#include "core/pattern/seams/vents.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Whether the run is as the middle of the body is, and `other` runs along the grain as well, behind it and
/// longer, straight or shaped a little as a fitted back or an elbow; `end` is where `other` comes to the step
/// between them.
bool is_before_line(const SeamModel& m, const SeamRun& run, const SeamRun& other, Vec2 end) {
  const Vec2 out = normalized(-perpendicular(chord(other)));
  const bool line = rise(m, other) > kPairWeights.twin_straight_rise &&
                    std::abs(other.turn.back()) < kPairWeights.curved_deg;
  return is_middle(m, run) && line && run.mirror_edge != kNone && edge_length(other) > run.length &&
         faces_right(m, run) * faces_right(m, other) > 0 &&
         dot(run.at[SeamRun::kSamples / 2] - end, out) > kPairWeights.vent_out_mm;
}

/// Whether a run twice as long faces the same side of its piece, along the grain as well: beside the middle
/// of a back, a shorter edge is that of a vent or a fly.
bool is_vent(const SeamModel& m, const SeamRun& run) {
  const double side = faces_right(m, run);
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.length > 2 * run.length && other.mirror_edge != kNone &&
           std::abs(other.turn.back()) < kPairWeights.curved_deg &&
           rise(m, other) > kPairWeights.twin_straight_rise &&
           side * faces_right(m, other) > kPairWeights.facing * kPairWeights.facing;
  });
}

/// Whether the run itself is the one beyond the step.
bool is_beyond_step(const SeamModel& m, const SeamRun& run) {
  const auto is_step = [&](const SeamRun& step) {
    return step.length < kPairWeights.vent_step * run.length && rise(m, step) < kPairWeights.facing;
  };
  const SeamRun& after = m.runs[run.next];
  if (const SeamRun& other = m.runs[after.next];
      is_step(after) && is_before_line(m, run, other, other.at.front()))
    return true;
  const SeamRun& step = run_before(m, run);
  const SeamRun& other = run_before(m, step);
  return is_step(step) && is_before_line(m, run, other, other.at.back());
}

/// Whether the outline runs on from the start of the one run to the other, bent a little as at the fold of a
/// hem.
bool bends_little(const SeamRun& later) { return std::abs(later.angle - 180) < kPairWeights.vent_bend_deg; }

/// Whether the run is of a front and goes on aslant from the middle of the body: an open neck.
bool is_beside_middle(const SeamModel& m, const SeamRun& run) {
  if (m.words[run.panel].kind != PieceKind::kTorso || m.words[run.panel].face <= 0) return false;
  return rise(m, run) < kPairWeights.middle_rise &&
         std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& middle) {
           return middle.panel == run.panel && middle.straight &&
                  rise(m, middle) > kPairWeights.middle_rise &&
                  faces_right(m, middle) * faces_right(m, run) > 0 &&
                  (&m.runs[middle.next] == &run || &m.runs[run.next] == &middle);
         });
}

}  // namespace

bool stands_out(const SeamModel& m, const SeamRun& run) {
  if (is_beyond_step(m, run)) return true;
  const SeamRun& after = m.runs[run.next];
  if (rise(m, run) < kPairWeights.twin_straight_rise) return false;
  if (bends_little(after) && is_beyond_step(m, after)) return true;
  return bends_little(run) && is_beyond_step(m, run_before(m, run));
}

bool turns_in(const SeamModel& m, const SeamRun& run) {
  const auto in = [](double angle) {
    return angle > kPairWeights.turns_in_deg && angle < 360 - kPairWeights.turns_in_deg / 3;
  };
  const SeamRun& after = m.runs[run.next];
  if (in(after.angle) && !stands_out(m, m.runs[after.next])) return true;
  return in(run.angle) && !stands_out(m, run_before(m, run_before(m, run)));
}

double twin_merit(const SeamModel& m, const SeamRun& run, double along_grain) {
  const PieceKind kind = m.words[run.panel].kind;
  const bool round = run.turn.back() > kPairWeights.twin_round_deg;
  double merit =
      (round ? kPairWeights.twin_across_round : kPairWeights.twin_across) * (1 - along_grain * along_grain);
  // A fitted back is shaped a little in its middle.
  const bool back = (kind == PieceKind::kTorso || kind == PieceKind::kSkirt) && m.words[run.panel].face < 0;
  if (bend_of(run) < (back ? kPairWeights.curved_deg : kPairWeights.straight_deg) &&
      along_grain > kPairWeights.twin_straight_rise && !is_vent(m, run) && !stands_out(m, run) &&
      !m.opens[run.panel])
    merit += kind == PieceKind::kHood ? kPairWeights.twin_face : kPairWeights.twin_straight;
  const bool hollow = run.turn.back() < kPairWeights.twin_hollow_deg;
  if (hollow && kind == PieceKind::kHood) merit += kPairWeights.twin_hollow_face;
  if (hollow && kind == PieceKind::kLegs)
    merit += kPairWeights.twin_crotch;
  else if (hollow)
    merit += kPairWeights.twin_hollow *
             std::clamp((kPairWeights.twin_upright_rise - along_grain) / kPairWeights.twin_upright_width, 0.0,
                        1.0);
  if (run.open_front) merit += kPairWeights.twin_round_front;
  if (kind == PieceKind::kLegs && begins_at_hem(m, run)) merit += kPairWeights.twin_leg_side;
  if (stands_out(m, run)) merit += kind == PieceKind::kSkirt ? kPairWeights.vent : kPairWeights.twin_vent;
  return merit;
}

bool stays_open(const SeamModel& m, const SeamRun& a, const SeamRun& b) {
  const PieceWords &x = m.words[a.panel], &y = m.words[b.panel];
  if (x.layer || y.layer) return false;
  if (a.open_front || b.open_front) return true;
  if (a.panel != b.panel) {
    const bool neck = is_beside_middle(m, a) && is_beside_middle(m, b);
    return (m.opens[a.panel] || neck) && m.twin[a.panel] == b.panel;
  }
  const bool opens = std::any_of(m.opens.begin(), m.opens.end(), [](char any) { return any != 0; });
  return opens && x.kind == PieceKind::kCollar;
}

}  // namespace toile::seams
