#include "core/pattern/dxf/repair.h"

#include <algorithm>
#include <optional>

#include "core/geometry/polygon2.h"
#include "core/pattern/outline.h"

namespace toile::dxf {
namespace {

constexpr int kMostLoops = 50;
constexpr double kLargestLoop = 5;  // mm around
constexpr double kLargestShare = 0.02;

/// Length along the closed outline from the crossing on segment a to that on segment b, a before b.
double way(const std::vector<Vec2>& p, std::size_t a, std::size_t b, Vec2 at) {
  double sum = length(p[(a + 1) % p.size()] - at) + length(at - p[b]);
  for (std::size_t i = a + 1; i < b; ++i) sum += length(p[i + 1] - p[i]);
  return sum;
}

/// One loop less, or nothing when the crossing is no small one.
std::optional<std::vector<Vec2>> cut(const std::vector<Vec2>& p, const geometry::Crossing& c) {
  const std::size_t a = std::min(c.segment_a, c.segment_b), b = std::max(c.segment_a, c.segment_b);
  const double whole = geometry::polyline_length(p) + length(p.front() - p.back());
  const double inner = way(p, a, b, c.point), most = std::min(kLargestLoop, kLargestShare * whole);
  std::vector<Vec2> rest;
  if (inner <= most) {  // a+1 … b go
    rest.assign(p.begin(), p.begin() + std::ptrdiff_t(a) + 1);
    rest.push_back(c.point);
    rest.insert(rest.end(), p.begin() + std::ptrdiff_t(b) + 1, p.end());
  } else if (whole - inner <= most) {  // the rest goes: the loop holds the outline's first point
    rest.assign(p.begin() + std::ptrdiff_t(a) + 1, p.begin() + std::ptrdiff_t(b) + 1);
    rest.push_back(c.point);
  } else {
    return std::nullopt;
  }
  return rest.size() >= 3 && rest.size() <= p.size() + 1 ? std::optional(std::move(rest)) : std::nullopt;
}

}  // namespace

RepairedOutline without_small_loops(const std::vector<Vec2>& outline) {
  RepairedOutline result{outline, {}};
  std::vector<Vec2>& p = result.points;
  // Vertices of one place first: the crossing's segments must be real ones.
  p.erase(std::unique(p.begin(), p.end(),
                      [](Vec2 a, Vec2 b) { return length(b - a) < pattern::kJointTolerance; }),
          p.end());
  while (p.size() > 1 && length(p.back() - p.front()) < pattern::kJointTolerance) p.pop_back();
  if (p.size() < 4) return {outline, {}};
  for (int i = 0; i < kMostLoops; ++i) {
    const std::vector<std::vector<Vec2>> loops{p};
    const std::optional<geometry::Crossing> crossing = geometry::find_crossing(loops);
    std::optional<std::vector<Vec2>> rest = crossing ? cut(p, *crossing) : std::nullopt;
    if (!rest) break;
    p = std::move(*rest);
    result.cut_at.push_back(crossing->point);
  }
  return result;
}

}  // namespace toile::dxf
