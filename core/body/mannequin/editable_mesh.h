#pragma once
// A closed manifold mesh that can be changed edge by edge. Every operation refuses what would break it.

#include <vector>

#include "core/body/mannequin/field_sample.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::mannequin {

class EditableMesh {
 public:
  /// REQUIRES a closed manifold with consistent winding. Normals are null until vertices are moved.
  explicit EditableMesh(geometry::TriangleMesh mesh);

  using Edge = std::array<Index, 2>;

  const Vec3& position(Index v) const { return positions_[v]; }
  void move(Index v, const SurfacePoint& p) {
    positions_[v] = p.position;
    normals_[v] = p.normal;
  }
  Index vertex_count() const { return static_cast<Index>(positions_.size()); }
  Index triangle_count() const { return live_; }
  bool is_live(Index v) const { return !fans_[v].empty(); }
  /// The triangles around a live vertex, in no particular but a repeatable order.
  const std::vector<Index>& fan(Index v) const { return fans_[v]; }
  const Tri& triangle(Index t) const { return triangles_[t]; }  ///< of kNone where it is gone
  Index triangle_end() const { return static_cast<Index>(triangles_.size()); }
  Vec3 normal(Index t) const;       ///< not unit: twice the area long
  std::vector<Edge> edges() const;  ///< every edge once, lower vertex first, by vertex
  bool has_edge(Edge e) const;

  /// Puts a vertex at p into the edge; two triangles more.
  Index split(Edge e, const SurfacePoint& p);
  /// Merges the edge into one vertex (e[0]) at p; two triangles less. False, and nothing changed, where the
  /// surface would pinch, get an edge longer than `longest`, or a triangle that faces away from its corners'
  /// normals: the cosine must not fall below `least_facing`, or not below what it was there.
  bool collapse(Edge e, const SurfacePoint& p, double least_facing, double longest);
  /// Turns the edge to join the two vertices across it. False, and nothing changed, where that would double
  /// an edge or turn a triangle away, as above.
  bool flip(Edge e, double least_facing);
  /// The least cosine between the triangles around v and their corners' normals, were v at p.
  double least_facing(Index v, const SurfacePoint& p) const;
  SurfacePoint at(Index v) const { return {positions_[v], normals_[v], true}; }

  /// The vertices across the edge: on the side where it runs e[0]→e[1], and on the other.
  std::array<Index, 2> across(Edge e) const;
  int valence(Index v) const { return static_cast<int>(fans_[v].size()); }

  /// The live part, renumbered in order.
  geometry::TriangleMesh take() const;

 private:
  Index side(Index from, Index to) const;  ///< the triangle in which the edge runs from→to, or kNone
  void replace(Index t, Index from, Index to);
  double facing(const Tri& t, Index v, const SurfacePoint& p) const;
  double fan_facing(Index v, Index ignored, const SurfacePoint& p) const;
  bool overstretches(Index v, Vec3 p, double longest) const;
  bool pinches(Edge e) const;

  std::vector<Vec3> positions_, normals_;
  std::vector<Tri> triangles_;  ///< dead ones hold kNone
  std::vector<std::vector<Index>> fans_;
  Index live_ = 0;
};

}  // namespace toile::mannequin
