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

namespace toile {

struct StartView;

/// Thread-safe. Whoever makes it owns its caches: two services in one process share nothing.
class Documents {
 public:
  /// `store` outlives it. `importer` reads the meshes of strangers: a server's does so in a process of its
  /// own.
  explicit Documents(Store& store, MeshImporter importer = {});
  ~Documents();
  Documents(const Documents&) = delete;
  Documents& operator=(const Documents&) = delete;

  Store& store() const { return store_; }
  const MeshImporter& importer() const { return bodies_.importer(); }
  BodyCache& bodies() { return bodies_; }
  MannequinCache& mannequins() { return mannequins_; }
  /// The members of figures, by mesh and wish (figures.h).
  RecentCache<std::vector<JsonMember>>& figures() { return figures_; }
  /// By owner, document and files (starts.h).
  RecentCache<StartView>& starts() { return starts_; }

 private:
  Store& store_;
  BodyCache bodies_;
  MannequinCache mannequins_;
  RecentCache<std::vector<JsonMember>> figures_;
  RecentCache<StartView> starts_;
};

}  // namespace toile
