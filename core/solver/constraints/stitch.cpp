#include "core/solver/constraints/stitch.h"

#include <algorithm>
#include <array>

#include "core/sewing/assembly.h"

namespace toile::solver::constraints {

void shorten_stitches(std::span<const Stitch> stitches, double shrunk, std::span<const double> w, double h,
                      std::span<Vec3> x) {
  for (const Stitch& s : stitches) {
    const double w0 = w[s.v0], w1 = w[s.v1];
    const Vec3 d = x[s.v1] - x[s.v0];
    const double l = length(d), excess = l - shrunk * s.start_length;
    if (excess <= 0 || l <= 0 || w0 + w1 <= 0) continue;
    const double lambda = std::min(excess / (w0 + w1), s.force_limit * h * h);
    const Vec3 pull = d * (lambda / l);
    x[s.v0] += pull * w0;
    x[s.v1] -= pull * w1;
  }
}

std::vector<StitchGroup> stitch_groups(std::span<const Stitch> stitches, Index vertex_count) {
  std::vector<std::array<Index, 2>> joined;
  std::vector<double> limit(vertex_count, 0);
  for (const Stitch& s : stitches) {
    joined.push_back({s.v0, s.v1});
    for (const Index v : joined.back()) limit[v] = std::max(limit[v], s.force_limit);
  }
  const std::vector<Index> least = sewing::least_of_class(vertex_count, joined);
  std::vector<Index> group_of(vertex_count, kNone);
  std::vector<StitchGroup> groups;
  for (Index v = 0; v < vertex_count; ++v) {
    if (limit[v] == 0) continue;
    if (group_of[least[v]] == kNone) {
      group_of[least[v]] = static_cast<Index>(groups.size());
      groups.push_back({{}, limit[v]});
    }
    groups[group_of[least[v]]].vertices.push_back(v);
  }
  return groups;
}

void close_groups(std::span<const StitchGroup> groups, std::span<const double> w, double h,
                  std::span<Vec3> x) {
  for (const StitchGroup& g : groups) {
    Vec3 centre;
    double mass = 0;
    for (const Index v : g.vertices) {
      const double m = 1 / std::max(w[v], 1e-9);  // a held vertex weighs so much that the others come to it
      centre += x[v] * m;
      mass += m;
    }
    centre = centre * (1 / mass);
    // One factor for all: capped one by one, forces would not add up to nothing, and the garment would fly.
    double share = 1;
    for (const Index v : g.vertices) {
      const double l = length(centre - x[v]), most = g.force_limit * h * h * w[v];
      if (w[v] > 0 && l > most) share = std::min(share, most / l);
    }
    for (const Index v : g.vertices) {
      if (w[v] > 0) x[v] += (centre - x[v]) * share;
    }
  }
}

double largest_gap(std::span<const Stitch> stitches, std::span<const Vec3> x) {
  double gap = 0;
  for (const Stitch& s : stitches) gap = std::max(gap, length(x[s.v1] - x[s.v0]));
  return gap;
}

}  // namespace toile::solver::constraints
