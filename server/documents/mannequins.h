#pragma once
// The program's own figures, made once and kept for a while: a project is read at every change, and a figure
// takes half a second to make.

#include <cstddef>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/body/mannequin/mannequin.h"
#include "server/documents/recent_cache.h"

namespace toile {

/// Figures by what was asked for; those that were used longest ago go first. Thread-safe.
class MannequinCache {
 public:
  explicit MannequinCache(std::size_t most) : kept_(most) {}

  /// Errors: those of make_mannequin, which are not kept.
  Result<std::shared_ptr<const Mannequin>> get(const MannequinSettings& settings);
  std::size_t count() const { return kept_.size(); }

 private:
  RecentCache<Mannequin> kept_;
};

}  // namespace toile
