#include "core/pattern/seams/gluing.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/armholes.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

double inner_merit(double angle) {
  constexpr double flat = kGarmentWeights.inner_flat_deg, fair = kGarmentWeights.inner_fair_deg;
  const double off = std::abs(angle - 360);
  if (off <= flat) return kGarmentWeights.inner;
  if (off <= fair) return kGarmentWeights.inner * (fair - off) / (fair - flat);
  return (off - fair) / 100 * (angle < 360 ? kGarmentWeights.inner_cone : kGarmentWeights.inner_ruffle);
}

double border_merit(double angle) {
  constexpr double straight = kGarmentWeights.border_straight_deg, fair = kGarmentWeights.border_fair_deg;
  const double off = std::abs(angle - 180);
  if (off <= straight) return kGarmentWeights.border;
  if (off <= fair) return kGarmentWeights.border * (fair - off) / (fair - straight);
  return std::max(angle > 180 ? kGarmentWeights.border_slit : kGarmentWeights.border_corner,
                  (off - fair) / 100 * kGarmentWeights.border_bent);
}

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

/// How long the hem of the bodice's pieces is, mm, told by their widths across the grain; 0 where there is no
/// front or no back, or no telling which way a piece lies.
double torso_girth(const SeamModel& m) {
  double girth = 0;
  bool front = false, back = false;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p) {
    if (m.words[p].kind != PieceKind::kTorso) continue;
    if (!m.upright[p]) return 0;
    double low = 1e30, high = -1e30;
    for (const SeamRun& run : m.runs) {
      if (run.panel != p) continue;
      for (const Vec2& at : run.at) {
        low = std::min(low, cross(m.up[p], at));
        high = std::max(high, cross(m.up[p], at));
      }
    }
    girth += high - low;
    front = front || m.words[p].face > 0;
    back = back || m.words[p].face < 0;
  }
  return front && back ? girth : 0;
}

/// What a border of the bodice alone measures at least, mm.
double least_border(const SeamModel& m) {
  const bool wrists = std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
    return m.words[run.panel].kind == PieceKind::kTorso && run.up < -kPairWeights.facing &&
           is_below_arm(m, run);
  });
  return std::min(kGarmentWeights.narrow_share * torso_girth(m),
                  wrists ? kGarmentWeights.wrist_mm : kGarmentWeights.narrow_most_mm);
}

}  // namespace

GluingJudge::GluingJudge(const SeamModel& model, const GluingSettings& settings)
    : m_(model), settings_(settings), least_border_(least_border(model)) {
  const auto level_of = [&](const SeamRun& run) {
    if (!model.nameless || !model.upright[run.panel]) return 0;
    return run.up > kPairWeights.facing_fully ? 1 : run.up < -kPairWeights.facing_fully ? -1 : 0;
  };
  for (std::size_t i = 0; i < model.runs.size(); ++i) {
    const SeamRun& run = model.runs[i];
    runs_.push_back({run.next, run.panel, model.mirror[i], kNone, run.from > 0 || run.to<1, run.from> 0,
                     run.turn.back() > kGarmentWeights.round_deg && !run.open_front && !is_hem(model, run),
                     std::abs(run.angle - 180) < kGarmentWeights.smooth_deg, run.angle, run.length,
                     run.to - run.from, model.words[run.panel].kind == PieceKind::kTorso,
                     is_trim(model.words[run.panel].kind), half_of(model, static_cast<Index>(i)),
                     model.words[run.panel].face, level_of(run)});
  }
  for (Index i = 0; i < static_cast<Index>(runs_.size()); ++i)
    if (model.runs[runs_[i].next].from_notch) runs_[runs_[i].next].before = i;
  root_.resize(runs_.size());
  for (Index p = 0; p < static_cast<Index>(model.words.size()); ++p)
    is_whole_.push_back(model.nameless && model.words[p].kind == PieceKind::kSkirt &&
                        mirrors_itself(model, p));
}

void GluingJudge::join_corners(const SeamGluing& g) {
  corners_.reset(runs_.size());
  const auto count = static_cast<Index>(runs_.size());
  for (Index a = 0; a < count; ++a) {
    const Index b = g.partner[a];
    if (b <= a) continue;
    const bool with = along(g, a, b);
    corners_.join(a, with ? b : runs_[b].next);
    corners_.join(runs_[a].next, with ? runs_[b].next : b);
  }
  for (Index i = 0; i < count; ++i) root_[i] = corners_.root(i);
}

/// Whether the run is sewn, and so is a part of its edge on the other side of a notch.
bool GluingJudge::is_parted(const SeamGluing& g, Index r) const {
  const Index before = runs_[r].before, after = runs_[r].next;
  return (before != kNone && g.partner[before] != kNone) ||
         (runs_[after].before == r && g.partner[after] != kNone);
}

/// Each by itself, and the same on mirrored pieces.
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
    const PieceRow& here = m_.rows[runs_[r].panel];
    if (here.size < 3 || g.partner[r] == kNone) return kNone;
    const Index other = runs_[g.partner[r]].panel;
    return m_.rows[other].row == here.row ? other : kNone;
  };
  int second = 0;
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) {
    const Index other = mate(r);
    if (other <= runs_[r].panel) continue;
    for (Index next = runs_[r].next; next != r; next = runs_[next].next) second += mate(next) == other;
  }
  return second / 2;
}

/// A piece of a sleeve is of the left one or of the right one: it is not sewn to a piece and to its mirror
/// image.
double GluingJudge::limbs(const SeamGluing& g) {
  const auto is_sleeve = [&](Index p) { return m_.words[p].kind == PieceKind::kSleeve; };
  mate_.assign(m_.words.size(), kNone);
  int both = 0;
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) {
    if (g.partner[r] == kNone) continue;
    const Index p = runs_[r].panel, q = runs_[g.partner[r]].panel, twin = m_.twin[q];
    if (p == q || p == twin || twin == kNone || twin == q || !is_sleeve(p) || !is_sleeve(q)) continue;
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
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) {
    if (g.partner[r] == kNone || m_.words[runs_[r].panel].kind != PieceKind::kStrap) continue;
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

/// Two pieces that mirror each other meet along one line, the middle of the body, seldom along two.
double GluingJudge::middles(const SeamGluing& g) {
  lines_.assign(m_.words.size(), 0);
  // A line ends where it bends: there a vent begins, or the next piece. Hoods are shaped by their corners,
  // and the seat of a leg cut in one piece is drawn with one.
  const auto goes_on = [&](Index r) {
    const PieceKind kind = m_.words[runs_[r].panel].kind;
    const bool seat = kind == PieceKind::kLegs && m_.words[runs_[r].panel].face == 0;
    return runs_[r].smooth || kind == PieceKind::kHood || seat;
  };
  const auto in_middle = [&](Index r) { return g.partner[r] != kNone && g.partner[r] == runs_[r].mirror; };
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r)
    lines_[runs_[r].panel] += in_middle(r) && !(in_middle(runs_[r].next) && goes_on(runs_[r].next));
  double merit = kGarmentWeights.second_line * static_cast<double>(second_lines_in_rows(g));
  for (std::size_t p = 0; p < lines_.size(); ++p) {
    // A leg that is cut in one piece has the middle of the front and that of the back; two panels of a
    // skirt that are their own mirror images are a front and a back, with two sides.
    const bool both = (m_.words[p].kind == PieceKind::kLegs && m_.words[p].face == 0) || is_whole_[p];
    if (m_.twin[p] > static_cast<Index>(p))
      merit += kGarmentWeights.second_line * std::max(0, lines_[p] - (both ? 2 : 1));
  }
  return merit;
}

/// What hangs from a piece by its upper end, that piece does not hang from; nor do their mirror images.
double GluingJudge::levels(const SeamGluing& g) {
  if (!m_.nameless) return 0;
  const auto pair_of = [&](Index r) {
    const Index p = runs_[r].panel, twin = m_.twin[p];
    return twin == kNone ? p : std::min(p, twin);
  };
  hangs_.clear();
  double merit = 0;
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) {
    const Index other = g.partner[r];
    if (other == kNone || runs_[r].level != 1 || runs_[other].level != -1) continue;
    const Index lower = pair_of(r), upper = pair_of(other);
    for (const std::array<Index, 2>& hangs : hangs_)
      if (hangs[0] == upper && hangs[1] == lower) merit += kGarmentWeights.hangs_both_ways;
    hangs_.push_back({lower, upper});
  }
  return merit;
}

/// Nearly every piece has an edge that is sewn to nothing: a hem, a neck, or to a band, cuff or collar that
/// ends it there. But a piece of a bodice is sewn.
double GluingJudge::free_edges(const SeamGluing& g) {
  open_.assign(m_.words.size(), 0);
  sewn_.assign(m_.words.size(), 0);
  double merit = 0;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const Run& run = runs_[r];
    const bool free = g.partner[r] == kNone, next_free = g.partner[run.next] == kNone;
    (free ? open_ : sewn_)[run.panel] = 1;
    if (!free && !run.trim && runs_[g.partner[r]].trim) open_[run.panel] = 1;
    if (free && run.round) merit += kGarmentWeights.free_round;
    if (free != next_free && runs_[run.next].smooth) merit += kGarmentWeights.torn_line;
  }
  for (std::size_t p = 0; p < sewn_.size(); ++p)
    if (!sewn_[p] && m_.words[p].kind == PieceKind::kTorso && !m_.words[p].layer)
      merit += kGarmentWeights.left_out;
  return merit + kGarmentWeights.shut * static_cast<double>(std::count(open_.begin(), open_.end(), 0));
}

/// How the cloth lies around the points where pieces meet.
double GluingJudge::points(const SeamGluing& g) {
  sums_.assign(runs_.size(), {});
  for (Index i = 0; i < static_cast<Index>(runs_.size()); ++i) {
    PointSums& s = sums_[root_[i]];
    s.angle += runs_[i].angle;
    ++s.corners;
    s.cut = s.cut || runs_[i].cut_start;
    const PieceWords& words = m_.words[runs_[i].panel];
    s.crotch = s.crotch || words.kind == PieceKind::kLegs;
    const bool trunk = words.kind == PieceKind::kTorso && words.face != 0;
    (trunk ? words.face > 0 ? s.front : s.back : s.other) = true;
    if (g.partner[i] != kNone) continue;
    ++s.free_ends;
    ++sums_[root_[runs_[i].next]].free_ends;
  }
  double merit = 0;
  points_ = 0;
  for (const PointSums& s : sums_) {
    if (s.corners == 0) continue;
    ++points_;
    const double here = s.free_ends == 0 ? inner_merit(s.angle) : s.corners > 1 ? border_merit(s.angle) : 0;
    if (s.crotch && s.free_ends == 0 && s.angle < 360) continue;  // legs end sharply where they meet
    if (s.free_ends == 0 && s.front && s.back && !s.other && s.angle < kGarmentWeights.arm_shut_deg)
      merit += kGarmentWeights.arm_shut;
    merit += s.cut ? std::min(0.0, here) : here;  // a cut is no corner of the drawing: it proves nothing
  }
  return merit;
}

/// Handles, openings and separate parts, from Euler's formula.
double GluingJudge::surface(const SeamGluing& g) {
  const int panels = static_cast<int>(m_.words.size());
  parts_.reset(m_.words.size());
  borders_.reset(runs_.size());
  int edges = 0, components = panels, border_count = 0;
  free_at_.assign(runs_.size(), kNone);
  for (Index i = 0; i < static_cast<Index>(runs_.size()); ++i) {
    if (g.partner[i] != kNone) {
      edges += i < g.partner[i];
      if (parts_.join(runs_[i].panel, runs_[g.partner[i]].panel)) --components;
      continue;
    }
    ++edges;
    ++border_count;
    for (const Index end : {i, runs_[i].next}) {
      Index& there = free_at_[root_[end]];
      if (there == kNone)
        there = i;
      else if (borders_.join(there, i))
        --border_count;
    }
  }
  const int twice_handles = 2 * components - (points_ - edges + panels) - border_count;
  return kGarmentWeights.handle * twice_handles / 2 + kGarmentWeights.part * (components - 1) +
         kGarmentWeights.opening * std::min(kGarmentWeights.openings, border_count - components);
}

/// A head and arms must pass through the bodice's openings. REQUIRES surface()'s borders.
double GluingJudge::narrow_borders(const SeamGluing& g) {
  if (least_border_ == 0) return 0;
  border_length_.assign(runs_.size(), 0);
  for (Index i = 0; i < static_cast<Index>(runs_.size()); ++i) {
    if (g.partner[i] != kNone) continue;
    constexpr double kWide = 1e9;
    border_length_[borders_.root(i)] += runs_[i].torso ? runs_[i].length : kWide;
  }
  const auto narrow = std::count_if(border_length_.begin(), border_length_.end(),
                                    [&](double length) { return length > 0 && length < least_border_; });
  return kGarmentWeights.narrow * static_cast<double>(narrow);
}

double GluingJudge::gathers(const SeamGluing& g) {
  gathers_.clear();
  for (Index a = 0; a < static_cast<Index>(runs_.size()); ++a) {
    const Index b = g.partner[a];
    if (b == kNone || runs_[a].length < kGarmentWeights.gathered * runs_[b].length) continue;
    if (runs_[a].cut || runs_[b].cut) continue;  // cuts are in proportion anyway
    gathers_.push_back({runs_[a].length / runs_[b].length, {root_[a], root_[runs_[a].next]}, a});
  }
  double merit = 0;
  for (std::size_t i = 0; i < gathers_.size(); ++i) {
    for (std::size_t j = i + 1; j < gathers_.size(); ++j) {
      const Gather &x = gathers_[i], &y = gathers_[j];
      const bool meet = x.ends[0] == y.ends[0] || x.ends[0] == y.ends[1] || x.ends[1] == y.ends[0] ||
                        x.ends[1] == y.ends[1];
      const bool mirrored = runs_[x.run].mirror == y.run;  // alike without any reason to be sewn
      if (meet && !mirrored && std::abs(x.ratio - y.ratio) < kGarmentWeights.like_gather * x.ratio)
        merit += kGarmentWeights.same_gather;
    }
  }
  return std::min(merit, kGarmentWeights.gathers * kGarmentWeights.same_gather);
}

double GluingJudge::merit(const SeamGluing& g) {
  join_corners(g);
  const double around = points(g);  // counts the points for surface()
  const double whole = pairs(g) + sides(g) + limbs(g) + straps(g) + middles(g) + levels(g) + free_edges(g) +
                       around + surface(g);
  return whole + narrow_borders(g) + gathers(g);
}

SeamGluing nothing_sewn(const SeamModel& model) {
  return {std::vector<Index>(model.runs.size(), kNone), std::vector<std::array<double, 2>>(model.runs.size()),
          std::vector<char>(model.words.size(), 0)};
}

double gluing_merit(const SeamModel& m, const SeamGluing& g, const GluingSettings& settings) {
  return GluingJudge(m, settings).merit(g);
}

}  // namespace toile::seams
