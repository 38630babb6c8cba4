#include "server/store/blobs.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "server/store/file_name.h"
#include "server/store/ids.h"

namespace toile::store {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHashDigits = 32;

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool ok() const { return fd_ >= 0; }

 private:
  int fd_;
};

/// What the system says (errno) about something done to a file. The folder is nobody's business but ours.
Error system_error(const fs::path& path, const char* deed) {
  const int reason = errno;
  if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG) {
    return {"store.full", "the disk has no room for this; free some and try again", "", ErrorKind::kNoRoom};
  }
  return {"store.failed",
          std::string("cannot ") + deed + " " + in_quotes(path.filename().string()) + ": " +
              std::generic_category().message(reason),
          "", ErrorKind::kSystem};
}

Status write_all(int fd, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return system_error(path, "write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

/// Writes a new file and waits until the disk has its bytes.
Status write_new(const fs::path& path, std::string_view bytes) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!file.ok()) return system_error(path, "make");
  TRY(write_all(file.get(), bytes, path));
  if (::fsync(file.get()) != 0) return system_error(path, "keep");
  return {};
}

/// The whole of a regular file; nothing is followed that is a link.
Result<std::string> read_all(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  struct stat about {};
  if (!file.ok() || ::fstat(file.get(), &about) != 0) return system_error(path, "read");
  std::string bytes(static_cast<std::size_t>(about.st_size), '\0');
  std::size_t had = 0;
  while (had < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + had, bytes.size() - had);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(path, "read");
    if (got == 0) break;
    had += static_cast<std::size_t>(got);
  }
  bytes.resize(had);
  return bytes;
}

/// When it was written last, Unix time.
std::int64_t ms_of(const struct stat& about) {
  return std::int64_t{about.st_mtim.tv_sec} * 1000 + about.st_mtim.tv_nsec / 1000000;
}

/// What lies in a folder and is of that type; links count as links.
std::vector<std::string> names_in(const fs::path& folder, fs::file_type type) {
  std::vector<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
    std::error_code unknown;
    if (at->symlink_status(unknown).type() == type) names.push_back(at->path().filename().string());
  }
  return names;
}

/// 32 hex digits and an ending.
bool is_blob(std::string_view name) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return name.size() > kHashDigits && name[kHashDigits] == '.' &&
         std::all_of(name.begin(), name.begin() + kHashDigits, is_digit);
}

/// Makes the folder when it is not there. Its name in the one above is durable then, whoever made it.
Status make_folder(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return system_error(folder, "make");
  return sync_folder(folder.parent_path());
}

}  // namespace

Status sync_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened.ok() || ::fsync(opened.get()) != 0) return system_error(folder, "keep");
  return {};
}

Result<Blobs> Blobs::open(const fs::path& folder, std::shared_ptr<Failures> failures, bool alone) {
  Blobs blobs(folder, std::move(failures));
  std::error_code failure;
  if (alone)
    fs::remove_all(blobs.scratch_folder(), failure);  // half-written files of a process that was killed
  for (const fs::path& part : {folder / "blobs", folder / "results", folder / "checkpoints",
                               blobs.log_folder(), blobs.scratch_folder()}) {
    TRY(make_folder(part));
  }
  return blobs;
}

/// 256 folders, so that none has too many names.
fs::path Blobs::place_of(const std::string& blob) const {
  return folder_ / "blobs" / blob.substr(0, 2) / blob;
}

Status Blobs::write(const fs::path& path, std::string_view bytes, const NamingGate& gate) const {
  static std::atomic<std::uint64_t> count{0};
  const fs::path temporary =
      scratch_folder() / ("write" + std::to_string(::getpid()) + "_" + std::to_string(count.fetch_add(1)));
  Status written = make_folder(path.parent_path());
  if (written) written = write_new(temporary, bytes);
  const Naming naming = [&]() -> Status {
    if (::rename(temporary.c_str(), path.c_str()) != 0) return system_error(path, "name");
    return {};
  };
  if (written) written = gate ? gate(naming) : naming();
  if (written) return sync_folder(path.parent_path());
  ::unlink(temporary.c_str());
  return written.error().kind == ErrorKind::kStale ? written.error() : failures_->counted(written.error());
}

Error Blobs::corrupt(const char* message, const std::string& what) const {
  return failures_->counted({"store.corrupt", message, what, ErrorKind::kSystem});
}

Result<std::string> Blobs::put_blob(std::string_view bytes, std::string_view file_name) const {
  const std::string hash = hash_of(bytes);
  const std::string blob = hash + ending_of(file_name);
  const Result<std::string> there = read_all(place_of(blob));
  // XXH3 is quick, but somebody may make two files for it; theirs must not become another's.
  if (there && *there != bytes && hash_of(std::string_view(*there)) == hash) {
    return Error{"store.hash_collision", "another file with other bytes has the same hash", "",
                 ErrorKind::kSystem};
  }
  if (there && *there == bytes) {
    // Its writer may have been killed, or be at it still, between giving the name and making it durable.
    const fs::path folder = place_of(blob).parent_path();
    TRY(make_folder(folder));
    TRY(sync_folder(folder));
    return blob;
  }
  TRY(write(place_of(blob), bytes));
  return blob;
}

Result<fs::path> Blobs::blob_path(const std::string& blob, std::int64_t size) const {
  std::error_code failure;
  const fs::path path = place_of(blob);
  const std::uintmax_t found = fs::file_size(path, failure);
  if (!failure && found == static_cast<std::uintmax_t>(size)) return path;
  return corrupt("a file of the store is gone or has another length; upload it again", blob);
}

Result<std::string> Blobs::blob(const std::string& blob, std::int64_t size) const {
  const fs::path path = TRY(blob_path(blob, size));
  Result<std::string> bytes = read_all(path);
  if (!bytes || hash_of(std::string_view(*bytes)) == blob.substr(0, kHashDigits)) return bytes;
  return corrupt("a file of the store has changed; upload it again", blob);
}

Status Blobs::put_result(const std::string& job_id, const std::string& name, std::string_view bytes,
                         const NamingGate& gate) const {
  TRY(check_name(name));
  return write(folder_ / "results" / job_id / name, bytes, gate);
}

Result<std::string> Blobs::result(const std::string& job_id, const std::string& name,
                                  const ResultFile& kept) const {
  const fs::path path = TRY(result_path(job_id, name));
  Result<std::string> bytes = read_all(path);
  if (!bytes || kept.hash.empty() || hash_of(std::string_view(*bytes)) == kept.hash) return bytes;
  return corrupt("a result has changed on the disk since it was kept; drape the project again", name);
}

Result<fs::path> Blobs::result_path(const std::string& job_id, const std::string& name) const {
  TRY(check_name(name));
  const fs::path path = folder_ / "results" / job_id / name;
  std::error_code failure;
  if (fs::is_regular_file(path, failure)) return path;
  return Error{"store.not_found", "the job has no result " + in_quotes(name), "", ErrorKind::kNotFound};
}

Status Blobs::share_result(const std::string& from, const std::string& to, const std::string& name) const {
  TRY(check_name(name));
  const fs::path source = folder_ / "results" / from / name, target = folder_ / "results" / to / name;
  TRY(make_folder(target.parent_path()));
  if (::link(source.c_str(), target.c_str()) == 0 || errno == EEXIST) return {};
  const std::string bytes = TRY(read_all(source));  // a file system that knows no second names
  return write(target, bytes);
}

Status Blobs::sync_results(const std::string& job_id) const {
  return sync_folder(folder_ / "results" / job_id);
}

Status Blobs::remove_results(const std::string& job_id) const {
  std::error_code failure;
  fs::remove_all(folder_ / "results" / job_id, failure);
  if (!failure) return {};
  return Error{"store.failed", "cannot remove the results: " + failure.message(), "", ErrorKind::kSystem};
}

std::vector<std::string> Blobs::blob_names() const {
  std::vector<std::string> blobs;
  for (const std::string& part : names_in(folder_ / "blobs", fs::file_type::directory)) {
    for (std::string& name : names_in(folder_ / "blobs" / part, fs::file_type::regular)) {
      if (is_blob(name) && name.starts_with(part)) blobs.push_back(std::move(name));
    }
  }
  return blobs;
}

std::vector<std::string> Blobs::jobs_with_results() const {
  std::vector<std::string> ids = names_in(folder_ / "results", fs::file_type::directory);
  std::erase_if(ids, [](const std::string& name) { return !is_id(name, 'j'); });
  return ids;
}

std::vector<std::string> Blobs::result_names(const std::string& job_id) const {
  return names_in(folder_ / "results" / job_id, fs::file_type::regular);
}

void Blobs::remove_blob(const std::string& blob) const {
  std::error_code ignored;
  fs::remove(place_of(blob), ignored);
}

void Blobs::remove_result(const std::string& job_id, const std::string& name) const {
  std::error_code ignored;
  fs::remove(folder_ / "results" / job_id / name, ignored);
}

Status Blobs::put_checkpoint(const std::string& job_id, std::string_view bytes,
                             const NamingGate& gate) const {
  return write(folder_ / "checkpoints" / job_id, bytes, gate);
}

std::int64_t Blobs::checkpoint_ms(const std::string& job_id) const {
  struct stat about {};
  return ::stat((folder_ / "checkpoints" / job_id).c_str(), &about) == 0 ? ms_of(about) : 0;
}

Result<Store::KeptCheckpoint> Blobs::checkpoint(const std::string& job_id) const {
  const fs::path path = folder_ / "checkpoints" / job_id;
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) {
    return Error{"store.not_found", "the job has no checkpoint", "", ErrorKind::kNotFound};
  }
  std::string bytes = TRY(read_all(path));
  return Store::KeptCheckpoint{std::move(bytes), ms_of(about)};
}

Status Blobs::remove_checkpoint(const std::string& job_id) const {
  const fs::path path = folder_ / "checkpoints" / job_id;
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return system_error(path, "remove");
  return {};
}

std::string Blobs::log(const std::string& job_id) const {
  Result<std::string> bytes = read_all(log_folder() / job_id);
  return bytes ? std::move(*bytes) : std::string();
}

void Blobs::remove_log(const std::string& job_id) const {
  std::error_code ignored;
  fs::remove(log_folder() / job_id, ignored);
}

std::vector<std::string> Blobs::jobs_with_logs() const {
  std::vector<std::string> ids = names_in(log_folder(), fs::file_type::regular);
  std::erase_if(ids, [](const std::string& name) { return !is_id(name, 'j'); });
  return ids;
}

void Blobs::keep_checkpoints_of(const std::set<std::string>& job_ids) const {
  std::error_code failure;
  std::vector<fs::path> left;
  for (fs::directory_iterator at(folder_ / "checkpoints", failure), end; !failure && at != end;
       at.increment(failure)) {
    if (!job_ids.contains(at->path().filename().string())) left.push_back(at->path());
  }
  for (const fs::path& path : left) fs::remove(path, failure);  // what stays is tried again next time
}

}  // namespace toile::store
