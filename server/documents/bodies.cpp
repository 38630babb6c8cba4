#include "server/documents/bodies.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <system_error>

#include "server/store/file_name.h"

namespace toile {
namespace {

/// Some hundred mannequins, or a few scans.
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

std::size_t bytes_of(const TriangleMesh& mesh) {
  return mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * sizeof(Tri);
}

std::string key_of(const std::string& asset_id, const MeshSettings& settings) {
  std::array<char, 32> unit;
  const auto end = std::to_chars(unit.data(), unit.data() + unit.size(), settings.unit_in_m).ptr;
  return asset_id + (settings.z_up ? " z " : " y ") + std::string(unit.data(), end);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// load_mesh of a stranger's file, with the name that they know in place of where the file lies here.
Result<TriangleMesh> load_named(const std::string& path, const std::string& name, MeshSettings settings) {
  settings.alone = true;
  Result<TriangleMesh> mesh = load_mesh(path, settings);
  if (mesh) return mesh;
  const Error& error = mesh.error();
  return Error{error.code, replaced(error.message, path, name), replaced(error.where, path, name)};
}

/// A file that is gone when this is.
class ScratchFile {
 public:
  static Result<ScratchFile> write(const std::string& folder, const std::string& ending,
                                   std::string_view bytes) {
    ScratchFile file;
    file.path_ = folder + "/meshXXXXXX" + ending;
    const int fd = ::mkostemps(file.path_.data(), static_cast<int>(ending.size()), O_CLOEXEC);
    if (fd < 0) return file.failure();
    file.made_ = true;
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) break;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    const int reason = errno;
    ::close(fd);
    errno = reason;
    if (!bytes.empty()) return file.failure();
    return file;
  }
  ScratchFile(ScratchFile&& other) noexcept
      : path_(std::move(other.path_)), made_(std::exchange(other.made_, false)) {}
  ScratchFile& operator=(ScratchFile&&) = delete;
  ~ScratchFile() {
    if (made_) ::unlink(path_.c_str());
  }
  const std::string& path() const { return path_; }

 private:
  ScratchFile() = default;
  static Error failure() {
    const int reason = errno;
    if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG) {
      return {"store.full", "the disk has no room for this; free some and try again", ""};
    }
    return {"documents.scratch",
            "cannot write to the scratch folder: " + std::generic_category().message(reason), ""};
  }
  std::string path_;
  bool made_ = false;
};

}  // namespace

Result<std::shared_ptr<const TriangleMesh>> BodyCache::mesh(Store& store, const OwnerId& owner,
                                                            const std::string& asset_id,
                                                            const MeshSettings& settings) {
  const Result<AssetRow> asset = store.asset(owner, asset_id);  // first of all: is it theirs?
  if (!asset) return asset.error();
  if (asset->kind != "body") {
    return Error{"documents.wrong_kind", "this file is a " + asset->kind + ", and a body is wanted",
                 asset->name};
  }
  const std::string key = key_of(asset_id, settings);
  if (std::shared_ptr<const TriangleMesh> kept = find(key)) return kept;
  const Result<std::string> path = store.asset_path(owner, asset_id);
  if (!path) return path.error();
  Result<TriangleMesh> read = load_named(*path, asset->name, settings);
  if (!read) return read.error();
  auto made = std::make_shared<const TriangleMesh>(std::move(*read));
  keep(key, made);
  return std::shared_ptr<const TriangleMesh>(std::move(made));
}

std::shared_ptr<const TriangleMesh> BodyCache::find(const std::string& key) {
  const std::lock_guard hold(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->second;
}

void BodyCache::keep(const std::string& key, std::shared_ptr<const TriangleMesh> mesh) {
  const std::lock_guard hold(mutex_);
  if (by_key_.contains(key) || bytes_of(*mesh) > most_bytes_) return;
  bytes_ += bytes_of(*mesh);
  entries_.emplace_front(key, std::move(mesh));
  by_key_[key] = entries_.begin();
  while (bytes_ > most_bytes_) {
    bytes_ -= bytes_of(*entries_.back().second);
    by_key_.erase(entries_.back().first);
    entries_.pop_back();
  }
}

std::size_t BodyCache::bytes() const {
  const std::lock_guard hold(mutex_);
  return bytes_;
}

BodyCache& shared_bodies() {
  static BodyCache cache(kMostBytes);
  return cache;
}

Result<TriangleMesh> mesh_of_bytes(const Store& store, const std::string& name, std::string_view bytes) {
  const std::string ending = ending_of(name);
  const Result<ScratchFile> file = ScratchFile::write(store.scratch_folder(), ending, bytes);
  if (!file) return file.error();
  return load_named(file->path(), name, {});
}

}  // namespace toile
