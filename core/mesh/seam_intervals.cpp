#include "core/mesh/seam_intervals.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace toile::mesh {
namespace {

/// Distances along a and along b that belong together.
struct Cut {
  double a, b;
};

/// Pairs of inner corners that meet: the closest first, never two that would cross.
std::vector<Cut> merged_corners(std::span<const double> a, std::span<const double> b, double tolerance) {
  struct Candidate {
    double distance;
    std::size_t i, j;
  };
  const double longer = std::max(a.back(), b.back());
  std::vector<Candidate> candidates;
  std::size_t low = 1;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    const double at = a[i] / a.back() * longer;
    while (low + 1 < b.size() && b[low] / b.back() * longer < at - tolerance) ++low;
    for (std::size_t j = low; j + 1 < b.size(); ++j) {
      const double d = b[j] / b.back() * longer - at;
      if (d > tolerance) break;
      candidates.push_back({std::fabs(d), i, j});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return std::tie(x.distance, x.i, x.j) < std::tie(y.distance, y.i, y.j);
  });
  std::vector<std::array<std::size_t, 2>> taken;
  for (const Candidate& c : candidates) {
    const auto apart = [&](const auto& t) {
      return (t[0] < c.i && t[1] < c.j) || (t[0] > c.i && t[1] > c.j);
    };
    if (std::all_of(taken.begin(), taken.end(), apart)) taken.push_back({c.i, c.j});
  }
  std::sort(taken.begin(), taken.end());
  std::vector<Cut> merged;
  merged.reserve(taken.size());
  for (const auto& [i, j] : taken) merged.push_back({a[i], b[j]});
  return merged;
}

/// Piecewise linear through the anchors; `from` and `to` pick the sides.
double carried(double s, const std::vector<Cut>& anchors, double Cut::*from, double Cut::*to) {
  std::size_t k = 1;
  while (k + 1 < anchors.size() && anchors[k].*from < s) ++k;
  const Cut &c0 = anchors[k - 1], &c1 = anchors[k];
  return c0.*to + (s - c0.*from) / (c1.*from - c0.*from) * (c1.*to - c0.*to);
}

void add_unmerged(std::span<const double> breaks, const std::vector<Cut>& anchors, double Cut::*from,
                  double Cut::*to, std::vector<Cut>& cuts) {
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
    const auto is_here = [&](const Cut& c) { return c.*from == breaks[i]; };
    if (std::any_of(anchors.begin(), anchors.end(), is_here)) continue;
    Cut cut;
    cut.*from = breaks[i];
    cut.*to = carried(breaks[i], anchors, from, to);
    cuts.push_back(cut);
  }
}

}  // namespace

Index segment_count(double length, double particle_distance) {
  return static_cast<Index>(std::max(1.0, std::round(length / particle_distance)));
}

std::vector<SeamInterval> seam_intervals(std::span<const double> breaks_a, std::span<const double> breaks_b,
                                         double particle_distance) {
  std::vector<Cut> anchors = merged_corners(breaks_a, breaks_b, kMergeDistance * particle_distance);
  anchors.insert(anchors.begin(), Cut{0, 0});
  anchors.push_back({breaks_a.back(), breaks_b.back()});
  std::vector<Cut> cuts = anchors;
  add_unmerged(breaks_a, anchors, &Cut::a, &Cut::b, cuts);
  add_unmerged(breaks_b, anchors, &Cut::b, &Cut::a, cuts);
  std::sort(cuts.begin(), cuts.end(),
            [](const Cut& x, const Cut& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  std::vector<SeamInterval> intervals;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const Cut &c0 = cuts[i - 1], &c1 = cuts[i];
    const double longer = std::max(c1.a - c0.a, c1.b - c0.b);
    intervals.push_back({c0.a, c1.a, c0.b, c1.b, segment_count(longer, particle_distance)});
  }
  return intervals;
}

}  // namespace toile::mesh
