#pragma once
// How much work putting on may cost.

#include <cstdint>

#include "core/base/types.h"

namespace toile::dressing {

/// Work is counted and not timed, so that a garment that cannot be put on is given up at the same place by
/// every machine. One unit is a vertex in one pass of the shape problem: about a microsecond.
class Effort {
 public:
  /// Garments that can be put on cost a tenth of it, huge ruffles half. Who asks for a check waits for all of
  /// it where nothing helps.
  static constexpr std::int64_t kMost = 24'000'000;

  Effort() = default;
  explicit Effort(std::int64_t most) : left_(most) {}

  void spend(Index vertices, std::int64_t passes) { left_ -= vertices * passes; }
  /// Half of what is left, for one thing that is tried before others.
  Effort half() const { return Effort(left_ / 2); }
  /// For one that is better than what this led to.
  Effort twice() const { return Effort(2 * left_); }
  /// What is left of this when `part` of it became `left`.
  Effort less(const Effort& part, const Effort& left) const {
    return Effort(left_ - part.left_ + left.left_);
  }
  /// What went from this until `left` was left.
  Effort spent_since(const Effort& left) const { return Effort(left_ - left.left_); }
  bool spent() const { return left_ <= 0; }

 private:
  std::int64_t left_ = kMost;
};

}  // namespace toile::dressing
