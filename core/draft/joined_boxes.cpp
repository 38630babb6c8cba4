#include "core/draft/joined_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace toile::draft {
namespace {

/// Of a plane along each axis, or of the cell above those planes.
using Cell = std::array<int, 3>;
using Axis = double Vec3::*;
constexpr std::array<Axis, 3> kAxes{&Vec3::x, &Vec3::y, &Vec3::z};

/// Where the boxes begin and end along an axis, and as many planes between as `step` asks for.
std::vector<double> planes_along(Axis axis, const std::vector<Box>& boxes, double step) {
  constexpr double kSame = 1e-9;  // m
  std::vector<double> ends;
  for (const Box& box : boxes) {
    ends.push_back(box.low.*axis);
    ends.push_back(box.high.*axis);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<double> planes{ends.front()};
  for (const double end : ends) {
    const double from = planes.back();
    if (end - from < kSame) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil((end - from) / step - kSame)));
    for (int i = 1; i <= parts; ++i) planes.push_back(from + (end - from) * i / parts);
  }
  return planes;
}

class JoinedGrid {
 public:
  JoinedGrid(const std::vector<Box>& boxes, double step) : boxes_(boxes) {
    for (int axis = 0; axis < 3; ++axis) planes_[axis] = planes_along(kAxes[axis], boxes, step);
  }

  geometry::TriangleMesh skin() {
    const auto cells = [&](int axis) { return static_cast<int>(planes_[axis].size()) - 1; };
    for (int i = 0; i < cells(0); ++i)
      for (int j = 0; j < cells(1); ++j)
        for (int k = 0; k < cells(2); ++k) add_cell({i, j, k});
    return std::move(mesh_);
  }

 private:
  /// Whether the cell lies in one of the boxes; beyond the outermost planes none does.
  bool filled(const Cell& cell) const {
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] + 1 >= static_cast<int>(planes_[axis].size())) return false;
      middle.*kAxes[axis] = (planes_[axis][cell[axis]] + planes_[axis][cell[axis] + 1]) / 2;
    }
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
      return std::all_of(kAxes.begin(), kAxes.end(), [&](Axis axis) {
        return box.low.*axis < middle.*axis && middle.*axis < box.high.*axis;
      });
    });
  }

  void add_cell(const Cell& cell) {
    if (!filled(cell)) return;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int way : {-1, 1}) {
        Cell beside = cell;
        beside[axis] += way;
        if (!filled(beside)) add_face(cell, axis, way > 0);
      }
    }
  }

  void add_face(const Cell& cell, int axis, bool high) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](int du, int dv) {
      Cell at = cell;
      if (high) ++at[axis];
      at[u] += du;
      at[v] += dv;
      return vertex(at);
    };
    for (Tri t :
         {Tri{corner(0, 0), corner(1, 0), corner(1, 1)}, Tri{corner(0, 0), corner(1, 1), corner(0, 1)}}) {
      if (!high) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
  }

  Index vertex(const Cell& at) {
    const auto [it, fresh] = index_.emplace(at, static_cast<Index>(mesh_.vertices.size()));
    if (fresh) mesh_.vertices.push_back({planes_[0][at[0]], planes_[1][at[1]], planes_[2][at[2]]});
    return it->second;
  }

  const std::vector<Box>& boxes_;
  std::array<std::vector<double>, 3> planes_;
  std::map<Cell, Index> index_;
  geometry::TriangleMesh mesh_;
};

}  // namespace

geometry::TriangleMesh joined_boxes(const std::vector<Box>& boxes, double step) {
  return JoinedGrid(boxes, step).skin();
}

}  // namespace toile::draft
