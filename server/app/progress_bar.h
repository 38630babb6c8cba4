#pragma once

#include <chrono>
#include <string>

#include "core/base/run_context.h"

namespace toile::app {

/// A bar on stderr for a person who waits; nothing at all when stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress);
  /// Wipes the bar off its line, so that other words may stand there.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_;
  Clock::time_point start_;
  Clock::time_point drawn_{};
  std::string phase_;
  bool visible_ = false;
};

}  // namespace toile::app
