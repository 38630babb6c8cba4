#pragma once
// Boxes in groups of eight neighbours, under a bounding volume tree: what contact asks, over and over, for
// all pairs of boxes that overlap. Groups keep the tree small, and within two groups boxes are compared four
// at a time.

#include <bit>
#include <span>
#include <vector>

#include "core/base/simd.h"
#include "core/base/types.h"
#include "core/geometry/bvh.h"

namespace toile::geometry {

class BoxGroups {
 public:
  BoxGroups() = default;
  /// Groups and tree follow the boxes' places now and keep their shape from then on.
  explicit BoxGroups(std::span<const Box3> boxes);

  /// New boxes for the same primitives.
  void refit(std::span<const Box3> boxes);
  /// The same where only `changed` have new ones.
  void refit(std::span<const Box3> boxes, std::span<const Index> changed);

  bool empty() const { return groups_.empty(); }

  /// Calls visit(item) for each box that overlaps `box`.
  template <typename Visit>
  void query(const Box3& box, Visit&& visit) const {
    tree_.query(box, [&](Index g) {
      for (unsigned hits = lanes_in(box, groups_[g]); hits != 0; hits &= hits - 1)
        visit(groups_[g].item[std::countr_zero(hits)]);
    });
  }

  /// Calls visit(mine, theirs) for each pair of overlapping boxes of this and another.
  template <typename Visit>
  void pairs(const BoxGroups& other, Visit&& visit) const {
    tree_.pairs(other.tree_, [&](Index g, Index h) { between(groups_[g], other.groups_[h], visit); });
  }

  /// Calls visit(p, q) once for each unordered pair of different boxes that overlap.
  template <typename Visit>
  void self_pairs(Visit&& visit) const {
    for (const Group& g : groups_) within(g, visit);
    tree_.self_pairs([&](Index g, Index h) { between(groups_[g], groups_[h], visit); });
  }

  /// A part of the look for pairs: below two nodes, or within a row of groups.
  struct Part {
    Bvh::NodePair below;
    std::size_t first = 0, last = 0;  ///< groups; none where it is below nodes
  };

  /// The look for pairs() in parts, about `least` or more where there are so many. What they visit, part
  /// after part, is what pairs() visits, in its order.
  std::vector<Part> parts(const BoxGroups& other, std::size_t least) const;
  template <typename Visit>
  void pairs_in(const Part& part, const BoxGroups& other, Visit&& visit) const {
    tree_.pairs_below(part.below, other.tree_,
                      [&](Index g, Index h) { between(groups_[g], other.groups_[h], visit); });
  }

  /// The same for self_pairs().
  std::vector<Part> self_parts(std::size_t least) const;
  template <typename Visit>
  void self_pairs_in(const Part& part, Visit&& visit) const {
    if (part.first < part.last) {
      for (std::size_t g = part.first; g < part.last; ++g) within(groups_[g], visit);
      return;
    }
    tree_.self_pairs_below(part.below, [&](Index g, Index h) { between(groups_[g], groups_[h], visit); });
  }

 private:
  static constexpr int kSize = 8;

  /// Boxes side by side; places without a box hold an empty one.
  struct alignas(16) Group {
    float lo[3][kSize], hi[3][kSize];
    Index item[kSize];
    Box3 around;
  };

  /// The lanes of `g` that overlap the box lo, hi, as bits.
  static unsigned lanes_in(const float (&lo)[3], const float (&hi)[3], const Group& g);
  static unsigned lanes_in(const Group& one, int lane, const Group& g) {
    return lanes_in({one.lo[0][lane], one.lo[1][lane], one.lo[2][lane]},
                    {one.hi[0][lane], one.hi[1][lane], one.hi[2][lane]}, g);
  }
  static unsigned lanes_in(const Box3& box, const Group& g) {
    return lanes_in({box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}, g);
  }

  void refit_group(Index g, std::span<const Box3> boxes);
  void refit_groups(std::span<const Box3> boxes);

  template <typename Visit>
  static void between(const Group& a, const Group& b, Visit& visit) {
    for (unsigned rows = lanes_in(b.around, a); rows != 0; rows &= rows - 1) {
      const int i = std::countr_zero(rows);
      for (unsigned hits = lanes_in(a, i, b); hits != 0; hits &= hits - 1)
        visit(a.item[i], b.item[std::countr_zero(hits)]);
    }
  }

  template <typename Visit>
  static void within(const Group& g, Visit& visit) {
    for (int i = 0; i + 1 < kSize; ++i) {
      for (unsigned hits = lanes_in(g, i, g) & (~0u << (i + 1)); hits != 0; hits &= hits - 1)
        visit(g.item[i], g.item[std::countr_zero(hits)]);
    }
  }

  std::vector<Group> groups_;
  std::vector<Index> group_of_;  ///< of each box
  std::vector<Box3> around_;     ///< of each group, for the tree
  Bvh tree_;
};

inline unsigned BoxGroups::lanes_in(const float (&lo)[3], const float (&hi)[3], const Group& g) {
  Flags4 near{-1, -1, -1, -1}, far = near;  // all set: the first and the last four boxes
  for (int k = 0; k < 3; ++k) {
    const Floats4 low = four_of(lo[k]), high = four_of(hi[k]);
    near &= (floats_at(g.lo[k]) <= high) & (low <= floats_at(g.hi[k]));
    far &= (floats_at(g.lo[k] + 4) <= high) & (low <= floats_at(g.hi[k] + 4));
  }
  return bits_of(near) | bits_of(far) << 4;
}

}  // namespace toile::geometry
