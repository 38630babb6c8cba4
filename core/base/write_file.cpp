#include "core/base/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace toile {
namespace {

Error write_error(const std::filesystem::path& path, const char* act, int reason) {
  return {"export.write",
          std::string("cannot ") + act + " the file: " + std::generic_category().message(reason),
          path.string(), ErrorKind::kInternal};
}

/// A name beside `path` (a rename across file systems would copy), unlike that of any other writer.
std::string temporary_name(const std::filesystem::path& path) {
  static std::atomic<unsigned> count{0};
  return path.string() + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(count.fetch_add(1));
}

/// 0, or the errno that stopped it.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;  // EINVAL: a file system that cannot sync
}

}  // namespace

Status write_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::string temporary = temporary_name(path);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return write_error(path, "create", errno);
  int reason = write_all(file, bytes);
  if (::close(file) != 0 && reason == 0) reason = errno;  // some file systems report a full disk here
  if (reason != 0) {
    ::unlink(temporary.c_str());
    return write_error(path, "write", reason);
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0) {
    reason = errno;
    ::unlink(temporary.c_str());
    return write_error(path, "put in place", reason);
  }
  return {};
}

}  // namespace toile
