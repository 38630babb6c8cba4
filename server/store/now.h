#pragma once
// The clock that rows go by.

#include <chrono>
#include <cstdint>

namespace toile::store {

/// Now, as Unix time.
inline std::int64_t now_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace toile::store
