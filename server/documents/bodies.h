#pragma once
// Body meshes out of the store, read once and kept for a while: a project is read at every change and at
// every drape, and a scan takes a second to read.

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/body/mesh_import/import.h"
#include "server/documents/recent_cache.h"
#include "server/store/store.h"

namespace toile::documents {

/// Meshes by asset and settings; those that were used longest ago go first. Thread-safe.
class BodyCache {
 public:
  explicit BodyCache(std::size_t most_bytes, mesh_import::MeshImporter importer = {})
      : kept_(most_bytes), importer_(std::move(importer)) {}

  const mesh_import::MeshImporter& importer() const { return importer_; }

  /// The asset's mesh, mended, in metres, y up. Errors: store.not_found (whether or not somebody else has
  /// it), store.corrupt, documents.wrong_kind, mesh.* with the asset's name as place.
  Result<std::shared_ptr<const mesh_import::RepairedMesh>> mesh(store::Store& store,
                                                                const store::RequestContext& context,
                                                                const std::string& asset_id,
                                                                const mesh_import::MeshSettings& settings);
  /// Of the meshes held.
  std::size_t bytes() const { return kept_.size(); }

 private:
  RecentCache<mesh_import::RepairedMesh> kept_;
  const mesh_import::MeshImporter importer_;
};

}  // namespace toile::documents
