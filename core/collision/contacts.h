#pragma once
// What keeps cloth from going through: a list of every pair of features that could meet before they are
// measured again, and what it asks of each vertex. After Chen et al., "Offset Geometric Contact" (2025):
// a pair's certificate is the plane between its closest points, which each side may approach but not reach;
// a vertex's trust region covers all pairs that are not listed. Bounds limit the way from each vertex's
// centre, its place when it was measured last, not the move of one step, so they cannot add up. Vertices may
// have been measured at different times: a listed pair was measured when the later of its vertices was, and
// two features whose trust regions lie apart need no certificate, whenever they came there.

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile {
class Crew;
}

namespace toile::collision {

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
  Vec3 carried = {};  ///< m/s, of the solid there: friction goes by what the cloth moves against it
};

/// A half-space that a vertex stays in: n·(x − x0) ≥ −slack, x0 the centre. Less than 0 where a pair was
/// measured after its vertex and has taken the centre itself away.
struct DivisionPlane {
  Vec3 n;
  double slack = 0;
  Index pair = kNone;  ///< that asks for it
};

/// Two features that could meet, by their vertices of the cloth.
struct ListedPair {
  std::array<Index, 4> v{kNone, kNone, kNone, kNone};
  bool gone = false;  ///< one of them has been measured again
};

/// A vertex of the cloth on a triangle, of the cloth or of a solid.
struct VertexContact {
  Index pair = kNone;
  double gap = 0;       ///< m, when measured
  bool hidden = false;  ///< behind a nearer one on the same side
  Contact contact;
};

/// Triangles on points, edges on edges.
struct RimContact {
  Index pair = kNone;
  Contact contact;
};

/// What a look for pairs found, to be put into the lists of Contacts (Contacts::take). Pairs are numbered
/// from 0 on.
struct FoundPairs {
  struct Bound {
    Index vertex = kNone;
    DivisionPlane plane;
  };
  std::vector<ListedPair> pairs;
  std::vector<Bound> bounds;
  std::vector<VertexContact> vertex_contacts;  ///< each of the first vertex of its contact
  std::vector<RimContact> rims;
  double least_gap = 1;
  Index least_gap_vertex = kNone;

  void clear();
};

/// Valid while every vertex keeps its bounds.
struct Contacts {
  std::vector<Vec3> centre;          ///< x0
  std::vector<double> trust_radius;  ///< m, radius around x0
  std::vector<double>
      free_squared;  ///< m², of the ball around x0 that meets no bound; less than 0: none does
  std::vector<std::vector<DivisionPlane>> planes;  ///< of each vertex
  std::vector<Contact> contacts;                   ///< what is pushed apart
  double least_gap = 1;            ///< m, of all pairs when all were measured last; 1 when none came near
  Index least_gap_vertex = kNone;  ///< a vertex of that pair

  std::vector<ListedPair> pairs;
  std::vector<std::vector<VertexContact>> vertex_contacts;  ///< of each vertex
  std::vector<RimContact> rims;

  /// True when x is too near x0 to meet any bound: what most vertices are, most of the time.
  bool surely_inside(Index v, Vec3 x) const {
    const Vec3 d = x - centre[v];
    return dot(d, d) <= free_squared[v];
  }
  bool inside_trust_region(Index v, Vec3 x) const;
  bool inside_planes(Index v, Vec3 x) const;
  /// Largest t in [0, 1] such that from + t·(to − from) stays within the vertex's planes.
  double plane_reach(Index v, Vec3 from, Vec3 to) const;
  /// Where a vertex comes that wants to go to `to`: along the planes that it meets, up to the rim of its
  /// trust region. `from` must keep the bounds; so does what is returned.
  Vec3 reached(Index v, Vec3 from, Vec3 to) const;

  /// Empty lists for so many vertices.
  void clear(std::size_t vertex_count);
  /// Drops all pairs with a vertex that is marked in `moved` (1 a vertex), and marks in `touched` whose
  /// bounds or contacts change by that.
  void forget(std::span<const char> moved, std::span<char> touched);
  /// Puts found pairs behind those that are listed, and marks their vertices in `touched`.
  void take(const FoundPairs& found, std::span<char> touched);
  /// Bounds and contacts that follow from the lists, of the vertices marked in `touched`.
  void follow(std::span<const char> touched, Crew& crew);

 private:
  void drop_gone_pairs();
  void hide_behind_nearest(std::vector<VertexContact>& near) const;
};

}  // namespace toile::collision
