#include "core/draft/lathe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/units.h"

namespace toile::draft {
namespace {

/// Coordinates of a vertex of the box's grid, in steps.
using Cell = std::array<int, 3>;

class BoxGrid {
 public:
  BoxGrid(Vec3 low, Vec3 size, Cell cells) : low_(low), size_(size), cells_(cells) {}

  Index vertex(const Cell& c) {
    const auto [it, fresh] = index_.emplace(c, static_cast<Index>(mesh_.vertices.size()));
    if (fresh) {
      mesh_.vertices.push_back({low_.x + size_.x * c[0] / cells_[0], low_.y + size_.y * c[1] / cells_[1],
                                low_.z + size_.z * c[2] / cells_[2]});
    }
    return it->second;
  }

  /// The side square to `axis`, at its low or high end.
  void add_side(int axis, bool high) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < cells_[u]; ++i) {
      for (int j = 0; j < cells_[v]; ++j) {
        const auto at = [&](int du, int dv) {
          Cell c{};
          c[axis] = high ? cells_[axis] : 0;
          c[u] = i + du;
          c[v] = j + dv;
          return vertex(c);
        };
        Tri one{at(0, 0), at(1, 0), at(1, 1)}, other{at(0, 0), at(1, 1), at(0, 1)};
        for (Tri* t : {&one, &other}) {
          if (!high) std::swap((*t)[1], (*t)[2]);
          mesh_.triangles.push_back(*t);
        }
      }
    }
  }

  geometry::TriangleMesh take() { return std::move(mesh_); }

 private:
  Vec3 low_, size_;
  Cell cells_;
  std::map<Cell, Index> index_;
  geometry::TriangleMesh mesh_;
};

}  // namespace

geometry::TriangleMesh turned_solid(const std::vector<Vec2>& profile, int around) {
  geometry::TriangleMesh mesh;
  const auto rows = static_cast<Index>(profile.size()) - 2;  // those off the axis
  mesh.vertices.push_back({0, profile.front().y, 0});
  for (Index r = 1; r <= rows; ++r) {
    for (Index k = 0; k < around; ++k) {
      const double angle = 2 * kPi * k / around;
      mesh.vertices.push_back({profile[r].x * std::cos(angle), profile[r].y, profile[r].x * std::sin(angle)});
    }
  }
  mesh.vertices.push_back({0, profile.back().y, 0});
  const auto at = [&](Index row, Index k) { return 1 + row * around + k % around; };
  const auto last = static_cast<Index>(mesh.vertices.size()) - 1;
  for (Index k = 0; k < around; ++k) {
    mesh.triangles.push_back({0, at(0, k), at(0, k + 1)});
    for (Index r = 0; r + 1 < rows; ++r) {
      mesh.triangles.push_back({at(r, k), at(r + 1, k), at(r + 1, k + 1)});
      mesh.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r, k + 1)});
    }
    mesh.triangles.push_back({at(rows - 1, k), last, at(rows - 1, k + 1)});
  }
  return mesh;
}

geometry::TriangleMesh box_solid(Vec3 low, Vec3 high, double step) {
  const Vec3 size = high - low;
  const auto cells = [&](double length) { return std::max(1, static_cast<int>(std::lround(length / step))); };
  BoxGrid grid(low, size, {cells(size.x), cells(size.y), cells(size.z)});
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high_end : {false, true}) grid.add_side(axis, high_end);
  return grid.take();
}

}  // namespace toile::draft
