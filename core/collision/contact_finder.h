#pragma once
// Looks for all pairs of features that could meet and lists them: all over, or again at vertices that moved.

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/collision/contacts.h"
#include "core/collision/near_edges.h"
#include "core/collision/obstacle.h"
#include "core/collision/pair_measure.h"
#include "core/collision/surface.h"

namespace toile {
class Crew;
}

namespace toile::collision {

/// Finds contacts and bounds of a cloth among obstacles, over and over. The obstacles must outlive it.
class ContactFinder {
 public:
  ContactFinder(Surface cloth, std::span<const Obstacle> obstacles, ContactSettings settings);

  /// Measures at `positions` (m); `speeds` (m/s, one a vertex) size the trust regions. What comes out is the
  /// same whoever helps.
  void detect(std::span<const Vec3> positions, std::span<const double> speeds, Contacts& out, Crew& crew);
  void detect(std::span<const Vec3> positions, std::span<const double> speeds, Contacts& out);
  /// The same for pairs with a vertex of `moved` alone; the rest stays as it is. Costs what those have around
  /// them. REQUIRES `out` to be of this finder's last detection, or resumed, and kept by all positions.
  void detect_again(std::span<const Index> moved, std::span<const Vec3> positions,
                    std::span<const double> speeds, Contacts& out, Crew& crew);
  void detect_again(std::span<const Index> moved, std::span<const Vec3> positions,
                    std::span<const double> speeds, Contacts& out);
  /// Goes on with contacts of a finder like this one: centres, trust regions and lists.
  void resume(const Contacts& contacts);

 private:
  /// Edges and faces at each vertex, one list after the other.
  struct Around {
    std::vector<Index> first, item;
    std::span<const Index> of(Index v) const {
      return {item.data() + first[v], static_cast<std::size_t>(first[v + 1] - first[v])};
    }
  };
  template <typename Feature>
  static Around around_vertices(std::span<const Feature> features, Index vertex_count);

  double trust_radius(double speed) const;
  void lay_vertex_box(Index v, const Contacts& at);
  void lay_edge_line(Index e, const Contacts& at);
  void lay_all(const Contacts& at);
  void lay_moved(std::span<const Index> moved, const Contacts& at);

  /// A part of the look for pairs: what it visits goes into its own list.
  struct Find {
    FoundPairs found;
    std::vector<EdgePair> edge_pairs;  ///< with boxes that overlap
  };
  using Look = std::function<void(PairMeasure&, std::vector<EdgePair>&)>;

  void look_at_obstacles(std::size_t parts, std::vector<Look>& looks) const;
  void look_at_itself(std::size_t parts, std::vector<Look>& looks) const;
  void look_at_obstacles_from(std::span<const Index> moved, std::size_t parts,
                              std::vector<Look>& looks) const;
  void look_at_itself_from(std::span<const Index> moved, std::size_t parts, std::vector<Look>& looks) const;
  void do_all(const std::vector<Look>& looks, std::span<const Vec3> positions, Contacts& out, Crew& crew);
  void measure_edges_on(const Obstacle& obstacle, std::span<const EdgePair> pairs,
                        PairMeasure& measure) const;
  void measure_edges(std::span<const EdgePair> pairs, PairMeasure& measure) const;
  bool neighbours(Index vertex, const Tri& triangle) const;
  bool neighbouring_edges(Index e, Index f) const;

  Surface cloth_;
  std::span<const Obstacle> obstacles_;
  ContactSettings settings_;
  Around edges_at_, faces_at_;
  FeatureBoxes boxes_;
  std::vector<std::array<Index, 2>> edge_classes_;  ///< of the ends of each edge
  std::vector<EdgeLine> edge_lines_;                ///< between centres
  std::vector<Find> finds_;
  std::vector<char> moved_, touched_;  ///< marks of vertices
  std::vector<char> edge_moved_, face_moved_;
  std::vector<Index> moved_edges_, moved_faces_;
};

}  // namespace toile::collision
