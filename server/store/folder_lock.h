#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace toile::store {

/// Holds a folder against other processes (and other stores of this one), or with them, for as long as it
/// lives. The system lets go when the process dies, however it dies.
class FolderLock {
 public:
  /// For the one server of a folder. Errors: store.open, store.in_use.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  /// For whoever works on its jobs, the server as well: any number. Waits while somebody has it alone. Error:
  /// store.open.
  static Result<FolderLock> share(const std::filesystem::path& folder);
  /// Has what it shares for itself until share_again(); false when others are there.
  bool try_alone();
  void share_again();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  FolderLock() = default;
  static Result<FolderLock> open(const std::filesystem::path& folder, const char* name);
  int fd_ = -1;
};

}  // namespace toile::store
