#pragma once
// A solid as contact sees it.

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/collision/near_edges.h"
#include "core/collision/surface.h"
#include "core/geometry/box_groups.h"

namespace toile::collision {

/// Boxes around each feature of a surface, by kind: what is asked for pairs.
struct FeatureBoxes {
  /// Of all places where a feature may be; edges and faces in the surface's order, vertices by index.
  std::vector<geometry::Box3> vertices, edges, faces;
  geometry::BoxGroups vertex_groups, edge_groups, face_groups;

  /// Edges and faces from `vertices`, then the groups: made the first time, refitted from then on.
  void lay_around(const Surface& surface);
  /// The same where only these vertices' boxes, and those of the edges and faces at them, are new.
  void lay_around(const Surface& surface, std::span<const Index> new_vertices,
                  std::span<const Index> new_edges, std::span<const Index> new_faces);

 private:
  void lay_edge(const Surface& surface, Index e);
  void lay_face(const Surface& surface, Index t);
};

/// Stands still while the cloth makes a step; moves between two.
struct Obstacle {
  std::vector<Vec3> vertices;
  Surface surface;
  FeatureBoxes boxes;  ///< grown by the skin offset
  std::vector<EdgeLine> edge_lines;
  /// Outwards; those of vertices and edges are the means of their faces'.
  std::vector<Vec3> vertex_normals, edge_normals, face_normals;
  std::vector<std::array<Index, 3>> edges_of_face;
  std::vector<Vec3> velocities;  ///< m/s, one a vertex: what rubs on it is carried along; empty: none
  double friction = 0.4;         ///< Coulomb
  double skin_offset = 1e-3;     ///< m
  double restitution = 0;        ///< share of the speed of a impact that cloth leaves with
};
Obstacle make_obstacle(std::span<const Vec3> vertices, std::span<const Tri> triangles, double friction,
                       double skin_offset, double restitution = 0);
/// Puts it elsewhere, or gives it another shape: `vertices` (m), as many as it has. Where it may go without
/// touching cloth is for core/collision/obstacle_way.h to say.
void move_obstacle(Obstacle& obstacle, std::span<const Vec3> vertices);

}  // namespace toile::collision
