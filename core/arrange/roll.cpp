#include "core/arrange/roll.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::arrange {

namespace {

constexpr double kStraight = 0.03;  // of a tube's breadth, by which its ends differ that has no narrower one
constexpr double kLevel = 1e-3;     // radians, what spreads less is a cylinder

double gap(const std::array<Vec2, 2>& pair) { return length(pair[1] - pair[0]); }

bool is_straight(const std::vector<std::array<Vec2, 2>>& seam) {
  const double a = gap(seam.front()), b = gap(seam.back());
  return std::abs(a - b) < kStraight * std::max(a, b);
}

}  // namespace

std::optional<Roll> roll_of(std::vector<std::array<Vec2, 2>> seam, Vec2 centroid, Vec2 grain) {
  if (seam.size() < 2) return std::nullopt;
  const bool straight = is_straight(seam);
  if (straight ? dot(seam.back()[0] - seam.front()[0], grain) > 0 : gap(seam.front()) > gap(seam.back()))
    std::reverse(seam.begin(), seam.end());
  const std::array<Vec2, 2>&first = seam.front(), &last = seam.back();
  const Vec2 one = last[0] - first[0], other = last[1] - first[1];
  if (length(one) == 0 || length(other) == 0) return std::nullopt;
  Roll roll;
  roll.length = (length(one) + length(other)) / 2;
  // The way down is between the two sides, and beyond half a circle on their other side.
  const Vec2 between = normalized(one) + normalized(other);
  const Vec2 inwards = centroid - (first[0] + first[1] + last[0] + last[1]) * 0.25;
  const bool half_circle = length(between) < kLevel;
  const bool beyond = !straight && !half_circle && dot(between, inwards) < 0;
  Vec2 down = half_circle ? perpendicular(normalized(one)) : normalized(between) * (beyond ? -1 : 1);
  if (half_circle && dot(down, inwards) < 0) down = down * -1;
  const double angle = std::acos(std::clamp(dot(normalized(one), normalized(other)), -1.0, 1.0));
  const double spread = beyond ? 2 * std::numbers::pi - angle : angle;
  const Vec2 ends = (first[0] + first[1]) * 0.5;
  roll.up = down * -1;
  if (straight || spread < kLevel) {
    roll.above = gap(first);
    roll.below = gap(last);
    roll.top = ends;
    return roll;
  }
  const double slant = gap(first) / 2 / std::sin(spread / 2);  // from the apex to the upper end
  roll.slope = spread / (2 * std::numbers::pi);
  roll.above = slant * spread;
  roll.below = (slant + roll.length) * spread;
  roll.top = ends + down * (slant * (1 - std::cos(spread / 2)));
  return roll;
}

}  // namespace toile::arrange
