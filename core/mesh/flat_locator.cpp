#include "core/mesh/flat_locator.h"

#include <algorithm>
#include <cmath>

namespace toile::mesh {

namespace {

/// As a share of a triangle's size: a point this little outside lies on its border.
constexpr double kOnBorder = 1e-9;
constexpr double kLarger = 1e-6;          // m, that triangles are taken to be larger, so that none is missed
constexpr double kPerCell = 2;            // triangles, about
constexpr double kMostCells = 4096;       // a side, of the longer one
constexpr std::size_t kMostEntries = 32;  // cells that a triangle reaches into, in the mean

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
  const double even = std::sqrt(size.x * size.y * kPerCell / static_cast<double>(triangles.size()));
  cell_ = std::max({kLarger, even, std::max(size.x, size.y) / kMostCells});
  lay_grid(size);
  // Long slivers would fill every cell: a file may hold anything.
  while (entries() > kMostEntries * triangles.size() && columns_ * rows_ > 1) {
    cell_ *= 2;
    lay_grid(size);
  }
  in_cell_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Cells cells = cells_of(triangles[t]);
    for (int r = cells.bottom; r <= cells.top; ++r) {
      for (int k = cells.left; k <= cells.right; ++k)
        in_cell_[cell_at(r, k)].push_back(static_cast<Index>(t));
    }
  }
}

void FlatLocator::lay_grid(Vec2 size) {
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
}

FlatLocator::Cells FlatLocator::cells_of(const Tri& t) const {
  const Vec2 a = rest_[t[0]], b = rest_[t[1]], c = rest_[t[2]];
  return {column(std::min({a.x, b.x, c.x}) - kLarger), column(std::max({a.x, b.x, c.x}) + kLarger),
          row(std::min({a.y, b.y, c.y}) - kLarger), row(std::max({a.y, b.y, c.y}) + kLarger)};
}

std::size_t FlatLocator::entries() const {
  std::size_t sum = 0;
  for (const Tri& t : triangles_) {
    const Cells cells = cells_of(t);
    sum += static_cast<std::size_t>(cells.right - cells.left + 1) *
           static_cast<std::size_t>(cells.top - cells.bottom + 1);
  }
  return sum;
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
