#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/base/types.h"

namespace toile {

/// Numbers from 0 on, some of which are made one. The least member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) { reset(count); }

  /// Every number for itself; asks for memory only when there are more than ever before.
  void reset(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  /// One more, for itself.
  void add() { parent_.push_back(static_cast<Index>(parent_.size())); }

  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// False: they were one already.
  bool join(Index a, Index b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace toile
