#include "core/pattern/seam_gluing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile {
namespace {

/// Sets of small numbers that are one.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool join(Index a, Index b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<Index> parent_;
};

/// Corners by the point that they come to; corner i is the start of run i.
Classes joined_corners(const SeamModel& m, const SeamGluing& g) {
  Classes corners(m.runs.size());
  for (Index a = 0; a < static_cast<Index>(m.runs.size()); ++a) {
    const Index b = g.partner[a];
    if (b <= a) continue;
    const bool along = g.along(m, a, b);
    corners.join(a, along ? b : m.runs[b].next);
    corners.join(m.runs[a].next, along ? m.runs[b].next : b);
  }
  return corners;
}

/// Around a point inside the cloth 360° lie flat, 180° would be a fold's end.
double inner_merit(double angle) {
  constexpr double kFlat = 40, kFair = 100, kFull = 1.5;
  const double off = std::abs(angle - 360);
  if (off <= kFlat) return kFull;
  if (off <= kFair) return kFull * (kFair - off) / (kFair - kFlat);
  return -(off - kFair) / 100 * (angle < 360 ? 8 : 2);
}

/// A border mostly runs on straight across a seam.
double border_merit(double angle) {
  constexpr double kStraight = 25, kFair = 70, kFull = 0.7;
  const double off = std::abs(angle - 180);
  if (off <= kStraight) return kFull;
  if (off <= kFair) return kFull * (kFair - off) / (kFair - kStraight);
  return -(off - kFair) / 100 * 4;
}

constexpr double kHandle = -25;    ///< a ring sewn to a ring of the same cloth
constexpr double kPart = -2.5;     ///< cloth that hangs on nothing
constexpr double kMirrored = 1;    ///< the same seam on the other side
constexpr double kSameGather = 2;  ///< neighbours gathered alike
constexpr double kGathered = 1.05;

struct PointSums {
  double angle = 0;
  int corners = 0;
  int free_ends = 0;
};

double points_merit(const SeamModel& m, const SeamGluing& g, Classes& corners, int& points) {
  std::vector<PointSums> sums(m.runs.size());
  for (Index i = 0; i < static_cast<Index>(m.runs.size()); ++i) {
    PointSums& s = sums[corners.root(i)];
    s.angle += m.runs[i].angle;
    ++s.corners;
    if (g.partner[i] != kNone) continue;
    ++s.free_ends;
    ++sums[corners.root(m.runs[i].next)].free_ends;
  }
  double merit = 0;
  for (const PointSums& s : sums) {
    if (s.corners == 0) continue;
    ++points;
    if (s.free_ends == 0) merit += inner_merit(s.angle);
    if (s.free_ends > 0 && s.corners > 1) merit += border_merit(s.angle);
  }
  return merit;
}

/// Handles and separate parts, from Euler's formula.
double surface_merit(const SeamModel& m, const SeamGluing& g, Classes& corners, int points) {
  const int count = static_cast<int>(m.runs.size()), panels = static_cast<int>(m.words.size());
  Classes parts(m.words.size()), borders(m.runs.size());
  int edges = 0, components = panels;
  std::vector<Index> free_at(m.runs.size(), kNone);
  int border_count = 0;
  for (Index i = 0; i < count; ++i) {
    if (g.partner[i] != kNone) {
      edges += i < g.partner[i];
      if (parts.join(m.runs[i].panel, m.runs[g.partner[i]].panel)) --components;
      continue;
    }
    ++edges, ++border_count;
    for (const Index end : {i, m.runs[i].next}) {
      Index& there = free_at[corners.root(end)];
      if (there == kNone)
        there = i;
      else if (borders.join(there, i))
        --border_count;
    }
  }
  const int twice_handles = 2 * components - (points - edges + panels) - border_count;
  return kHandle * twice_handles / 2 + kPart * (components - 1);
}

double gather_merit(const SeamModel& m, const SeamGluing& g, Classes& corners) {
  struct Gather {
    double ratio;
    Index ends[2];
  };
  std::vector<Gather> gathers;
  for (Index a = 0; a < static_cast<Index>(m.runs.size()); ++a) {
    const Index b = g.partner[a];
    if (b == kNone || m.runs[a].length < kGathered * m.runs[b].length) continue;
    gathers.push_back({m.runs[a].length / m.runs[b].length, {corners.root(a), corners.root(m.runs[a].next)}});
  }
  double merit = 0;
  for (std::size_t i = 0; i < gathers.size(); ++i) {
    for (std::size_t j = i + 1; j < gathers.size(); ++j) {
      const Gather &x = gathers[i], &y = gathers[j];
      const bool meet = x.ends[0] == y.ends[0] || x.ends[0] == y.ends[1] || x.ends[1] == y.ends[0] ||
                        x.ends[1] == y.ends[1];
      if (meet && std::abs(x.ratio - y.ratio) < 0.015 * x.ratio) merit += kSameGather;
    }
  }
  return merit;
}

}  // namespace

SeamGluing nothing_sewn(const SeamModel& model) {
  return {std::vector<Index>(model.runs.size(), kNone), std::vector<std::array<double, 2>>(model.runs.size()),
          std::vector<char>(model.words.size(), 0)};
}

double gluing_merit(const SeamModel& m, const SeamGluing& g, const GluingSettings& settings) {
  const double turned_over = settings.sides_known ? -8 : -0.5;
  double merit = 0;
  for (Index a = 0; a < static_cast<Index>(m.runs.size()); ++a) {
    const Index b = g.partner[a];
    if (b <= a) continue;
    const bool along = g.along(m, a, b);
    merit += g.merit[a][along] + (along ? turned_over : 0);
    const Index ma = m.mirror[a], mb = m.mirror[b];
    if (ma != kNone && mb != kNone && g.partner[ma] == mb) merit += kMirrored;
  }
  Classes corners = joined_corners(m, g);
  int points = 0;
  merit += points_merit(m, g, corners, points);
  return merit + surface_merit(m, g, corners, points) + gather_merit(m, g, corners);
}

std::vector<std::vector<Index>> free_borders(const SeamModel& m, const SeamGluing& g) {
  Classes corners = joined_corners(m, g);
  const auto start = [&](Index i) { return corners.root(g.turned[m.runs[i].panel] ? m.runs[i].next : i); };
  const auto end = [&](Index i) { return corners.root(g.turned[m.runs[i].panel] ? i : m.runs[i].next); };
  const Index count = static_cast<Index>(m.runs.size());
  std::vector<Index> starts_at(m.runs.size(), kNone);
  for (Index i = 0; i < count; ++i)
    if (g.partner[i] == kNone) starts_at[start(i)] = i;
  std::vector<bool> seen(m.runs.size(), false);
  std::vector<std::vector<Index>> borders;
  for (Index i = 0; i < count; ++i) {
    if (g.partner[i] != kNone || seen[i]) continue;
    std::vector<Index> border;
    for (Index at = i; at != kNone && !seen[at]; at = starts_at[end(at)]) {
      seen[at] = true;
      border.push_back(at);
    }
    borders.push_back(std::move(border));
  }
  return borders;
}

}  // namespace toile
