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

/// Whether the way a → b → c turns back at b on a short stretch, or on a longer one along itself.
bool is_backtrack(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double kShort = 0.1;       // mm
  constexpr double kTurnsBack = -0.5;  // cosine of the turn: more than 120°
  constexpr double kNoWidth = 0.005;   // mm, of a tip that holds no cloth
  const double in = length(b - a), out = length(c - b), along = dot(b - a, c - b);
  if (along >= kTurnsBack * in * out) return false;
  return std::min(in, out) < kShort || std::abs(cross(b - a, c - b)) < kNoWidth * std::max(in, out);
}

/// Vertices of one place as one: segments must be real ones.
void join_vertices(std::vector<Vec2>& p) {
  const auto same = [](Vec2 a, Vec2 b) { return length(b - a) < pattern::kJointTolerance; };
  p.erase(std::unique(p.begin(), p.end(), same), p.end());
  while (p.size() > 1 && same(p.back(), p.front())) p.pop_back();
}

}  // namespace

RepairedOutline without_backtracks(const std::vector<Vec2>& outline) {
  RepairedOutline result{outline, {}};
  std::vector<Vec2>& p = result.points;
  join_vertices(p);
  bool found = true;
  while (found &&
         p.size() > 3) {  // a tip that goes may leave another one: each round takes one away at least
    found = false;
    std::vector<Vec2> kept;
    for (std::size_t i = 0, n = p.size(); i < n; ++i) {
      const Vec2 before = kept.empty() ? p[n - 1] : kept.back();
      const bool tip = n - i + kept.size() > 3 && is_backtrack(before, p[i], p[(i + 1) % n]);
      found = found || tip;
      if (tip) result.cut_at.push_back(p[i]);
      if (!tip) kept.push_back(p[i]);
    }
    p = std::move(kept);
    join_vertices(p);
  }
  return result.cut_at.empty() ? RepairedOutline{outline, {}} : result;
}

RepairedOutline without_small_loops(const std::vector<Vec2>& outline) {
  RepairedOutline result{outline, {}};
  std::vector<Vec2>& p = result.points;
  join_vertices(p);
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
