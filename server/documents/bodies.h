#pragma once
// Body meshes out of the store, read once and kept for a while: a project is read at every change and at
// every drape, and a scan takes a second to read.

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"
#include "core/body/load_mesh.h"
#include "server/store/store.h"

namespace toile {

/// Meshes by asset and settings; those that were used longest ago go first. Thread-safe.
class BodyCache {
 public:
  explicit BodyCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// The asset's mesh, in metres, y up. Errors: store.not_found (whether or not somebody else has it),
  /// store.corrupt, documents.wrong_kind, mesh.* with the asset's name as place.
  Result<std::shared_ptr<const TriangleMesh>> mesh(Store& store, const OwnerId& owner,
                                                   const std::string& asset_id, const MeshSettings& settings);
  /// Of the meshes held.
  std::size_t bytes() const;

 private:
  using Entry = std::pair<std::string, std::shared_ptr<const TriangleMesh>>;
  std::shared_ptr<const TriangleMesh> find(const std::string& key);
  void keep(const std::string& key, std::shared_ptr<const TriangleMesh> mesh);

  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // newest use first
  std::map<std::string, std::list<Entry>::iterator> by_key_;
  std::size_t bytes_ = 0;
};

/// The cache of this process. Assets are named by their content, so that it serves any store.
BodyCache& shared_bodies();

/// Reads a mesh that is not in the store yet, through a file of its scratch folder. Errors: store.full,
/// documents.scratch, mesh.* with `name` as place.
Result<TriangleMesh> mesh_of_bytes(const Store& store, const std::string& name, std::string_view bytes);

}  // namespace toile
