#pragma once
// Constrained Delaunay triangulation of points on an integer grid: incremental insertion with Lawson's
// flips (C. L. Lawson, "Software for C1 surface interpolation", 1977); constraints by flipping the edges
// they cross (S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993).

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/grid_predicates.h"

namespace toile::mesh {

/// Why a constraint could not be laid, and where.
struct GridConflict {
  enum class Kind {
    kSamePlace,  ///< two points coincide: vertices a and b
    kTouch,      ///< vertex a lies on the constraint that starts at vertex b
    kCross,      ///< constraint starting at a crosses one that ends or starts at b
    kNotClosed,  ///< the constraints do not part inside from outside; a lies on a faulty one
    kOutside,    ///< the link that starts at a does not lie inside
  };
  Kind kind;
  Index a = kNone, b = kNone;
};

class GridTriangulation {
 public:
  /// Takes the points; build() triangulates. All within 0 … kGridExtent in x and y.
  explicit GridTriangulation(std::vector<GridPoint> points);
  static constexpr std::int64_t kGridExtent = std::int64_t{1} << 27;

  /// Triangulates all points, forces `constraints` (directed, inside to their left) to be edges, and finds
  /// what lies inside. `links` become edges as well, but bound nothing: they run through the inside. Call
  /// once.
  std::optional<GridConflict> build(std::span<const std::array<Index, 2>> constraints,
                                    std::span<const std::array<Index, 2>> links = {});

  const GridPoint& point(Index v) const { return points_[v]; }
  /// Moves a vertex if all triangles around it stay counter-clockwise; says whether it did. Flips that make
  /// the mesh Delaunay again wait for restore_delaunay.
  bool move(Index v, const GridPoint& to);
  void restore_delaunay();

  /// The triangles between the constraints, counter-clockwise.
  std::vector<Tri> inside_triangles() const;

  /// Triangles walked through in search of points, and edges flipped, since the beginning: what it all costs.
  std::size_t work() const { return work_; }

  /// Calls f(b, c) for each triangle (v, b, c) around v, counter-clockwise. v must not be a border vertex of
  /// the hull; every given point qualifies.
  template <typename F>
  void for_star(Index v, F&& f) const {
    const Index start = triangle_of_[v];
    Index t = start;
    do {
      const int i = corner_of(t, v);
      f(triangles_[t].v[(i + 1) % 3], triangles_[t].v[(i + 2) % 3]);
      t = triangles_[t].next[(i + 1) % 3];
    } while (t != start);
  }

 private:
  struct Triangle {
    Tri v;                          ///< counter-clockwise
    Tri next{kNone, kNone, kNone};  ///< neighbour across the edge opposite corner i
    std::array<bool, 3> fixed{};    ///< that edge is a constraint
    bool inside = false;
  };
  struct Side {
    Index triangle;
    int corner;  ///< the edge opposite it
  };

  int corner_of(Index t, Index v) const {
    const Tri& c = triangles_[t].v;
    return c[0] == v ? 0 : c[1] == v ? 1 : 2;
  }
  std::int64_t orient(Index a, Index b, Index c) const {
    return orientation(points_[a], points_[b], points_[c]);
  }
  void add_frame();
  Index locate(const GridPoint& p, Index from);
  std::optional<GridConflict> insert(Index v);
  void relink(Index t, Index from, Index to);
  void flip(Index t, int corner);
  void legalize();
  bool should_flip(Index t, int corner) const;
  std::optional<GridConflict> lay(Index a, Index b);
  std::optional<GridConflict> lay_links(std::span<const std::array<Index, 2>> links);
  std::optional<GridConflict> crossed_edges(Index a, Index b,
                                            std::vector<std::array<Index, 2>>& crossed) const;
  std::optional<Side> find_edge(Index a, Index b) const;
  void fix(Side side);
  bool is_convex(Side side) const;
  std::optional<GridConflict> mark_inside(std::span<const std::array<Index, 2>> constraints);

  Index count_;  ///< of the given points; the three frame points follow
  std::vector<GridPoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<Index> triangle_of_;  ///< some triangle at each vertex
  std::vector<Side> suspects_;      ///< edges that may have to be flipped
  Index last_ = 0;                  ///< triangle made last, where the next search starts
  std::size_t work_ = 0;
};

}  // namespace toile::mesh
