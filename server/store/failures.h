#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "core/base/result.h"

namespace toile::store {

/// How often a store failed for reasons of its own (its disk, its database), by the error's code: what an
/// operator is to see before users do. Thread-safe.
class Failures {
 public:
  /// Counts the error and gives it back.
  Error counted(Error error) {
    const std::lock_guard lock(mutex_);
    ++counts_[error.code];
    return error;
  }
  std::map<std::string, std::int64_t> counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::int64_t> counts_;
};

}  // namespace toile::store
