#include "core/mesh/flat_locator.h"

#include <algorithm>
#include <cmath>

namespace toile::mesh {

namespace {

/// As a share of a triangle's size: a point this little outside lies on its border.
constexpr double kOnBorder = 1e-9;
constexpr double kReach = 1e-6;  // m, that triangles are taken to be larger, so that none is missed
constexpr double kPerCell = 2;   // triangles, about

}  // namespace

FlatLocator::FlatLocator(std::span<const Vec2> rest, std::span<const Tri> triangles)
    : rest_(rest), triangles_(triangles) {
  if (triangles.empty()) return;
  Vec2 high = low_ = rest[triangles[0][0]];
  for (const Tri& t : triangles) {
    for (const Index v : t) {
      low_ = {std::min(low_.x, rest[v].x), std::min(low_.y, rest[v].y)};
      high = {std::max(high.x, rest[v].x), std::max(high.y, rest[v].y)};
    }
  }
  const Vec2 size = high - low_;
  cell_ = std::max(kReach, std::sqrt(size.x * size.y * kPerCell / static_cast<double>(triangles.size())));
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  in_cell_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec2 a = rest[triangles[t][0]], b = rest[triangles[t][1]], c = rest[triangles[t][2]];
    const int left = column(std::min({a.x, b.x, c.x}) - kReach),
              right = column(std::max({a.x, b.x, c.x}) + kReach);
    const int top = row(std::max({a.y, b.y, c.y}) + kReach);
    for (int r = row(std::min({a.y, b.y, c.y}) - kReach); r <= top; ++r) {
      for (int k = left; k <= right; ++k) in_cell_[cell_at(r, k)].push_back(static_cast<Index>(t));
    }
  }
}

int FlatLocator::column(double x) const {
  return static_cast<int>(std::clamp((x - low_.x) / cell_, 0.0, columns_ - 1.0));
}

int FlatLocator::row(double y) const {
  return static_cast<int>(std::clamp((y - low_.y) / cell_, 0.0, rows_ - 1.0));
}

std::size_t FlatLocator::cell_at(int row, int column) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

FlatPlace FlatLocator::place_in(Index triangle, Vec2 p) const {
  const Tri& t = triangles_[static_cast<std::size_t>(triangle)];
  const Vec2 a = rest_[t[0]], b = rest_[t[1]], c = rest_[t[2]];
  const double area = cross(b - a, c - a);
  if (!(area > 0)) return {};
  FlatPlace place{
      triangle, {cross(b - p, c - p) / area, cross(c - p, a - p) / area, cross(a - p, b - p) / area}, 0};
  for (const double s : place.share) place.outside = std::max(place.outside, -s);
  return place;
}

FlatPlace FlatLocator::at(Vec2 p) const {
  FlatPlace best;
  const auto look_at = [&](Index t) {
    const FlatPlace place = place_in(t, p);
    if (place.outside < best.outside) best = place;
    return best.outside == 0;
  };
  if (triangles_.empty()) return best;
  for (const Index t : in_cell_[cell_at(row(p.y), column(p.x))])
    if (look_at(t)) return best;
  if (best.outside < kOnBorder) return best;
  best = {};
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (look_at(static_cast<Index>(t))) break;
  return best;
}

}  // namespace toile::mesh
