#pragma once
// A sequence of chances that a seed decides, the same everywhere: splitmix64 (Steele, Lea and Flood 2014).

#include <cmath>
#include <cstdint>

namespace toile::test {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double least, double most) { return least + (most - least) * unit(); }
  /// Every factor is as likely as every other. Rounded to float: exp and log differ between libraries in the
  /// last bit of a double, and a seed should mean the same garment everywhere.
  double log_between(double least, double most) {
    return static_cast<float>(std::exp(between(std::log(least), std::log(most))));
  }
  /// A whole number, both ends included.
  int whole(int least, int most) {
    return least + static_cast<int>(bits() % static_cast<std::uint64_t>(most - least + 1));
  }
  bool happens(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace toile::test
