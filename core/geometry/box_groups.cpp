#include "core/geometry/box_groups.h"

#include <algorithm>
#include <numeric>

namespace toile::geometry {

BoxGroups::BoxGroups(std::span<const Box3> boxes) {
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  part_by_place(order, boxes, kSize, [&](std::span<const Index> members) {
    Group& group = groups_.emplace_back();
    std::fill(group.item, group.item + kSize, kNone);
    std::copy(members.begin(), members.end(), group.item);
    std::sort(group.item, group.item + members.size());  // the same on every library
  });
  group_of_.resize(boxes.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const Index box : groups_[g].item) {
      if (box != kNone) group_of_[box] = static_cast<Index>(g);
    }
  }
  around_.resize(groups_.size());
  refit_groups(boxes);
  tree_ = Bvh(around_);
}

void BoxGroups::refit(std::span<const Box3> boxes) {
  refit_groups(boxes);
  tree_.refit(around_);
}

void BoxGroups::refit(std::span<const Box3> boxes, std::span<const Index> changed) {
  std::vector<Index> groups;
  for (const Index box : changed) groups.push_back(group_of_[box]);
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  for (const Index g : groups) refit_group(g, boxes);
  tree_.refit(around_, groups);
}

std::vector<BoxGroups::Part> BoxGroups::parts(const BoxGroups& other, std::size_t least) const {
  std::vector<Part> parts;
  for (const Bvh::NodePair& below : tree_.parts(other.tree_, least)) parts.push_back({below});
  return parts;
}

std::vector<BoxGroups::Part> BoxGroups::self_parts(std::size_t least) const {
  std::vector<Part> parts;
  if (!groups_.empty()) parts.push_back({{}, 0, groups_.size()});
  for (const Bvh::NodePair& below : tree_.self_parts(least)) parts.push_back({below});
  return parts;
}

void BoxGroups::refit_group(Index g, std::span<const Box3> boxes) {
  // A place without a box holds the empty one, which overlaps none: lanes need no mask.
  const Box3 nothing;
  Group& group = groups_[g];
  group.around = nothing;
  for (int i = 0; i < kSize; ++i) {
    const Box3& box = group.item[i] == kNone ? nothing : boxes[group.item[i]];
    for (int k = 0; k < 3; ++k) {
      group.lo[k][i] = box.lo[k];
      group.hi[k][i] = box.hi[k];
    }
    group.around = join(group.around, box);
  }
  around_[g] = group.around;
}

void BoxGroups::refit_groups(std::span<const Box3> boxes) {
  for (std::size_t g = 0; g < groups_.size(); ++g) refit_group(static_cast<Index>(g), boxes);
}

}  // namespace toile::geometry
