#pragma once
// What a drape of a project would begin with: the pieces where they stand, and what the look at them finds.

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/base/result.h"
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
  explicit StartCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Of the project as it stands. Errors: those of reading it, pattern.*, mesh.*, placement.*.
  Result<std::shared_ptr<const StartView>> get(Store& store, const OwnerId& owner, const ProjectRow& project);
  std::size_t bytes() const;

 private:
  using Entry = std::pair<std::string, std::shared_ptr<const StartView>>;
  std::shared_ptr<const StartView> find(const std::string& key);
  void keep(std::string key, std::shared_ptr<const StartView> view);

  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // newest use first
  std::size_t bytes_ = 0;
};

/// The cache of this process. Files are named by their content, so that it serves any store.
StartCache& shared_starts();

}  // namespace toile
