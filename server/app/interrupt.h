#pragma once

#include <atomic>

namespace toile::app {

/// From now on the first Ctrl-C (or SIGTERM) raises the flag that is returned, for work to end in good order;
/// the second ends the program at once.
const std::atomic<bool>& cancel_on_interrupt();

}  // namespace toile::app
