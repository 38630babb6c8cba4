#pragma once

#include <algorithm>
#include <thread>

#include "core/base/run_context.h"

namespace toile {

/// For work that somebody waits for: on as many threads as the machine runs at once.
inline RunContext on_all_processors() {
  RunContext context;
  context.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return context;
}

}  // namespace toile
