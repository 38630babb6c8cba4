#include "core/pattern/seams/likeness.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace toile::seams {
namespace {

/// Whether run i of a, turned over, is run j of b, with its corners.
bool mirrors(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  if (!equally_long(a.length, b.length) || std::abs(a.angle - m.runs[b.next].angle) > 2 || a.fold != b.fold)
    return false;
  for (std::size_t k = 0; k + 1 < SeamRun::kSamples; ++k) {
    const double seen_back = b.turn[SeamRun::kSamples - 2] - b.turn[SeamRun::kSamples - 2 - k];
    if (std::abs(a.turn[k] - seen_back) > 4) return false;
  }
  return true;
}

/// The run of q that each run of p mirrors to, or nothing when q is not p turned over. Of several ways (a
/// rectangle has two) the one that keeps up what is up.
std::vector<Index> mirror_image(const SeamModel& m, Index p, Index q) {
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return {};
  std::vector<Index> best;
  double least = 0;
  for (std::size_t shift = 0; shift < n; ++shift) {
    std::vector<Index> image(n);
    bool all = true;
    double turned = 0;
    for (std::size_t k = 0; k < n && all; ++k) {
      image[k] = b[(shift + n - k) % n];
      all = mirrors(m, a[k], image[k]);
      turned += std::abs(m.runs[a[k]].up - m.runs[image[k]].up);
    }
    if (!all || (!best.empty() && turned >= least)) continue;
    best = std::move(image);
    least = turned;
  }
  return best;
}

void set_mirror(SeamModel& m, Index p, const std::vector<Index>& image) {
  const std::vector<Index> runs = runs_of(m, p);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    SeamRun &a = m.runs[runs[k]], &b = m.runs[image[k]];
    a.mirror_panel = b.panel;
    a.mirror_edge = b.edge;
    b.mirror_panel = a.panel;
    b.mirror_edge = a.edge;
  }
  const Index q = m.runs[image[0]].panel;
  m.twin[p] = q;
  m.twin[q] = p;
}

/// Whether the two may be mirror images by their places in rows: the first is that of the last.
bool places_mirror(const PieceRow& a, const PieceRow& b) {
  return a.row == b.row && (a.row == kNone || a.place + b.place == a.size - 1);
}

bool near(double a, double b) { return std::abs(a - b) <= 0.03 * std::max(a, b); }

/// Pairs up the runs of two pieces of which most of the outline agrees in length, as drawn or one of them
/// turned over.
void find_counterparts(SeamModel& m, Index p, Index q) {
  constexpr double kMost = 0.7;  // of the outline
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return;
  for (std::size_t way = 0; way < 2 * n; ++way) {
    const auto other = [&](std::size_t k) { return b[(way < n ? way + k : way - n + (n - k)) % n]; };
    double agreeing = 0;
    for (std::size_t k = 0; k < n; ++k)
      if (near(m.runs[a[k]].length, m.runs[other(k)].length)) agreeing += m.runs[a[k]].length;
    if (agreeing < kMost * m.girth[p]) continue;
    for (std::size_t k = 0; k < n; ++k) {
      m.counterparts[a[k]].push_back(other(k));
      m.counterparts[other(k)].push_back(a[k]);
    }
  }
}

/// Whether run i of a is run j of b, with its corners.
bool is_same(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  if (!equally_long(a.length, b.length) || std::abs(a.angle - b.angle) > 2 || a.fold != b.fold) return false;
  for (std::size_t k = 0; k + 1 < SeamRun::kSamples; ++k)
    if (std::abs(a.turn[k] - b.turn[k]) > 4) return false;
  return true;
}

/// Edges of one length and turning that the two pieces have.
int edges_in_common(const SeamModel& m, Index p, Index q) {
  constexpr double kLeast = 30, kTurn = 4;  // mm, degrees
  int common = 0;
  for (const Index i : runs_of(m, p)) {
    const SeamRun& a = m.runs[i];
    if (a.length < kLeast) continue;
    for (const Index j : runs_of(m, q)) {
      const SeamRun& b = m.runs[j];
      if (!equally_long(a.length, b.length) || std::abs(a.turn.back() - b.turn.back()) > kTurn) continue;
      ++common;
      break;
    }
  }
  return common;
}

/// Pairs up the runs of two pieces of one form, or of one that is the same when it is turned.
void find_same(SeamModel& m, Index p, Index q) {
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return;
  for (std::size_t shift = p == q ? 1 : 0; shift < n; ++shift) {
    bool all = true;
    for (std::size_t k = 0; k < n && all; ++k) all = is_same(m, a[k], b[(k + shift) % n]);
    if (!all) continue;
    for (std::size_t k = 0; k < n; ++k) {
      m.same[a[k]].push_back(b[(k + shift) % n]);
      if (p != q) m.same[b[(k + shift) % n]].push_back(a[k]);
    }
  }
}

}  // namespace

std::vector<Index> runs_of(const SeamModel& m, Index panel) {
  std::vector<Index> runs;
  for (Index i = 0; i < static_cast<Index>(m.runs.size()); ++i)
    if (m.runs[i].panel == panel) runs.push_back(i);
  return runs;
}

bool equally_long(double a, double b) { return std::abs(a - b) <= 0.5 + 0.005 * std::max(a, b); }

bool same_edges(const SeamModel& m, Index p, Index q) {
  std::vector<double> lengths[2];
  for (const Index r : runs_of(m, p)) lengths[0].push_back(m.runs[r].length);
  for (const Index r : runs_of(m, q)) lengths[1].push_back(m.runs[r].length);
  for (std::vector<double>& l : lengths) std::sort(l.begin(), l.end());
  return std::equal(lengths[0].begin(), lengths[0].end(), lengths[1].begin(), lengths[1].end(), equally_long);
}

namespace {

/// Whether the panel is its own mirror image across the grain, or along it where it is longer so; `up` is the
/// way of the grain.
bool mirrors_along(const SeamModel& m, Index panel, Vec2 up) {
  constexpr double kNear = 0.03;  // of its length
  const Vec2 right{up.y, -up.x};
  std::vector<Vec2> points;  // across the grain, along it
  Vec2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (const Index r : runs_of(m, panel)) {
    for (const Vec2& at : m.runs[r].at) {
      const Vec2 p{dot(at, right), dot(at, up)};
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      points.push_back(p);
    }
  }
  const Vec2 size = high - low;
  const double most = kNear * std::max(size.x, size.y);
  const auto turned_over = [&](bool across) {
    return std::all_of(points.begin(), points.end(), [&](Vec2 p) {
      const Vec2 image = across ? Vec2{low.x + high.x - p.x, p.y} : Vec2{p.x, low.y + high.y - p.y};
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k], b = points[(k + 1) % points.size()], along = b - a;
        const double share = dot(along, along) > 0 ? dot(image - a, along) / dot(along, along) : 0;
        if (length(image - a - std::clamp(share, 0.0, 1.0) * along) < most) return true;
      }
      return false;
    });
  };
  const PieceKind kind = m.words[panel].kind;
  if (size.x > size.y || kind == PieceKind::kTorso) return turned_over(true);
  return turned_over(false) || (kind == PieceKind::kCollar && turned_over(true));  // sailors' are deep
}

}  // namespace

bool mirrors_itself(const SeamModel& m, Index panel) {
  constexpr double kSlant = 0.99;  // cosine: grain lines are drawn by hand
  const Vec2 up = m.up[panel];
  const Vec2 drawn =
      std::abs(up.x) > std::abs(up.y) ? Vec2{up.x > 0 ? 1.0 : -1.0, 0} : Vec2{0, up.y > 0 ? 1.0 : -1.0};
  return mirrors_along(m, panel, up) || (dot(up, drawn) > kSlant && mirrors_along(m, panel, drawn));
}

void tell_front_and_back(SeamModel& m) {
  std::vector<Index> skirt;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p)
    if (m.words[p].kind == PieceKind::kSkirt && !m.words[p].layer) skirt.push_back(p);
  const bool two = skirt.size() == 2 && std::all_of(skirt.begin(), skirt.end(), [&](Index p) {
                     return m.words[p].face == 0 && m.words[p].side == 0 && !mirror_image(m, p, p).empty();
                   });
  if (!two || mirror_image(m, skirt[0], skirt[1]).empty()) return;
  for (std::size_t k = 0; k < 2; ++k) {
    m.words[skirt[k]].guess(PieceKind::kSkirt);
    m.words[skirt[k]].face = k == 0 ? 1 : -1;
  }
}

void find_twins(SeamModel& m) {
  const Index count = static_cast<Index>(m.words.size());
  m.twin.assign(m.words.size(), kNone);
  std::vector<bool> taken(static_cast<std::size_t>(count), false);
  for (const bool named : {true, false}) {
    for (Index p = 0; p < count; ++p) {
      for (Index q = p + 1; q < count && !taken[p]; ++q) {
        const int sides = m.words[p].side * m.words[q].side;
        const bool faces = m.words[p].face * m.words[q].face < 0;
        const bool layers = m.words[p].layer != m.words[q].layer;  // what lies on it is no other side's
        if (taken[q] || faces || layers || (named ? sides >= 0 : sides > 0) ||
            !places_mirror(m.rows[p], m.rows[q]))
          continue;
        const std::vector<Index> image = mirror_image(m, p, q);
        if (image.empty()) continue;
        set_mirror(m, p, image);
        taken[p] = taken[q] = true;
      }
    }
  }
  for (Index p = 0; p < count; ++p) {
    if (taken[p]) continue;
    const std::vector<Index> image = mirror_image(m, p, p);
    if (!image.empty()) set_mirror(m, p, image);
  }
}

void match_mirrors(SeamModel& m) {
  constexpr double kSame = 0.01;  // of the edge
  const auto count = static_cast<Index>(m.runs.size());
  m.mirror.assign(m.runs.size(), kNone);
  for (Index i = 0; i < count; ++i) {
    const SeamRun& a = m.runs[i];
    for (Index j = i; j < count && a.mirror_panel != kNone && m.mirror[i] == kNone; ++j) {
      const SeamRun& b = m.runs[j];
      if (b.panel != a.mirror_panel || b.edge != a.mirror_edge) continue;
      if (std::abs(a.from - (1 - b.to)) > kSame || std::abs(a.to - (1 - b.from)) > kSame) continue;
      m.mirror[i] = j;
      m.mirror[j] = i;
    }
  }
}

void find_rivals(SeamModel& m) {
  constexpr int kSeveral = 3;
  m.rival.assign(m.words.size(), 0);
  const auto count = static_cast<Index>(m.words.size());
  for (Index p = 0; p < count; ++p) {
    for (Index q = p + 1; q < count; ++q) {
      const PieceWords &a = m.words[p], &b = m.words[q];
      const bool named = a.face != 0 || a.side != 0;
      const bool one_role =
          (a.kind == b.kind || a.kind == PieceKind::kOther || b.kind == PieceKind::kOther) &&
          a.side == b.side && a.face == b.face && m.level[p] == m.level[q];
      const bool in_row = m.rows[p].row != kNone && m.rows[p].row == m.rows[q].row;
      if (!named || !one_role || in_row || m.twin[p] == q || edges_in_common(m, p, q) < kSeveral) continue;
      m.rival[p] = m.rival[q] = 1;
    }
  }
}

void find_alike(SeamModel& m) {
  m.counterparts.resize(m.runs.size());
  m.same.resize(m.runs.size());
  const auto count = static_cast<Index>(m.words.size());
  for (Index p = 0; p < count; ++p) {
    find_same(m, p, p);
    for (Index q = p + 1; q < count; ++q) {
      if (m.twin[p] != q) find_counterparts(m, p, q);
      find_same(m, p, q);
    }
  }
}

}  // namespace toile::seams
