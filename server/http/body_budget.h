#pragma once
// What bodies may take of the memory. Internal to http.

#include <atomic>
#include <cstddef>

#include "server/http/message.h"

namespace toile::http {

/// Bytes of bodies in memory. Thread-safe.
class BodyBudget {
 public:
  explicit BodyBudget(std::size_t most) : most_(most) {}
  bool take(std::size_t bytes) {
    std::size_t had = taken_.load();
    do {
      if (bytes > most_ - had) return false;
    } while (!taken_.compare_exchange_weak(had, had + bytes));
    return true;
  }
  void give_back(std::size_t bytes) { taken_ -= bytes; }

 private:
  const std::size_t most_;
  std::atomic<std::size_t> taken_{0};
};

/// Bytes taken of a budget, given back at the end.
class Taken {
 public:
  explicit Taken(BodyBudget& budget) : budget_(budget) {}
  ~Taken() { budget_.give_back(bytes_); }
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;
  /// Has `bytes` in all from now on; false, and as before, when the budget has not that much.
  bool have(std::size_t bytes) {
    if (bytes <= bytes_) return true;
    if (!budget_.take(bytes - bytes_)) return false;
    bytes_ = bytes;
    return true;
  }

 private:
  BodyBudget& budget_;
  std::size_t bytes_ = 0;
};

/// 503: what is answered where a budget is spent.
HttpResponse no_room();

}  // namespace toile::http
