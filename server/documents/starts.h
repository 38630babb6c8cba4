#pragma once
// What a drape of a project would begin with: the pieces where they stand, and what the look at them finds.

#include <cstddef>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "server/documents/recent_cache.h"
#include "server/store/store.h"

namespace toile {

struct StartView {
  /// {"ready", "findings": […], "pieces": [{"id", "low", "high", "by_hand"}]}: by_hand is what place_piece
  /// was asked, or null; ready when no error is among the findings; places in metres, after what could be
  /// repaired.
  std::string check;
  /// uint32 bytes of the topology, the topology as in frames.md (epoch 1), float32 x, y, z of each vertex
  /// (m). Little endian.
  std::string geometry;
};

/// Starts of documents; those that were used longest ago go first. Thread-safe.
class StartCache {
 public:
  explicit StartCache(std::size_t most_bytes) : kept_(most_bytes) {}

  /// Of the project as it stands. Errors: those of reading it, pattern.*, mesh.*, placement.*.
  Result<std::shared_ptr<const StartView>> get(Store& store, const OwnerId& owner, const ProjectRow& project);
  std::size_t bytes() const { return kept_.size(); }

 private:
  RecentCache<StartView> kept_;
};

/// The cache of this process. Files are named by their content, so that it serves any store.
StartCache& shared_starts();

}  // namespace toile
