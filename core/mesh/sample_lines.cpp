#include "core/mesh/sample_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/base/units.h"
#include "core/mesh/triangulate.h"

namespace toile::mesh {
namespace {

constexpr double kEndsWithin = 0.25;  ///< particle distances from the outline within which a line ends on it
constexpr double kExact = 1e-6;       ///< m; a point this near needs no move

using Key = std::array<Index, 3>;  // panel, edge, sample

Key key_of(const EdgeSample& s) { return {s.panel, s.edge, s.sample}; }

/// A place on a panel's outline: on the segment after a sample of an edge.
struct OutlinePlace {
  Index edge = kNone, sample = kNone;
  double t = 0;  ///< along the segment
  Vec2 point;
  double distance = 0;
};

class LineEnds {
 public:
  explicit LineEnds(const SampledPattern& sampled) {
    for (const SampledSeam& seam : sampled.seams) {
      for (const SampledSeam::Pair& pair : seam.pairs) {
        partner_.emplace(key_of(pair.a), pair.b);
        partner_.emplace(key_of(pair.b), pair.a);
      }
    }
  }

  /// Where a line's end at p comes to lie, when the outline is within `reach` (m).
  Vec2 settle(SampledPattern& sampled, Index panel, Vec2 p, double reach) {
    const std::optional<OutlinePlace> place = nearest(sampled.edges[panel], p, reach);
    if (!place) return p;
    std::vector<Vec2>& edge = sampled.edges[panel][place->edge];
    const auto last = static_cast<Index>(edge.size()) - 1;
    Index k = place->sample + (place->t > 0.5 ? 1 : 0);
    if (length(edge[k] - place->point) <= kExact) return take(panel, place->edge, k, edge[k]);
    const Index other = 2 * place->sample + 1 - k;
    for (const Index candidate : {k, other}) {
      const bool corner = candidate == 0 || candidate == last;
      if (corner || taken_.contains({panel, place->edge, candidate})) continue;
      move(sampled, panel, place->edge, candidate, place->point);
      return take(panel, place->edge, candidate, edge[candidate]);
    }
    return take(panel, place->edge, k, edge[k]);
  }

 private:
  std::optional<OutlinePlace> nearest(const std::vector<std::vector<Vec2>>& edges, Vec2 p,
                                      double reach) const {
    OutlinePlace best;
    best.distance = reach;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (std::size_t k = 0; k + 1 < edges[e].size(); ++k) {
        const Vec2 a = edges[e][k], d = edges[e][k + 1] - a;
        const double t = std::clamp(dot(p - a, d) / std::max(1e-30, dot(d, d)), 0.0, 1.0);
        const double distance = length(p - (a + d * t));
        if (distance >= best.distance) continue;
        best = {static_cast<Index>(e), static_cast<Index>(k), t, a + d * t, distance};
      }
    }
    if (best.edge == kNone) return std::nullopt;
    return best;
  }

  Vec2 take(Index panel, Index edge, Index sample, Vec2 p) {
    taken_.insert({panel, edge, sample});
    return p;
  }

  /// Moves a sample that is no corner towards a neighbour, and its partners by the same share of their way.
  void move(SampledPattern& sampled, Index panel, Index edge, Index k, Vec2 to) {
    std::vector<Vec2>& points = sampled.edges[panel][edge];
    const Vec2 before = points[k - 1], here = points[k], after = points[k + 1];
    const bool onwards = dot(to - here, after - before) > 0;
    const Vec2 goal = onwards ? after : before;
    const double share = length(to - here) / std::max(1e-30, length(goal - here));
    points[k] = to;
    const auto partner = partner_.find({panel, edge, k});
    const auto towards = partner_.find({panel, edge, onwards ? k + 1 : k - 1});
    if (partner == partner_.end() || towards == partner_.end()) return;
    const EdgeSample& a = partner->second;
    const EdgeSample& b = towards->second;
    const auto last = static_cast<Index>(sampled.edges[a.panel][a.edge].size()) - 1;
    const bool corner = a.sample == 0 || a.sample == last;  // shared with the next edge
    if (corner || a.panel != b.panel || a.edge != b.edge || taken_.contains(key_of(a))) return;
    Vec2& moved = sampled.edges[a.panel][a.edge][a.sample];
    moved = moved + (sampled.edges[b.panel][b.edge][b.sample] - moved) * share;
    taken_.insert(key_of(a));
  }

  std::map<Key, EdgeSample> partner_;
  std::set<Key> taken_;  ///< samples that stay where they are
};

std::vector<Vec2> sampled_line(const std::vector<Vec2>& corners, double particle_distance) {
  std::vector<Vec2> points{corners[0]};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Vec2 a = corners[i], b = corners[i + 1];
    const auto n = std::max(1LL, std::llround(length(b - a) / particle_distance));
    for (long long k = 1; k <= n; ++k) {
      points.push_back(k == n ? b : a + (b - a) * (static_cast<double>(k) / static_cast<double>(n)));
    }
  }
  return points;
}

Status check_length(const pattern::Pattern& pattern, double particle_distance) {
  double total = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    const double spacing = pattern::spacing_on(panel, particle_distance);
    for (const pattern::InnerLine& line : panel.lines) {
      if (line.drawn) continue;
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        total += 1 + metres_from_mm(length(line.points[i + 1] - line.points[i])) / spacing;
      }
    }
  }
  if (total <= kMaxParticles) return {};
  return Error{"mesh.too_many_particles",
               "The lines on the pieces alone would have over half a million particles; choose a larger "
               "particle distance.",
               ""};
}

}  // namespace

Result<std::vector<std::vector<std::vector<Vec2>>>> sample_lines(const pattern::Pattern& pattern,
                                                                 double particle_distance,
                                                                 SampledPattern& sampled) {
  std::vector<std::vector<std::vector<Vec2>>> lines(pattern.panels.size());
  if (std::all_of(pattern.panels.begin(), pattern.panels.end(),
                  [](const pattern::Panel& p) { return p.lines.empty(); })) {
    return lines;
  }
  TRY(check_length(pattern, particle_distance));
  LineEnds ends(sampled);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const double spacing = pattern::spacing_on(pattern.panels[p], particle_distance);
    for (const pattern::InnerLine& line : pattern.panels[p].lines) {
      std::vector<Vec2>& points = lines[p].emplace_back();
      if (line.drawn) continue;
      std::vector<Vec2> corners;
      for (const Vec2 q : line.points) corners.push_back({metres_from_mm(q.x), metres_from_mm(q.y)});
      for (Vec2* end : {&corners.front(), &corners.back()}) {
        *end = ends.settle(sampled, static_cast<Index>(p), *end, kEndsWithin * spacing);
      }
      points = sampled_line(corners, spacing);
    }
  }
  return lines;
}

}  // namespace toile::mesh
