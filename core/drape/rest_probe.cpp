#include "core/drape/rest_probe.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace toile::drape {

namespace {

/// A pendulum of 40 cm has gone a third of its way by then.
constexpr double kTime = 0.25, kLook = 0.05;  // s; from one look to the next
/// How far cloth may go meanwhile, as times at the speed of rest: any patch of it, and the RMS over the
/// vertices.
constexpr double kPatchWay = 0.2, kRmsWay = 0.05;  // s
/// RMS up to which what went is a patch.
constexpr double kLocalWay = 0.04;  // s
/// Cloth that went away so often is judged by its speed alone.
constexpr int kMostFailed = 6;
/// Single vertices hop between contacts without damping: what counts is where they go with what is around.
constexpr int kPatchRings = 2;

/// Gives each vertex the mean over its triangles.
void even_out(std::span<const std::array<Index, 3>> triangles, std::vector<Vec3>& ways) {
  std::vector<Vec3> sum(ways.size());
  std::vector<int> count(ways.size());
  for (const std::array<Index, 3>& t : triangles) {
    const Vec3 mean = (ways[t[0]] + ways[t[1]] + ways[t[2]]) * (1.0 / 3);
    for (const Index v : t) {
      sum[v] += mean;
      ++count[v];
    }
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (count[i] > 0) ways[i] = sum[i] * (1.0 / count[i]);
  }
}

struct Gone {
  double rms = 0, patch = 0;  ///< m; of the patch that went farthest
};

Gone gone(std::span<const Vec3> from, std::span<const Vec3> x,
          std::span<const std::array<Index, 3>> triangles) {
  double sum = 0, most = 0;
  std::vector<Vec3> ways(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    ways[i] = x[i] - from[i];
    sum += dot(ways[i], ways[i]);
  }
  for (int ring = 0; ring < kPatchRings; ++ring) even_out(triangles, ways);
  for (const Vec3& way : ways) most = std::max(most, dot(way, way));
  return {std::sqrt(sum / static_cast<double>(x.size())), std::sqrt(most)};
}

}  // namespace

bool RestProbe::asks() const { return seen_.failed < kMostFailed; }

void RestProbe::begin(std::span<const Vec3> x) {
  seen_.step = 0;
  seen_.from.assign(x.begin(), x.end());
}

RestProbe::Answer RestProbe::observe(std::span<const Vec3> x,
                                     std::span<const std::array<Index, 3>> triangles) {
  TOILE_CHECK(seen_.from.size() == x.size());
  const int look = std::max(1, static_cast<int>(kLook / time_step_));
  if (++seen_.step % look != 0) return Answer::kNotYet;
  const Gone far = gone(seen_.from, x, triangles);
  if (far.patch > kPatchWay * speed_ || far.rms > kRmsWay * speed_) {
    ++seen_.failed;
    seen_.from.clear();
    return far.rms <= kLocalWay * speed_ && asks() ? Answer::kAgain : Answer::kGoes;
  }
  if (seen_.step < std::lround(kTime / kLook) * look) return Answer::kNotYet;
  seen_.from.clear();
  return Answer::kStays;
}

}  // namespace toile::drape
