#include "core/paper/height_sorted.h"

#include <numeric>

namespace toile::paper {

HeightSorted::HeightSorted(std::span<const geometry::Box3> boxes) : element_(boxes.size()) {
  std::iota(element_.begin(), element_.end(), 0);
  std::sort(element_.begin(), element_.end(), [&](Index i, Index j) {
    const float a = boxes[static_cast<std::size_t>(i)].lo[1], b = boxes[static_cast<std::size_t>(j)].lo[1];
    return a < b || (a == b && i < j);
  });
  low_.reserve(boxes.size());
  boxes_.reserve(boxes.size());
  for (const Index i : element_) {
    const geometry::Box3& box = boxes[static_cast<std::size_t>(i)];
    low_.push_back(box.lo[1]);
    boxes_.push_back(box);
    tallest_ = std::max(tallest_, box.hi[1] - box.lo[1]);
  }
  tallest_ += tallest_ * 1e-6f;  // the difference was rounded
}

}  // namespace toile::paper
