#pragma once
// How often somebody may be wrong.

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace toile::accounts {

/// Counts misses by name (an address, an account at an address) within a window of time. Bounded: of more
/// names than it holds, those whose window is over go, then the oldest. Thread-safe.
class Guesses {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Guesses(int most, std::chrono::seconds window = std::chrono::seconds(60),
                   std::size_t most_names = 4096)
      : most_(most), window_(window), most_names_(most_names) {}

  /// How long `name` has to wait before it may try again; 0: it may now.
  std::chrono::seconds wait(const std::string& name, Clock::time_point now = Clock::now()) const;
  /// It was wrong.
  void missed(const std::string& name, Clock::time_point now = Clock::now());
  /// It was right: what was missed is forgotten.
  void met(const std::string& name);

 private:
  struct Window {
    Clock::time_point began;
    int misses = 0;
  };
  void make_room(Clock::time_point now);

  const int most_;
  const std::chrono::seconds window_;
  const std::size_t most_names_;
  mutable std::mutex mutex_;
  std::map<std::string, Window> windows_;
};

/// What an address counts as: an IPv4 address as itself (also one that IPv6 maps), an IPv6 address as the 64
/// bits of its network, since its bearer has all the rest. Other text as itself.
std::string network_of(const std::string& address);

}  // namespace toile::accounts
