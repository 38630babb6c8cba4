#pragma once
// The program's own figures, made once and kept for a while: a project is read at every change, and a figure
// takes half a second to make.

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/body/mannequin.h"

namespace toile {

/// Figures by what was asked for; those that were used longest ago go first. Thread-safe.
class MannequinCache {
 public:
  explicit MannequinCache(std::size_t most) : most_(most) {}

  /// Errors: those of make_mannequin, which are not kept.
  Result<std::shared_ptr<const Mannequin>> get(const MannequinSettings& settings);
  std::size_t count() const;

 private:
  using Entry = std::pair<std::string, std::shared_ptr<const Mannequin>>;
  std::shared_ptr<const Mannequin> find(const std::string& key);

  const std::size_t most_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // newest use first
};

/// The cache of this process.
MannequinCache& shared_mannequins();

}  // namespace toile
