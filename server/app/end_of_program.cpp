#include "server/app/end_of_program.h"

#include <pthread.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "server/app/exit_code.h"

namespace toile::app {

sigset_t hold_ending_signals(bool hang_up) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  if (hang_up) sigaddset(&signals, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  return signals;
}

void end_anyway_in(std::chrono::seconds time, const Log& log) {
  std::thread([time, log] {
    std::this_thread::sleep_for(time);
    log.warn("what still runs is cut off", LogFields{});
    std::_Exit(kDone);
  }).detach();
}

void wait_for_the_end(const sigset_t& signals, const OnHangUp& on_hang_up) {
  int signal = 0;
  while (sigwait(&signals, &signal) == 0 && signal == SIGHUP) on_hang_up();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace toile::app
