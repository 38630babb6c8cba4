#include "server/store/holders.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <random>
#include <system_error>
#include <utility>

namespace toile::store {
namespace {

namespace fs = std::filesystem;

/// "h_" and 16 hex digits of chance.
std::string new_id() {
  std::random_device chance;
  char text[24];
  std::snprintf(text, sizeof text, "h_%08x%08x", static_cast<unsigned>(chance()),
                static_cast<unsigned>(chance()));
  return text;
}

}  // namespace

Result<Holder> Holder::join(const fs::path& folder) {
  Holder holder;
  holder.folder_ = folder / "holders";
  std::error_code failure;
  fs::create_directories(holder.folder_, failure);
  holder.id_ = new_id();
  const fs::path file = holder.folder_ / holder.id_;
  holder.fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (holder.fd_ >= 0 && ::flock(holder.fd_, LOCK_EX | LOCK_NB) == 0) return holder;
  return Error{"store.open", "cannot write here: " + std::generic_category().message(errno),
               holder.folder_.string(), ErrorKind::kSystem};
}

Holder::Holder(Holder&& other) noexcept
    : folder_(std::move(other.folder_)), id_(std::move(other.id_)), fd_(std::exchange(other.fd_, -1)) {}

Holder::~Holder() {
  if (fd_ < 0) return;
  ::unlink((folder_ / id_).c_str());
  ::close(fd_);
}

bool Holder::is_gone(const std::string& id) const {
  if (id == id_) return false;
  if (id.find('/') != std::string::npos) return true;  // no name of ours
  const int fd = ::open((folder_ / id).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) return errno == ENOENT;
  const bool gone = ::flock(fd, LOCK_SH | LOCK_NB) == 0;
  ::close(fd);
  return gone;
}

void Holder::sweep() const {
  std::error_code failure;
  for (fs::directory_iterator at(folder_, failure), end; !failure && at != end; at.increment(failure)) {
    std::error_code ignored;
    if (is_gone(at->path().filename().string())) fs::remove(at->path(), ignored);
  }
}

}  // namespace toile::store
