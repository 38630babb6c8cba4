#pragma once
// "Sorting the elements with respect to their heights" (Kim and Park 2003): candidates for a collision lie in
// a band of heights.

#include <algorithm>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/geometry/bvh.h"

namespace toile::paper {

class HeightSorted {
 public:
  HeightSorted() = default;
  explicit HeightSorted(std::span<const geometry::Box3> boxes);

  /// Calls visit(element) for each box that overlaps `box`, in the order of their lower ends; equally high
  /// ones by their number.
  template <typename Visit>
  void query(const geometry::Box3& box, Visit&& visit) const {
    const float from = box.lo[1] - tallest_;
    auto k = static_cast<std::size_t>(std::lower_bound(low_.begin(), low_.end(), from) - low_.begin());
    for (; k < low_.size() && low_[k] <= box.hi[1]; ++k) {
      if (geometry::overlap(boxes_[k], box)) visit(element_[k]);
    }
  }

 private:
  std::vector<float> low_;  ///< m, the lower end of each box, rising
  std::vector<geometry::Box3> boxes_;
  std::vector<Index> element_;  ///< whose box it is
  float tallest_ = 0;           ///< m, of all boxes: how far below a band one may begin that reaches into it
};

}  // namespace toile::paper
