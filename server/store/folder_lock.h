#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace toile::store {

/// Holds a folder against other processes (and other stores of this one) for as long as it lives. The system
/// lets go when the process dies, however it dies.
class FolderLock {
 public:
  /// Errors: store.open, store.in_use.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  FolderLock() = default;
  int fd_ = -1;
};

}  // namespace toile::store
