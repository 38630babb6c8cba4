#include "core/geometry/bvh.h"

#include <numeric>

#include "core/base/aabb.h"

namespace toile::geometry {

namespace {

/// Positions stay within a few metres, where a float is good to 0.5 µm; a micrometre covers the rounding.
constexpr double kRounding = 1e-6;

float centre2(const Box3& b, int axis) { return b.lo[axis] + b.hi[axis]; }

int widest_axis(std::span<const Index> order, std::span<const Box3> boxes) {
  float lo[3] = {1e30f, 1e30f, 1e30f}, hi[3] = {-1e30f, -1e30f, -1e30f};
  for (const Index p : order) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], centre2(boxes[p], k));
      hi[k] = std::max(hi[k], centre2(boxes[p], k));
    }
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  }
  return axis;
}

/// Puts the `left` lower ones along the widest axis first; where the others begin.
std::span<Index>::iterator part(std::span<Index> order, std::span<const Box3> boxes, std::size_t left) {
  const int axis = widest_axis(order, boxes);
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(left);
  std::nth_element(order.begin(), middle, order.end(), [&](Index p, Index q) {
    // nth_element and no sort: only the halves matter, and what is within them is parted again.
    const float a = centre2(boxes[p], axis), b = centre2(boxes[q], axis);
    return a != b ? a < b : p < q;  // ties by index: the tree is the same on every library
  });
  return middle;
}

/// Puts in each pair's place those that are looked at below it, until there are `least` or none is left to
/// part. `below(pair)` gives them, itself alone where it cannot be parted.
template <typename Below>
std::vector<Bvh::NodePair> parted(std::size_t least, const Below& below) {
  std::vector<Bvh::NodePair> parts{{}};
  bool any = true;
  while (any && parts.size() < least) {
    std::vector<Bvh::NodePair> next;
    any = false;
    for (const Bvh::NodePair& pair : parts) {
      const std::vector<Bvh::NodePair> smaller = below(pair);
      any |= smaller != std::vector{pair};
      next.insert(next.end(), smaller.begin(), smaller.end());
    }
    parts = std::move(next);
  }
  return parts;
}

}  // namespace

void part_by_place(std::span<Index> order, std::span<const Box3> boxes, std::size_t most,
                   const std::function<void(std::span<const Index>)>& emit) {
  if (order.empty()) return;
  if (order.size() <= most) return emit(order);
  // A whole number of parts to the left, so that all but the last are full.
  const std::size_t half = (order.size() / 2 + most - 1) / most * most;
  const auto middle = part(order, boxes, half);
  part_by_place({order.begin(), middle}, boxes, most, emit);
  part_by_place({middle, order.end()}, boxes, most, emit);
}

Box3 box_around(std::initializer_list<Vec3> points, double margin) {
  const auto [lo, hi] = bounding_box({points.begin(), points.size()});
  const double scale = std::max(
      {1.0, std::abs(lo.x), std::abs(lo.y), std::abs(lo.z), std::abs(hi.x), std::abs(hi.y), std::abs(hi.z)});
  const double m = margin + kRounding * scale;
  return {{static_cast<float>(lo.x - m), static_cast<float>(lo.y - m), static_cast<float>(lo.z - m), 0},
          {static_cast<float>(hi.x + m), static_cast<float>(hi.y + m), static_cast<float>(hi.z + m), 0}};
}

Bvh::Bvh(std::span<const Box3> boxes) {
  if (boxes.empty()) return;
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(2 * boxes.size());
  build(order, boxes);
  note_ways_up();
  refit(boxes);
}

void Bvh::note_ways_up() {
  parent_.assign(nodes_.size(), kNone);
  leaf_of_.assign((nodes_.size() + 1) / 2, kNone);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    const auto self = static_cast<Index>(i);
    if (node.primitive != kNone) {
      leaf_of_[node.primitive] = self;
    } else {
      parent_[self + 1] = parent_[node.right] = self;
    }
  }
}

Index Bvh::build(std::span<Index> order, std::span<const Box3> boxes) {
  const auto self = static_cast<Index>(nodes_.size());
  nodes_.emplace_back();
  nodes_[self].size = static_cast<Index>(order.size());
  if (order.size() == 1) {
    nodes_[self].primitive = order[0];
    return self;
  }
  const auto middle = part(order, boxes, order.size() / 2);
  build({order.begin(), middle}, boxes);
  const Index right = build({middle, order.end()}, boxes);
  nodes_[self].right = right;
  return self;
}

void Bvh::refit(std::span<const Box3> boxes) {
  // Backwards: children stand after their parents, and are joined before them.
  for (auto i = static_cast<Index>(nodes_.size()) - 1; i >= 0; --i) {
    Node& node = nodes_[i];
    node.box =
        node.primitive != kNone ? boxes[node.primitive] : join(nodes_[i + 1].box, nodes_[node.right].box);
  }
}

void Bvh::refit(std::span<const Box3> boxes, std::span<const Index> changed) {
  for (const Index p : changed) {
    Index i = leaf_of_[p];
    nodes_[i].box = boxes[p];
    while ((i = parent_[i]) != kNone) {
      const Box3 joined = join(nodes_[i + 1].box, nodes_[nodes_[i].right].box);
      if (joined == nodes_[i].box) break;  // nor do those above change
      nodes_[i].box = joined;
    }
  }
}

/// Below a pair of two nodes, in the order in which they are visited; none where their boxes lie apart.
std::vector<Bvh::NodePair> Bvh::below(NodePair pair, const Bvh& other) const {
  const Node& a = nodes_[pair.mine];
  const Node& b = other.nodes_[pair.theirs];
  if (!overlap(a.box, b.box)) return {};
  if (a.primitive != kNone && b.primitive != kNone) return {pair};
  PairStack stack;
  descend(a, pair.mine, b, pair.theirs, stack);
  std::vector<NodePair> parts;
  while (stack.size > 0) {
    const auto [i, j] = stack.pop();
    parts.push_back({i, j});
  }
  return parts;
}

std::vector<Bvh::NodePair> Bvh::parts(const Bvh& other, std::size_t least) const {
  if (empty() || other.empty()) return {};
  return parted(least, [&](NodePair pair) { return below(pair, other); });
}

std::vector<Bvh::NodePair> Bvh::self_parts(std::size_t least) const {
  if (empty()) return {};
  return parted(least, [&](NodePair pair) -> std::vector<NodePair> {
    if (pair.mine != pair.theirs) return below(pair, *this);
    const Node& node = nodes_[pair.mine];
    if (node.primitive != kNone) return {};
    const Index left = pair.mine + 1;
    return {{left, left}, {left, node.right}, {node.right, node.right}};
  });
}

}  // namespace toile::geometry
