#pragma once
// The documents of one service: the store that keeps them, and what reading them lately gave. The functions
// of this room work on it, each for the owner of the context that it is called with.

#include <memory>
#include <vector>

#include "core/body/mesh_import/import.h"
#include "core/json/tree.h"
#include "server/documents/bodies.h"
#include "server/documents/mannequins.h"
#include "server/documents/recent_cache.h"
#include "server/store/store.h"

namespace toile::documents {

struct ReadCloth;
struct StartView;

/// Thread-safe. Whoever makes it owns its caches: two services in one process share nothing.
class Documents {
 public:
  /// `store` outlives it. `importer` reads the meshes of strangers: a server's does so in a process of its
  /// own.
  explicit Documents(store::Store& store, mesh_import::MeshImporter importer = {});
  ~Documents();
  Documents(const Documents&) = delete;
  Documents& operator=(const Documents&) = delete;

  store::Store& store() const { return store_; }
  const mesh_import::MeshImporter& importer() const { return bodies_.importer(); }
  BodyCache& bodies() { return bodies_; }
  MannequinCache& mannequins() { return mannequins_; }
  /// The members of figures, by mesh and wish (figures.h).
  RecentCache<std::vector<json::JsonMember>>& figures() { return figures_; }
  /// By owner, document and files (starts.h).
  RecentCache<StartView>& starts() { return starts_; }
  /// By owner, document and files (read_cloth.h).
  RecentCache<ReadCloth>& cloths() { return cloths_; }

 private:
  store::Store& store_;
  BodyCache bodies_;
  MannequinCache mannequins_;
  RecentCache<std::vector<json::JsonMember>> figures_;
  RecentCache<StartView> starts_;
  RecentCache<ReadCloth> cloths_;
};

}  // namespace toile::documents
