#include "server/app/interrupt.h"

#include <csignal>

namespace toile::app {
namespace {

std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // else a signal handler may not touch it

void on_signal(int) { was_interrupted.store(true, std::memory_order_relaxed); }

}  // namespace

const std::atomic<bool>& cancel_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags =
      static_cast<int>(SA_RESETHAND) | SA_RESTART;  // the second signal meets the default: the end
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return was_interrupted;
}

}  // namespace toile::app
