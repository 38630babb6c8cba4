#include "server/documents/bodies.h"

#include <array>
#include <charconv>

namespace toile {
namespace {

/// Some hundred mannequins, or a few scans.
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

std::size_t bytes_of(const RepairedMesh& kept) {
  const TriangleMesh& mesh = kept.mesh;
  return mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * sizeof(Tri);
}

std::string key_of(const std::string& asset_id, const MeshSettings& settings) {
  std::array<char, 32> unit;
  const auto end = std::to_chars(unit.data(), unit.data() + unit.size(), settings.unit_in_m).ptr;
  return asset_id + (settings.z_up ? " z " : " y ") + std::string(unit.data(), end);
}

}  // namespace

Result<std::shared_ptr<const RepairedMesh>> BodyCache::mesh(Store& store, const OwnerId& owner,
                                                            const std::string& asset_id,
                                                            const MeshSettings& settings) {
  const Result<AssetRow> asset = store.asset(owner, asset_id);  // first of all: is it theirs?
  if (!asset) return asset.error();
  if (asset->kind != "body") {
    return Error{"documents.wrong_kind", "this file is a " + asset->kind + ", and a body is wanted",
                 asset->name};
  }
  const std::string key = key_of(asset_id, settings);
  if (std::shared_ptr<const RepairedMesh> kept = find(key)) return kept;
  const Result<std::string> path = store.asset_path(owner, asset_id);
  if (!path) return path.error();
  Result<RepairedMesh> read = importer_.stored(*path, asset->name, settings);
  if (!read) return read.error();
  auto made = std::make_shared<const RepairedMesh>(std::move(*read));
  keep(key, made);
  return std::shared_ptr<const RepairedMesh>(std::move(made));
}

std::shared_ptr<const RepairedMesh> BodyCache::find(const std::string& key) {
  const std::lock_guard hold(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->second;
}

void BodyCache::keep(const std::string& key, std::shared_ptr<const RepairedMesh> mesh) {
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

}  // namespace toile
