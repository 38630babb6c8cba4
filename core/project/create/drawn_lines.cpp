#include "core/project/create/drawn_lines.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon2.h"

namespace toile::create {
namespace {

constexpr double kLineLeaves = 0.5;  // mm, that the line's vertices leave it
constexpr double kBeyond = 40;       // mm that the line may end beyond the outline, in the allowance

}  // namespace

std::optional<Chord> chord_across(const std::vector<Vec2>& line, const std::vector<Vec2>& outline,
                                  double short_mm) {
  const Vec2 whole = line.back() - line.front();
  const double long_as = length(whole);
  if (long_as < 1 || !geometry::is_flat(line, kLineLeaves)) return std::nullopt;
  const Vec2 along = normalized(whole);
  double first = HUGE_VAL, last = -HUGE_VAL;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double sa = cross(along, a - line.front()), sb = cross(along, b - line.front());
    if ((sa < 0) == (sb < 0)) continue;  // so that one through a corner is met once
    const double at = dot(a + sa / (sa - sb) * (b - a) - line.front(), along);
    if (at < -short_mm || at > long_as + short_mm) continue;
    first = std::min(first, at);
    last = std::max(last, at);
  }
  if (first > kBeyond || last < long_as - kBeyond || last - first < 1) return std::nullopt;
  return Chord{line.front() + first * along, line.front() + last * along};
}

}  // namespace toile::create
