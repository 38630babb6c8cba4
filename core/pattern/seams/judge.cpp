#include "core/pattern/seams/judge.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {

GluingJudge::GluingJudge(const SeamModel& model, const GluingSettings& settings)
    : m_(model),
      settings_(settings),
      points_(model),
      borders_(model),
      panels_(model.words.size()),
      outlines_(model),
      turned_(model.words.size(), 0),
      sides_(sides(nothing_sewn(model))),
      along_(model.runs.size(), 0),
      free_(static_cast<int>(model.runs.size())) {
  const auto level_of = [&](const SeamRun& run) {
    if (!model.nameless || !model.upright[run.panel]) return 0;
    return run.up > kPairWeights.facing_fully ? 1 : run.up < -kPairWeights.facing_fully ? -1 : 0;
  };
  for (Index i = 0; i < static_cast<Index>(model.runs.size()); ++i) {
    const SeamRun& run = model.runs[i];
    const PieceWords& words = model.words[run.panel];
    runs_.push_back({run.next, run.panel, model.mirror[i], kNone, run.from > 0 || run.to < 1, run.length,
                     run.to - run.from, half_of(model, i), words.face, level_of(run)});
    if (words.kind == PieceKind::kSleeve) of_sleeves_.push_back(i);
    if (words.kind == PieceKind::kStrap) of_straps_.push_back(i);
    if (model.rows[run.panel].size > 2) in_rows_.push_back(i);
    if (runs_.back().level == 1) upper_.push_back(i);
  }
  for (Index i = 0; i < static_cast<Index>(runs_.size()); ++i)
    if (model.runs[runs_[i].next].from_notch) runs_[runs_[i].next].before = i;
}

/// Run r is among what is longer than its partner, or no longer.
void GluingJudge::find_gathered(Index r, Index partner) {
  const bool is = partner != kNone && !(runs_[r].length < kGarmentWeights.gathered * runs_[partner].length) &&
                  !runs_[r].cut && !runs_[partner].cut;  // cuts are in proportion anyway
  const auto at = std::lower_bound(gathered_.begin(), gathered_.end(), r);
  const bool was = at != gathered_.end() && *at == r;
  if (is && !was) gathered_.insert(at, r);
  if (was && !is) gathered_.erase(at);
}

void GluingJudge::take_run(const SeamGluing& g, Index r) {
  const Index before = outlines_.partner(r), partner = g.partner[r];
  along_[r] = partner != kNone && along(g, r, partner);
  points_.sew(r, partner, along_[r] != 0);
  if (partner == before) return;
  if (before != kNone) panels_.remove(runs_[r].panel, runs_[before].panel);
  if (partner != kNone) panels_.add(runs_[r].panel, runs_[partner].panel);
  if (partner != kNone) borders_.leave(r);
  free_ += (partner == kNone) - (before == kNone);
  pairs_ += (partner > r) - (before > r);
  outlines_.sew(r, partner);
  find_gathered(r, partner);
}

/// Takes over what of the garment is sewn in another way than in the one before.
void GluingJudge::take(const SeamGluing& g) {
  const auto count = static_cast<Index>(runs_.size());
  if (g.turned == turned_) {
    for (Index r = 0; r < count; ++r)
      if (g.partner[r] != outlines_.partner(r)) take_run(g, r);
  } else {
    turned_ = g.turned;
    sides_ = sides(g);
    for (Index r = 0; r < count; ++r) {
      const Index partner = g.partner[r];
      if (partner != outlines_.partner(r) || (partner != kNone && along(g, r, partner) != (along_[r] != 0)))
        take_run(g, r);
    }
  }
  points_.renew();
  borders_.renew(points_);
}

/// Whether the run is sewn, and so is a part of its edge on the other side of a notch.
bool GluingJudge::is_parted(const SeamGluing& g, Index r) const {
  const Index before = runs_[r].before, after = runs_[r].next;
  return (before != kNone && g.partner[before] != kNone) ||
         (runs_[after].before == r && g.partner[after] != kNone);
}

double GluingJudge::pairs(const SeamGluing& g) const {
  double merit = 0;
  for (Index a = 0; a < static_cast<Index>(runs_.size()); ++a) {
    const Index b = g.partner[a];
    if (b <= a) continue;
    merit += g.merit[a][along(g, a, b)];
    if (is_parted(g, a) && is_parted(g, b)) merit += kGarmentWeights.parted;
    const Index ma = runs_[a].mirror, mb = runs_[b].mirror;
    if (ma != kNone && mb != kNone && ma != b && g.partner[ma] == mb)
      merit += kGarmentWeights.mirrored * std::min(runs_[a].share, runs_[b].share);
  }
  return merit;
}

/// Pieces are mostly drawn from their right side, and mirrored ones from the same side.
double GluingJudge::sides(const SeamGluing& g) const {
  double turned = 0, count = 0;  // collars are folded over: they hardly count
  for (std::size_t p = 0; p < g.turned.size(); ++p) {
    const bool hinted = !settings_.turned.empty() && settings_.turned[p] != 0;
    const double weight = m_.words[p].kind == PieceKind::kCollar ? kGarmentWeights.turned_collar : 1;
    turned += (g.turned[p] != 0) != hinted ? weight : 0;
    count += weight;
  }
  double merit = settings_.sides_known ? kGarmentWeights.turned_known * turned
                                       : kGarmentWeights.turned * std::min(turned, count - turned);
  double faces[2][2] = {};  // pieces named front and back, as drawn and turned
  for (std::size_t p = 0; p < m_.twin.size(); ++p) {
    const Index q = m_.twin[p];
    if (m_.words[p].face != 0) ++faces[m_.words[p].face > 0][g.turned[p] != 0];
    if (q > static_cast<Index>(p) && g.turned[p] != g.turned[q]) merit += kGarmentWeights.twin_turned;
  }
  for (const auto& face : faces) merit += kGarmentWeights.face_turned * std::min(face[0], face[1]);
  return merit;
}

/// Gores meet along one line, unless there are but two.
int GluingJudge::second_lines_in_rows(const SeamGluing& g) const {
  const auto mate = [&](Index r) {
    if (g.partner[r] == kNone) return kNone;
    const Index other = runs_[g.partner[r]].panel;
    return m_.rows[other].row == m_.rows[runs_[r].panel].row ? other : kNone;
  };
  int second = 0;
  for (const Index r : in_rows_) {
    const Index other = mate(r);
    if (other <= runs_[r].panel) continue;
    for (Index next = runs_[r].next; next != r; next = runs_[next].next) second += mate(next) == other;
  }
  return second / 2;
}

/// A piece of a sleeve is of the left one or of the right one: it is not sewn to a piece and to its mirror
/// image.
double GluingJudge::limbs(const SeamGluing& g) {
  mate_.assign(m_.words.size(), kNone);
  int both = 0;
  for (const Index r : of_sleeves_) {
    if (g.partner[r] == kNone) continue;
    const Index p = runs_[r].panel, q = runs_[g.partner[r]].panel, twin = m_.twin[q];
    if (p == q || p == twin || twin == kNone || twin == q || m_.words[q].kind != PieceKind::kSleeve) continue;
    both += mate_[p] == twin;
    if (mate_[p] == kNone) mate_[p] = q;
  }
  return kGarmentWeights.both_limbs * both;
}

/// A strap goes over one shoulder, from the front to the back: seen from their right sides, from the one half
/// of the front to the other of the back.
double GluingJudge::straps(const SeamGluing& g) {
  held_.assign(m_.words.size(), kNone);
  double merit = 0;
  for (const Index r : of_straps_) {
    if (g.partner[r] == kNone) continue;
    Index& first = held_[runs_[r].panel];
    if (first == kNone) {
      first = g.partner[r];
      continue;
    }
    const Run &a = runs_[first], &b = runs_[g.partner[r]];
    if (a.face * b.face > 0) merit += kGarmentWeights.strap_across;
    if (a.face * b.face < 0 && a.half * b.half > 0) merit += kGarmentWeights.strap_crosses;
  }
  return merit;
}

/// What hangs from a piece by its upper end, that piece does not hang from; nor do their mirror images.
double GluingJudge::levels(const SeamGluing& g) {
  const auto pair_of = [&](Index r) {
    const Index p = runs_[r].panel, twin = m_.twin[p];
    return twin == kNone ? p : std::min(p, twin);
  };
  hangs_.clear();
  double merit = 0;
  for (const Index r : upper_) {
    const Index other = g.partner[r];
    if (other == kNone || runs_[other].level != -1) continue;
    const Index lower = pair_of(r), upper = pair_of(other);
    for (const std::array<Index, 2>& hangs : hangs_)
      if (hangs[0] == upper && hangs[1] == lower) merit += kGarmentWeights.hangs_both_ways;
    hangs_.push_back({lower, upper});
  }
  return merit;
}

/// Handles, openings and separate parts, from Euler's formula.
double GluingJudge::surface() {
  const int panels = static_cast<int>(m_.words.size()), parts = panels_.parts();
  const int edges = free_ + pairs_;
  const int twice_handles = 2 * parts - (points_.count() - edges + panels) - borders_.count();
  return kGarmentWeights.handle * twice_handles / 2 + kGarmentWeights.part * (parts - 1) +
         kGarmentWeights.opening * std::min(kGarmentWeights.openings, borders_.count() - parts);
}

/// Neighbours that are gathered alike are so by design, unless they mirror each other, which are alike
/// without any reason to be sewn.
double GluingJudge::gathers() const {
  const auto ratio = [&](Index r) { return runs_[r].length / runs_[outlines_.partner(r)].length; };
  const auto meet = [&](Index x, Index y) {
    const Index a = points_.at(x), b = points_.at(runs_[x].next);
    const Index c = points_.at(y), d = points_.at(runs_[y].next);
    return a == c || a == d || b == c || b == d;
  };
  double merit = 0;
  for (std::size_t i = 0; i < gathered_.size(); ++i) {
    const Index x = gathered_[i];
    for (std::size_t j = i + 1; j < gathered_.size(); ++j) {
      const Index y = gathered_[j];
      if (meet(x, y) && runs_[x].mirror != y &&
          std::abs(ratio(x) - ratio(y)) < kGarmentWeights.like_gather * ratio(x))
        merit += kGarmentWeights.same_gather;
    }
  }
  return std::min(merit, kGarmentWeights.gathers * kGarmentWeights.same_gather);
}

double GluingJudge::merit(const SeamGluing& g, double pairs) {
  take(g);
  const double middles = outlines_.second_lines() + kGarmentWeights.second_line * second_lines_in_rows(g);
  return pairs + sides_ + limbs(g) + straps(g) + middles + levels(g) + outlines_.free_edges() +
         points_.merit() + surface() + kGarmentWeights.narrow * borders_.narrow() + gathers();
}

double gluing_merit(const SeamModel& m, const SeamGluing& g, const GluingSettings& settings) {
  return GluingJudge(m, settings).merit(g);
}

}  // namespace toile::seams
