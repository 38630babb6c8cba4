#include "core/pattern/dxf_fold.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {
constexpr double kShortestFold = 5;       // mm
constexpr double kBothSides = 2;          // mm beyond the axis
constexpr double kBothSidesShare = 0.02;  // and of the other side's reach
}  // namespace

std::optional<FoldAxis> fold_axis(const std::vector<Vec2>& line) {
  const Vec2 along = normalized(line.back() - line.front());
  if (along == Vec2{}) return std::nullopt;
  return FoldAxis{line.front(), along};
}

bool spans_fold(const std::vector<Vec2>& points, const FoldAxis& axis) {
  double left = 0, right = 0;
  for (const Vec2 p : points) left = std::max(left, axis.side(p)), right = std::max(right, -axis.side(p));
  return std::min(left, right) > std::max(kBothSides, kBothSidesShare * std::max(left, right));
}

bool closes_at_fold(const std::vector<Vec2>& points, const FoldAxis& axis) {
  return std::abs(axis.side(points.front())) <= kOnFold && std::abs(axis.side(points.back())) <= kOnFold &&
         length(points.front() - points.back()) >= kShortestFold;
}

std::optional<std::vector<Vec2>> unfolded_loop(const std::vector<Vec2>& half, const FoldAxis& axis) {
  const std::size_t n = half.size();
  const auto on = [&](std::size_t i) { return std::abs(axis.side(half[i % n])) <= kOnFold; };
  // The run ends at `end`: on the axis there, off it behind.
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < n; ++i)
    if (on(i) && !on(i + 1)) ends.push_back(i);
  if (ends.size() != 1) return std::nullopt;
  const std::size_t end = ends[0];
  std::size_t begin = end;
  while (on(begin + n - 1) && (begin + n - 1) % n != end) begin = (begin + n - 1) % n;
  if (length(half[begin] - half[end]) < kShortestFold) return std::nullopt;
  std::vector<Vec2> whole{axis.snapped(half[end])};
  for (std::size_t i = (end + 1) % n; i != begin; i = (i + 1) % n) whole.push_back(half[i]);
  whole.push_back(axis.snapped(half[begin]));
  for (std::size_t i = whole.size() - 1; i-- > 1;) whole.push_back(axis.mirrored(whole[i]));
  return whole;
}

}  // namespace toile
