#include "server/store/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace toile::store {

Result<FolderLock> FolderLock::open(const std::filesystem::path& folder, const char* name) {
  FolderLock lock;
  lock.fd_ = ::open((folder / name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock.fd_ >= 0) return lock;
  return Error{"store.open", "cannot write here: " + std::generic_category().message(errno), folder.string(),
               ErrorKind::kSystem};
}

Result<FolderLock> FolderLock::share(const std::filesystem::path& folder) {
  FolderLock lock = TRY(open(folder, "workers.lock"));
  lock.share_again();
  return lock;
}

bool FolderLock::try_alone() { return ::flock(fd_, LOCK_EX | LOCK_NB) == 0; }

void FolderLock::share_again() { ::flock(fd_, LOCK_SH); }

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  FolderLock lock = TRY(open(folder, "toile.lock"));
  if (::flock(lock.fd_, LOCK_EX | LOCK_NB) == 0) return lock;
  return Error{"store.in_use", "another toile has this folder open; stop it, or give this one its own",
               folder.string(), ErrorKind::kConflict};
}

FolderLock::FolderLock(FolderLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace toile::store
