#include "core/pattern/dxf/fold.h"

#include <algorithm>
#include <cmath>

namespace toile::dxf {
namespace {
constexpr double kShortestFold = 5;       // mm
constexpr double kBothSides = 2;          // mm beyond the axis
constexpr double kBothSidesShare = 0.02;  // and of the other side's reach
constexpr double kEven = 0.9;             // of the other side's reach
}  // namespace

std::optional<FoldAxis> fold_axis(const std::vector<Vec2>& line) {
  const Vec2 along = normalized(line.back() - line.front());
  if (along == Vec2{}) return std::nullopt;
  return FoldAxis{line.front(), along};
}

namespace {

/// mm, that the points reach to the left of the axis and to the right.
struct Reach {
  double left = 0, right = 0;
  double less() const { return std::min(left, right); }
  double more() const { return std::max(left, right); }
};

Reach reach_of(const std::vector<Vec2>& points, const FoldAxis& axis) {
  Reach reach;
  for (const Vec2 p : points) {
    reach.left = std::max(reach.left, axis.side(p));
    reach.right = std::max(reach.right, -axis.side(p));
  }
  return reach;
}

}  // namespace

bool spans_fold(const std::vector<Vec2>& points, const FoldAxis& axis) {
  const Reach reach = reach_of(points, axis);
  return reach.less() > std::max(kBothSides, kBothSidesShare * reach.more());
}

bool is_even_about(const std::vector<Vec2>& points, const FoldAxis& axis) {
  const Reach reach = reach_of(points, axis);
  return reach.less() >= kEven * reach.more();
}

bool closes_at_fold(const std::vector<Vec2>& points, const FoldAxis& axis) {
  return std::abs(axis.side(points.front())) <= kOnFold && std::abs(axis.side(points.back())) <= kOnFold &&
         length(points.front() - points.back()) >= kShortestFold;
}

namespace {

/// A run of the half off the axis, with the points on it before and behind.
struct OffRun {
  std::vector<Vec2> points;
  double low = 0, high = 0;  // mm along the axis, of its ends
};

OffRun run_from(const std::vector<Vec2>& half, std::size_t first, const FoldAxis& axis) {
  const std::size_t n = half.size();
  OffRun run;
  run.points.push_back(axis.snapped(half[first]));
  std::size_t i = (first + 1) % n;
  for (; std::abs(axis.side(half[i])) > kOnFold; i = (i + 1) % n) run.points.push_back(half[i]);
  run.points.push_back(axis.snapped(half[i]));
  const double a = dot(run.points.front() - axis.at, axis.along),
               b = dot(run.points.back() - axis.at, axis.along);
  run.low = std::min(a, b);
  run.high = std::max(a, b);
  return run;
}

/// The run, and back along its mirror image.
std::vector<Vec2> both_halves(const OffRun& run, const FoldAxis& axis) {
  std::vector<Vec2> whole = run.points;
  for (std::size_t i = whole.size() - 1; i-- > 1;) whole.push_back(axis.mirrored(whole[i]));
  return whole;
}

}  // namespace

std::optional<UnfoldedLoop> unfolded_loop(const std::vector<Vec2>& half, const FoldAxis& axis) {
  const std::size_t n = half.size();
  const auto on = [&](std::size_t i) { return std::abs(axis.side(half[i % n])) <= kOnFold; };
  std::vector<OffRun> runs;
  for (std::size_t i = 0; i < n; ++i)
    if (on(i) && !on(i + 1)) runs.push_back(run_from(half, i, axis));
  if (runs.empty()) return std::nullopt;
  std::stable_sort(runs.begin(), runs.end(),
                   [](const OffRun& a, const OffRun& b) { return a.high - a.low > b.high - b.low; });
  if (runs[0].high - runs[0].low < kShortestFold) return std::nullopt;
  std::sort(runs.begin() + 1, runs.end(), [](const OffRun& a, const OffRun& b) { return a.low < b.low; });
  UnfoldedLoop whole{both_halves(runs[0], axis), {}};
  double free_from = runs[0].low;  // the axis is the half's own from there on
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const bool apart = runs[k].low >= free_from && runs[k].high <= runs[0].high;
    if (!apart || runs[k].high - runs[k].low < kOnFold) return std::nullopt;
    free_from = runs[k].high;
    whole.holes.push_back(both_halves(runs[k], axis));
  }
  return whole;
}

}  // namespace toile::dxf
