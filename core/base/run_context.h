#pragma once
// Long work takes a RunContext: it polls cancel and tells how far it is.

#include <atomic>
#include <functional>
#include <string_view>

namespace toile {

/// Where a long run is. `fraction` runs from 0 to 1 within the phase.
struct Progress {
  std::string_view phase;  ///< "mesh", "sew", "drape", …
  double fraction = 0;
};

struct RunContext {
  std::function<void(const Progress&)> on_progress;  ///< may be empty; called on the working thread
  const std::atomic<bool>* cancel = nullptr;         ///< may be null; set by any thread
  int threads = 1;                                   ///< that may work on it; no byte depends on how many

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  void progress(std::string_view phase, double fraction) const {
    if (on_progress) on_progress({phase, fraction});
  }
};

}  // namespace toile
