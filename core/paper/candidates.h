#pragma once
// Which triangles a particle may strike. Found by height, and kept while no particle has left the box that it
// was looked up with: cloth that hardly moves is hardly looked up. What is kept is never too little, so when
// it was made changes nothing in a drape.

#include <span>
#include <vector>

#include "core/geometry/bvh.h"
#include "core/paper/height_sorted.h"
#include "core/paper/particles.h"
#include "core/paper/solids.h"

namespace toile::paper {

class Candidates {
 public:
  /// Both must outlive it.
  Candidates(const Particles& particles, const Solids& solids);

  /// Needed before each look: the particles go from `before` to `now` (m).
  void cover(std::span<const Vec3> before, std::span<const Vec3> now);

  /// Triangles of bodies near the particle's path.
  std::span<const Index> solids(Index particle) const { return near_solids_.of(particle); }
  /// Triangles of cloth near it, but for those that the particle belongs to, or what it is sewn to.
  std::span<const Index> cloth(Index particle) const { return near_cloth_.of(particle); }

 private:
  struct Lists {
    std::vector<Index> first, all;
    std::span<const Index> of(Index i) const {
      return {all.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i])};
    }
    void clear();
    void end_one() { first.push_back(static_cast<Index>(all.size())); }
  };

  bool covered(std::span<const Vec3> before, std::span<const Vec3> now) const;
  bool belongs_to(Index particle, const Tri& triangle) const;

  const Particles& particles_;
  HeightSorted sorted_solids_;
  std::vector<geometry::Box3> kept_;  ///< of each particle
  Lists near_solids_, near_cloth_;
};

}  // namespace toile::paper
