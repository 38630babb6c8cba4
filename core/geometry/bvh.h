#pragma once
// A bounding volume tree over boxes: built once, refitted while things move. Boxes are floats, rounded
// outwards, so that a query never misses; the tree's shape and the order of visits depend only on the input.

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "core/base/simd.h"
#include "core/base/types.h"

namespace toile::geometry {

/// An axis-aligned box. The default is empty. The fourth lanes fill a register and are always 0.
struct alignas(16) Box3 {
  float lo[4] = {1e30f, 1e30f, 1e30f, 0};
  float hi[4] = {-1e30f, -1e30f, -1e30f, 0};
  friend bool operator==(const Box3&, const Box3&) = default;
};

/// The box around points, grown by `margin` and by the rounding to float.
Box3 box_around(std::initializer_list<Vec3> points, double margin);

inline bool overlap(const Box3& a, const Box3& b) {
  return bits_of((floats_at(a.lo) <= floats_at(b.hi)) & (floats_at(b.lo) <= floats_at(a.hi))) == 15;
}
/// The least box that holds both.
inline Box3 join(const Box3& a, const Box3& b) {
  Box3 c;
  put(least(floats_at(a.lo), floats_at(b.lo)), c.lo);
  put(most(floats_at(a.hi), floats_at(b.hi)), c.hi);
  return c;
}

/// Parts primitives by their boxes' centres, in halves along the widest axis, until `most` or fewer are
/// together; calls emit(members) for each part, all but the last of exactly `most`, neighbours after one
/// another. `order` is rearranged.
void part_by_place(std::span<Index> order, std::span<const Box3> boxes, std::size_t most,
                   const std::function<void(std::span<const Index>)>& emit);

class Bvh {
 public:
  Bvh() = default;
  /// Median splits over the boxes' centres; leaves hold one primitive each.
  explicit Bvh(std::span<const Box3> boxes);

  /// New boxes for the same primitives; the tree keeps its shape.
  void refit(std::span<const Box3> boxes);
  /// The same where only `changed` have new ones.
  void refit(std::span<const Box3> boxes, std::span<const Index> changed);

  bool empty() const { return nodes_.empty(); }

  /// Calls visit(primitive) for each box that overlaps `box`.
  template <typename Visit>
  void query(const Box3& box, Visit&& visit) const {
    if (empty()) return;
    Index stack[kMaxDepth];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (!overlap(node.box, box)) continue;
      if (node.primitive != kNone) {
        visit(node.primitive);
      } else {
        const Index left = static_cast<Index>(&node - nodes_.data()) + 1;
        stack[top++] = node.right;
        stack[top++] = left;
      }
    }
  }

  /// Two nodes, of this tree and another, or both of this one; what is looked for below them.
  struct NodePair {
    Index mine = 0, theirs = 0;
    friend bool operator==(const NodePair&, const NodePair&) = default;
  };

  /// The look for pairs() in parts, about as many as `least` or more where there are so many: what
  /// pairs_below() visits for one after the other is what pairs() visits, in its order.
  std::vector<NodePair> parts(const Bvh& other, std::size_t least) const;
  /// The same for self_pairs().
  std::vector<NodePair> self_parts(std::size_t least) const;

  /// Calls visit(mine, theirs) for each pair of overlapping boxes of this tree and another.
  template <typename Visit>
  void pairs(const Bvh& other, Visit&& visit) const {
    if (empty() || other.empty()) return;
    pairs_below({}, other, visit);
  }

  template <typename Visit>
  void pairs_below(NodePair from, const Bvh& other, Visit&& visit) const {
    PairStack stack;
    stack.push(from.mine, from.theirs);
    while (stack.size > 0) {
      const auto [i, j] = stack.pop();
      const Node& a = nodes_[i];
      const Node& b = other.nodes_[j];
      if (!overlap(a.box, b.box)) continue;
      if (a.primitive != kNone && b.primitive != kNone) {
        visit(a.primitive, b.primitive);
      } else {
        descend(a, i, b, j, stack);
      }
    }
  }

  /// Calls visit(p, q) once for each unordered pair of different primitives whose boxes overlap.
  template <typename Visit>
  void self_pairs(Visit&& visit) const {
    if (empty()) return;
    self_pairs_below({}, visit);
  }

  template <typename Visit>
  void self_pairs_below(NodePair from, Visit&& visit) const {
    PairStack stack;
    stack.push(from.mine, from.theirs);
    while (stack.size > 0) {
      const auto [i, j] = stack.pop();
      const Node& a = nodes_[i];
      const Node& b = nodes_[j];
      if (i == j) {
        if (a.primitive != kNone) continue;
        stack.push(a.right, a.right);
        stack.push(i + 1, a.right);
        stack.push(i + 1, i + 1);
        continue;
      }
      if (!overlap(a.box, b.box)) continue;
      if (a.primitive != kNone && b.primitive != kNone) {
        visit(a.primitive, b.primitive);
      } else {
        descend(a, i, b, j, stack);
      }
    }
  }

 private:
  static constexpr int kMaxDepth = 128;  ///< median splits halve, so 64 levels hold any index

  struct Node {
    Box3 box;
    Index right = kNone;      ///< right child; the left one follows its parent
    Index primitive = kNone;  ///< of a leaf
    Index size = 1;           ///< primitives below
  };

  /// Pairs of nodes still to look at. A pair leaves at most two more than it takes, once a level of each
  /// tree.
  struct PairStack {
    std::pair<Index, Index> pairs[4 * kMaxDepth];
    int size = 0;
    void push(Index i, Index j) { pairs[size++] = {i, j}; }
    std::pair<Index, Index> pop() { return pairs[--size]; }
  };

  /// Puts the pairs below an overlapping pair of nodes on the stack: the larger node is parted. Not both are
  /// leaves.
  static void descend(const Node& a, Index i, const Node& b, Index j, PairStack& stack) {
    if (b.primitive != kNone || (a.primitive == kNone && a.size >= b.size)) {
      stack.push(a.right, j);
      stack.push(i + 1, j);
    } else {
      stack.push(i, b.right);
      stack.push(i, j + 1);
    }
  }

  std::vector<NodePair> below(NodePair pair, const Bvh& other) const;
  Index build(std::span<Index> order, std::span<const Box3> boxes);
  void note_ways_up();

  std::vector<Node> nodes_;     ///< parents before children
  std::vector<Index> parent_;   ///< of each node; none of the first
  std::vector<Index> leaf_of_;  ///< of each primitive
};

}  // namespace toile::geometry
