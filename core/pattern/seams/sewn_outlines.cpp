#include "core/pattern/seams/sewn_outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Whether the run faces down along the grain. The hem of a wide skirt is round.
bool is_hem(const SeamModel& m, const SeamRun& run) {
  const Vec2 chord = run.at.back() - run.at.front();
  return m.upright[run.panel] &&
         dot(normalized(-perpendicular(chord)), m.up[run.panel]) < kGarmentWeights.hem;
}

/// Whether pieces of the kind end others: a cuff, a band, a collar.
bool is_trim(PieceKind kind) {
  return kind == PieceKind::kCuff || kind == PieceKind::kBand || kind == PieceKind::kCollar;
}

bool is_smooth(const SeamRun& run) { return std::abs(run.angle - 180) < kGarmentWeights.smooth_deg; }

/// A line ends where it bends: there a vent begins, or the next piece. Hoods are shaped by their corners, and
/// the seat of a leg cut in one piece is drawn with one.
bool middle_goes_on(const SeamModel& m, const SeamRun& run) {
  const PieceWords& words = m.words[run.panel];
  const bool seat = words.kind == PieceKind::kLegs && words.face == 0;
  return is_smooth(run) || words.kind == PieceKind::kHood || seat;
}

/// A leg that is cut in one piece has the middle of the front and that of the back; two panels of a skirt
/// that are their own mirror images are a front and a back, with two sides. Of twins the first one counts.
int lines_allowed(const SeamModel& m, Index p) {
  if (m.twin[p] <= p) return std::numeric_limits<int>::max();
  const PieceWords& words = m.words[p];
  const bool whole = m.nameless && words.kind == PieceKind::kSkirt && mirrors_itself(m, p);
  return (words.kind == PieceKind::kLegs && words.face == 0) || whole ? 2 : 1;
}

}  // namespace

SewnOutlines::SewnOutlines(const SeamModel& m) : partner_(m.runs.size(), kNone) {
  for (const SeamRun& run : m.runs)
    runs_.push_back({run.panel, run.next, kNone, m.mirror[runs_.size()],
                     run.turn.back() > kGarmentWeights.round_deg && !run.open_front && !is_hem(m, run),
                     is_smooth(run), is_trim(m.words[run.panel].kind), middle_goes_on(m, run)});
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) runs_[runs_[r].next].before = r;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p)
    panels_.push_back({m.words[p].kind != PieceKind::kTorso || m.words[p].layer, lines_allowed(m, p)});
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) count(r, 1);
}

/// Adds what is to be said of the run and the next one, or takes it away.
void SewnOutlines::count(Index r, int times) {
  const Run& run = runs_[r];
  const Run& next = runs_[run.next];
  Panel& panel = panels_[run.panel];
  const bool free = is_free(r);
  (free ? panel.open : panel.sewn) += times;
  if (!free && !run.trim && runs_[partner_[r]].trim) panel.open += times;
  if (free && run.round) free_round_ += times;
  if (free != is_free(run.next) && next.smooth) torn_ += times;
  if (in_middle(r) && !(in_middle(run.next) && next.goes_on)) panel.lines += times;
}

void SewnOutlines::count_both(Index r, int times) {
  count(r, times);
  if (runs_[r].before != r) count(runs_[r].before, times);
}

void SewnOutlines::sew(Index r, Index partner) {
  count_both(r, -1);
  partner_[r] = partner;
  count_both(r, 1);
}

double SewnOutlines::free_edges() const {
  int shut = 0, left_out = 0;
  for (const Panel& panel : panels_) {
    shut += panel.open == 0;
    left_out += panel.sewn == 0 && !panel.may_be_left_out;
  }
  return kGarmentWeights.free_round * free_round_ + kGarmentWeights.torn_line * torn_ +
         kGarmentWeights.left_out * left_out + kGarmentWeights.shut * shut;
}

double SewnOutlines::second_lines() const {
  int second = 0;
  for (const Panel& panel : panels_) second += std::max(0, panel.lines - panel.lines_allowed);
  return kGarmentWeights.second_line * second;
}

}  // namespace toile::seams
