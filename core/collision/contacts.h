#pragma once
// What keeps cloth from going through: a detection lists every pair of features that could meet before
// the next one, and bounds how far each vertex may go. After Chen et al., "Offset Geometric Contact" (2025):
// a pair's certificate is the plane between its closest points, which each side may approach but not reach;
// a vertex's trust region covers all pairs that are not listed. Bounds limit the way from each vertex's
// centre, its place at the last detection, not the move of one step, so they cannot add up.

#include <array>
#include <initializer_list>
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
};

/// A solid as contact sees it. Does not move.
struct Obstacle {
  std::vector<Vec3> vertices;
  Surface surface;
  FeatureBoxes boxes;  ///< grown by the skin offset
  std::vector<EdgeLine> edge_lines;
  /// Outwards; those of vertices and edges are the means of their faces'.
  std::vector<Vec3> vertex_normals, edge_normals, face_normals;
  double friction = 0.4;      ///< Coulomb
  double skin_offset = 1e-3;  ///< m
  double restitution = 0;     ///< share of the speed of a impact that cloth leaves with
};
Obstacle make_obstacle(std::span<const Vec3> vertices, std::span<const Tri> triangles, double friction,
                       double skin_offset, double restitution = 0);

struct ContactSettings {
  double thickness = 1e-3;  ///< m, distance that layers of cloth keep
  /// m, at most, of each vertex; empty: `thickness` for all. Where triangles are narrower than the cloth is
  /// thick, neighbours in the flat would push each other apart.
  std::vector<double> vertex_thickness;
  double cloth_friction = 0.3;
  double trust_radius_least = 1e-3;  ///< m
  double trust_radius_most = 5e-3;   ///< m; at most a quarter of the mean edge
  double trust_radius_seconds =
      4e-3;  ///< s, time ahead that a trust region covers at 1.5 times the present speed
};

/// Gap under which a side may not approach further. More than the rounding of the exact crossing test (1 µm).
inline constexpr double kContactFloor = 20e-6;

/// Two features that are pushed apart to `rest` and rub on each other. Signed distance along the division
/// plane: s(x) = n·(Σ wᵢ xᵢ) − c over the cloth vertices; what the solid contributes stands in c.
struct Contact {
  int count = 0;  ///< of cloth vertices: 1 to 3 on a solid, 4 between layers
  Index v[4] = {kNone, kNone, kNone, kNone};
  double w[4] = {0, 0, 0, 0};
  Vec3 n;
  double c = 0;
  double rest = 0;
  double friction = 0;
  double restitution = 0;
};

/// A half-space that a vertex stays in: n·(x − x0) ≥ −slack, x0 the centre.
struct DivisionPlane {
  Vec3 n;
  double slack = 0;
};

/// The result of a detection: valid while every vertex keeps its bounds.
struct Contacts {
  std::vector<Vec3> centre;          ///< x0
  std::vector<double> trust_radius;  ///< m, radius around x0
  std::vector<double> free_radius;   ///< m, radius around x0 in which neither trust region nor plane is met
  std::vector<Index> plane_start;    ///< first plane of each vertex, one more at the end
  std::vector<DivisionPlane> planes;
  std::vector<Contact> contacts;
  double least_gap = 1;            ///< m, of all pairs that came near; 1 when none did
  Index least_gap_vertex = kNone;  ///< a vertex of that pair

  /// True when x is too near x0 to meet any bound: what most vertices are, most of the time.
  bool surely_inside(Index v, Vec3 x) const {
    const Vec3 d = x - centre[v];
    return dot(d, d) <= free_radius[v] * free_radius[v];
  }
  bool inside_trust_region(Index v, Vec3 x) const;
  bool inside_planes(Index v, Vec3 x) const;
  /// Largest t in [0, 1] such that from + t·(to − from) stays within the vertex's planes.
  double plane_reach(Index v, Vec3 from, Vec3 to) const;
  /// Where a vertex comes that wants to go to `to`: along the planes that it meets, up to the rim of its
  /// trust region. `from` must keep the bounds; so does what is returned.
  Vec3 reached(Index v, Vec3 from, Vec3 to) const;
};

/// Finds contacts and bounds of a cloth among obstacles, over and over. The obstacles must outlive it.
class ContactFinder {
 public:
  ContactFinder(Surface cloth, std::span<const Obstacle> obstacles, ContactSettings settings);

  /// Measures at `positions` (m); `speeds` (m/s, one a vertex) size the trust regions.
  void detect(std::span<const Vec3> positions, std::span<const double> speeds, Contacts& out);

  const Surface& cloth() const { return cloth_; }
  ContactSettings& settings() { return settings_; }

 private:
  struct VertexPlane {
    Index vertex;
    DivisionPlane plane;
  };

  void size_trust_regions(std::span<const double> speeds, Contacts& out) const;
  void lay_boxes(std::span<const Vec3> positions, const Contacts& out);
  void lay_edge_lines(std::span<const Vec3> positions, const Contacts& out);
  void pair_with_obstacles(Contacts& out);
  void pair_with_itself(Contacts& out);
  void vertex_on_obstacle(const Obstacle& obstacle, Index vertex, Index face, Contacts& out);
  void obstacle_vertex_on_cloth(const Obstacle& obstacle, Index theirs, const Tri& triangle, Contacts& out);
  void edge_on_obstacle(const Obstacle& obstacle, Index a0, Index a1, Index theirs, Contacts& out);
  void vertex_on_cloth(Index vertex, const Tri& triangle, Contacts& out);
  void edges_of_cloth(Index a0, Index a1, Index b0, Index b1, Contacts& out);
  /// Notes a pair's gap; false when there is none to push along (the features touch, or are out of reach).
  bool has_gap(double gap, double reach, Index vertex, Contacts& out);
  void bound(Index vertex, Vec3 n, Vec3 closest, double allowance, const Contacts& out);
  void sort_planes(Contacts& out);
  void find_free_radii(Contacts& out) const;
  void keep_nearest(Contacts& out);
  double thickness_at(std::initializer_list<Index> vertices) const;
  bool neighbours(Index a, Index b) const { return cloth_.vertex_class[a] == cloth_.vertex_class[b]; }

  Surface cloth_;
  std::span<const Obstacle> obstacles_;
  ContactSettings settings_;
  FeatureBoxes boxes_;
  std::vector<std::array<Index, 2>> edge_classes_;  ///< of the ends of each edge
  std::vector<EdgeLine> edge_lines_;
  std::vector<EdgePair> edge_pairs_;  ///< with boxes that overlap
  struct Near {
    double gap;
    Contact contact;
  };
  std::vector<VertexPlane> found_;  ///< planes in order of discovery
  std::vector<Near> near_;          ///< vertices on triangles likewise
  std::vector<Contact> rims_;       ///< triangles on points, edges on edges
};

}  // namespace toile::collision
