#pragma once
// How deep inside a body, or how far outside, any point lies: on a grid, so that thousands of vertices can
// ask in every pass. Beside it, how thick the body is there, so that a slimmer figure of it can be asked for.

#include <array>
#include <vector>

#include "core/base/aabb.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::dressing {

class DistanceField {
 public:
  /// `cell` in m. Holes in the mesh and parts that cross do not matter: inside is what most of the lines
  /// along the three axes take for inside.
  DistanceField(const geometry::TriangleMesh& mesh, double cell);

  /// m; negative inside. Beyond the grid, which reaches some cells past the mesh, the way to the grid is
  /// added.
  double distance(Vec3 p) const { return sample(distance_, p) + beyond(p); }

  /// m; half of what the body measures through its middle there: the radius of the largest ball within it
  /// that holds the point (Hildebrand and Rüegsegger 1997). 0 away from the body.
  double half_thickness(Vec3 p) const { return sample(half_thickness_, p); }

  /// Distance to the figure that is drawn in by `slim` (0 to below 1) of its half thickness everywhere.
  double distance(Vec3 p, double slim) const;
  /// Its unit gradient: the way out.
  Vec3 outwards(Vec3 p, double slim) const;

  double cell() const { return cell_; }

 private:
  std::size_t at(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(i);
  }
  Vec3 place(int i, int j, int k) const { return box_.low + Vec3{i * cell_, j * cell_, k * cell_}; }
  double sample(const std::vector<float>& values, Vec3 p) const;
  double beyond(Vec3 p) const;
  void measure_near(const geometry::TriangleMesh& mesh);
  void sweep();
  void find_inside(const geometry::TriangleMesh& mesh);
  void find_thickness();
  void smooth_thickness(int passes);

  double cell_;
  Aabb3 box_;
  std::array<int, 3> size_{};
  std::vector<float> distance_, half_thickness_;
};

}  // namespace toile::dressing
