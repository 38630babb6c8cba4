#include "core/pattern/seams/bodice.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Whether the run lies in the upper part of its piece, where a shoulder is.
bool lies_high(const SeamModel& m, const SeamRun& run) {
  const Vec2 up = m.up[run.panel];
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const SeamRun& other : m.runs) {
    if (other.panel != run.panel) continue;
    low = std::min(low, dot(other.at[0], up));
    high = std::max(high, dot(other.at[0], up));
  }
  const double least = std::min(dot(run.at.front(), up), dot(run.at.back(), up));
  return least > high - kPairWeights.shoulder_high * (high - low);
}

}  // namespace

double inwards(const SeamModel& m, const SeamRun& run) {
  const PieceWords& words = m.words[run.panel];
  return m.handed * words.side * words.face * faces_right(m, run);
}

bool is_shoulder(const SeamModel& m, const SeamRun& run) {
  const bool slopes = run.up > kPairWeights.facing && run.up < kPairWeights.level_up;
  return m.words[run.panel].kind == PieceKind::kTorso && m.upright[run.panel] &&
         bend_of(run) < kPairWeights.straight_deg && slopes;
}

bool is_neckline(const SeamModel& m, const SeamRun& run) {
  const PieceWords& words = m.words[run.panel];
  if (words.kind != PieceKind::kTorso || words.face == 0 || !m.upright[run.panel]) return false;
  if (run.turn.back() > kPairWeights.neck_deg || run.from > 0 || run.to < 1) return false;
  const SeamRun &before = run_before(m, run), &after = m.runs[run.next];
  const auto is_centre = [&](const SeamRun& other) {
    return rise(m, other) > kPairWeights.twin_straight_rise && from_side(m, other) > 0;
  };
  const bool first = is_shoulder(m, before), last = is_shoulder(m, after);
  return (first && last) || (first && is_centre(after)) || (last && is_centre(before));
}

double slopes_to(const SeamModel& m, Index panel) {
  const Vec2 up = m.up[panel], right{up.y, -up.x};
  const SeamRun* shoulder = nullptr;
  for (const SeamRun& run : m.runs) {
    const double slope = rise(m, run);
    const bool one = run.panel == panel && run.up > kPairWeights.facing &&
                     bend_of(run) < kPairWeights.straight_deg && slope > kPairWeights.shoulder_slope &&
                     lies_high(m, run);
    if (one && (shoulder == nullptr || run.length > shoulder->length)) shoulder = &run;
  }
  if (shoulder == nullptr) return 0;
  const Vec2 along = shoulder->at.back() - shoulder->at.front();
  return std::copysign(1, dot(along, up) * dot(along, right));
}

double from_side(const SeamModel& m, const SeamRun& run) {
  const Index twin = m.twin[run.panel];
  if (m.words[run.panel].side != 0) return inwards(m, run);
  if (twin == kNone || twin == run.panel) return 0;
  if (const double neck = slopes_to(m, run.panel); neck != 0) return neck * faces_right(m, run);
  const SeamRun* middle = nullptr;
  for (const SeamRun& other : m.runs) {
    const bool line = rise(m, other) > kPairWeights.twin_straight_rise &&
                      std::abs(other.turn.back()) < kPairWeights.curved_deg;
    if (other.panel != run.panel || (!line && !other.open_front)) continue;
    if (middle == nullptr || other.open_front || (!middle->open_front && other.length > middle->length))
      middle = &other;
  }
  return middle == nullptr ? 0 : std::copysign(1, faces_right(m, *middle)) * faces_right(m, run);
}

bool leaves_neck(const SeamModel& m, const SeamRun& run) {
  const auto meets = [&](const SeamRun& other) {
    return &m.runs[run.next] == &other || &m.runs[other.next] == &run;
  };
  const Index twin = m.twin[run.panel];
  return std::none_of(m.runs.begin(), m.runs.end(),
                      [&](const SeamRun& other) {
                        if (other.panel != run.panel || !meets(other)) return false;
                        if (twin == run.panel) return other.mirror_edge == run.edge;
                        return rise(m, other) > kPairWeights.middle_rise && from_side(m, other) > 0;
                      }) &&
         (twin != run.panel || run.mirror_edge != run.edge) && twin != kNone;
}

bool meets_shoulder(const SeamModel& m, const SeamRun& run) {
  const auto is_top = [&](const SeamRun& other) {
    return other.up > kPairWeights.facing && lies_high(m, other) && leaves_neck(m, other) &&
           from_side(m, run) <= 0;
  };
  return is_top(m.runs[run.next]) || is_top(run_before(m, run));
}

bool has_face(const SeamModel& m, int face) {
  return std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& words) {
    return words.kind == PieceKind::kTorso && words.face == face;
  });
}

bool has_whole_back(const SeamModel& m) {
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p)
    if (m.words[p].kind == PieceKind::kTorso && m.words[p].face < 0 && m.twin[p] == p) return true;
  return false;
}

}  // namespace toile::seams
