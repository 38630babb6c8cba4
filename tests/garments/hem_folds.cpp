#include "tests/garments/hem_folds.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace toile::garments {
namespace {

constexpr int kSectors = 90;
/// The least sum of turning (radians) that makes a dent a fold: noise of the mesh stays below it, and a fold
/// of a centimetre's depth at a hand's width turns by 0.4.
constexpr double kLeastTurn = 0.15;

Vec2 middle_of(std::span<const Vec3> positions) {
  Vec2 sum;
  for (const Vec3& p : positions) sum = sum + Vec2{p.x, p.z};
  return sum * (1 / static_cast<double>(positions.size()));
}

/// The lowest vertex of each sector, seen from above; sectors without one are left out.
std::vector<Vec2> hem_outline(std::span<const Vec3> positions) {
  const Vec2 middle = middle_of(positions);
  std::vector<std::optional<Vec3>> lowest(kSectors);
  for (const Vec3& p : positions) {
    const double turn = std::atan2(p.z - middle.y, p.x - middle.x) / (2 * std::numbers::pi) + 0.5;
    std::optional<Vec3>& least = lowest[static_cast<std::size_t>(turn * kSectors) % kSectors];
    if (!least || p.y < least->y) least = p;
  }
  std::vector<Vec2> outline;
  for (const std::optional<Vec3>& p : lowest)
    if (p) outline.push_back({p->x, p->z});
  return outline;
}

/// Each point among its neighbours, twice: sectors take the vertex that happens to be lowest.
std::vector<Vec2> smoothed(std::vector<Vec2> outline) {
  for (int round = 0; round < 2; ++round) {
    const std::vector<Vec2> before = outline;
    const std::size_t n = before.size();
    for (std::size_t i = 0; i < n; ++i)
      outline[i] = before[(i + n - 1) % n] * 0.25 + before[i] * 0.5 + before[(i + 1) % n] * 0.25;
  }
  return outline;
}

/// Signed angle (radians) by which the outline turns at each point; positive: outwards, as a circle does.
std::vector<double> turning(const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  std::vector<double> turns;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = outline[i] - outline[(i + n - 1) % n], out = outline[(i + 1) % n] - outline[i];
    turns.push_back(std::atan2(cross(in, out), dot(in, out)));
  }
  return turns;
}

}  // namespace

int hem_folds(std::span<const Vec3> positions) {
  const std::vector<double> turns = turning(smoothed(hem_outline(positions)));
  const std::size_t n = turns.size();
  std::size_t start = 0;  // where a stretch that turns outwards begins, so that none is cut in two
  while (start < n && turns[start] <= 0) ++start;
  int folds = 0;
  double inwards = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const double turn = turns[(start + k) % n];
    if (turn < 0 && k < n) {
      inwards -= turn;
      continue;
    }
    if (inwards >= kLeastTurn) ++folds;
    inwards = 0;
  }
  return folds;
}

}  // namespace toile::garments
