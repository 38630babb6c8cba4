#pragma once
// Plane cuts of a mesh, for the tape.

#include <span>
#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace toile::measure {

/// Where a plane meets a mesh: the points on its edges, and which connected part each belongs to.
struct MeshCut {
  std::vector<Vec3> points;
  std::vector<Index> part;  ///< one per point, 0 to part_count − 1, by first point
  Index part_count = 0;
};

/// Cuts by parallel planes dot(direction, p) = height. Triangles are kept in bins along the direction, so
/// that a cut looks only at those near it. Keeps a reference to the mesh.
class MeshCutter {
 public:
  /// `triangles` names those that count; empty: all. REQUIRES a unit direction.
  MeshCutter(const geometry::TriangleMesh& mesh, Vec3 direction, std::span<const Index> triangles = {});

  MeshCut at(double height) const;
  double low() const { return low_; }    ///< least height of a triangle that counts
  double high() const { return high_; }  ///< greatest

 private:
  size_t bin(double height) const;

  const geometry::TriangleMesh& mesh_;
  std::vector<double> height_;            ///< of each vertex
  std::vector<std::vector<Index>> bins_;  ///< triangles that reach into each bin
  double low_ = 0, high_ = 0, step_ = 1;
};

/// Cuts by planes of any direction. Triangles are kept in small groups of neighbours with the balls around
/// them, so that a cut looks only at those the plane may meet. Keeps a reference to the mesh.
class PlaneCutter {
 public:
  explicit PlaneCutter(const geometry::TriangleMesh& mesh);

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  /// The same as plane_cut() over all triangles.
  MeshCut cut(Vec3 origin, Vec3 normal) const;

 private:
  struct Group {
    Vec3 centre;
    double radius = 0;
    size_t end = 0;  ///< in order_; a group begins where the one before ends
  };

  const geometry::TriangleMesh& mesh_;
  std::vector<Index> order_;  ///< triangles, group after group
  std::vector<Group> groups_;
};

/// The cut by any plane, over the triangles named; all when none are. For several cuts: PlaneCutter.
MeshCut plane_cut(const geometry::TriangleMesh& mesh, Vec3 origin, Vec3 normal,
                  std::span<const Index> triangles = {});

}  // namespace toile::measure
