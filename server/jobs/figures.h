#pragma once
// Figures over many jobs, for whoever runs the service.

#include <array>
#include <cstddef>
#include <cstdint>

namespace toile::jobs {

/// How long things took.
class Histogram {
 public:
  static constexpr std::array<double, 10> kBounds{0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000, 3000};  ///< s

  void add(double seconds) {
    std::size_t bucket = 0;
    while (bucket < kBounds.size() && seconds > kBounds[bucket]) ++bucket;
    ++counts_[bucket];
    sum_ += seconds;
  }
  /// How many took no longer than kBounds[bucket], or, for one more than there are, at all.
  std::int64_t up_to(std::size_t bucket) const {
    std::int64_t count = 0;
    for (std::size_t i = 0; i <= bucket; ++i) count += counts_[i];
    return count;
  }
  std::int64_t count() const { return up_to(kBounds.size()); }
  double sum() const { return sum_; }  ///< s

 private:
  std::array<std::int64_t, kBounds.size() + 1> counts_{};
  double sum_ = 0;
};

}  // namespace toile::jobs
