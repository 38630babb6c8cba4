#include "server/http/message.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace toile::http {
namespace {

std::string value_of(const std::map<std::string, std::string>& map, const std::string& key) {
  const auto found = map.find(key);
  return found == map.end() ? std::string() : found->second;
}

}  // namespace

std::string HttpRequest::header(const std::string& lower_name) const { return value_of(headers, lower_name); }
std::string HttpRequest::parameter(const std::string& name) const { return value_of(query, name); }

std::shared_ptr<const AnswerFile> AnswerFile::open(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (fd < 0) return nullptr;
  struct stat about {};
  const bool regular = ::fstat(fd, &about) == 0 && S_ISREG(about.st_mode);
  std::shared_ptr<const AnswerFile> file(
      new AnswerFile(fd, regular ? static_cast<std::uint64_t>(about.st_size) : 0));
  return regular ? file : nullptr;
}

AnswerFile::~AnswerFile() { ::close(fd_); }

std::string AnswerFile::read(std::uint64_t at, std::size_t most) const {
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(most, size_ - std::min(at, size_))),
                    '\0');
  ssize_t got = 0;
  do {
    got = ::pread(fd_, bytes.data(), bytes.size(), static_cast<off_t>(at));
  } while (got < 0 && errno == EINTR);
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return bytes;
}

}  // namespace toile::http
