#pragma once
// How often a viewer's hand may be told of: a bucket of tokens, so that a burst after a hitch passes and a
// flood does not.

#include <algorithm>
#include <chrono>

namespace toile::ws {

class HandPace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kPerSecond = 60, kBurst = 60;

  /// Whether another one may come at this moment; moments do not go back.
  bool may(Clock::time_point now) {
    const std::chrono::duration<double> since = now - last_;
    tokens_ = std::min(kBurst, tokens_ + kPerSecond * since.count());
    last_ = now;
    if (tokens_ < 1) return false;
    tokens_ -= 1;
    return true;
  }

 private:
  double tokens_ = kBurst;
  Clock::time_point last_;
};

}  // namespace toile::ws
