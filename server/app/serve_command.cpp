#include <pthread.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/wiring.h"

namespace toile::app {
namespace {

/// SIGINT and SIGTERM, held back from every thread that is made from now on.
sigset_t hold_ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  return signals;
}

/// Ends the process by then, whatever still runs in it: a picture or an arrangement cannot be broken off. The
/// store has all that it said it had, so that this costs no more than a crash.
void end_anyway_in(std::chrono::seconds time, const Log& log) {
  std::thread([time, log] {
    std::this_thread::sleep_for(time);
    log.warn("what still runs is cut off", LogFields{});
    std::_Exit(kDone);
  }).detach();
}

}  // namespace

ExitCode serve_command(const ServeOptions& given) {
  const ServeOptions options = completed(given);
  ::umask(0077);  // what users upload and drape is for nobody else on this machine
  const sigset_t signals = hold_ending_signals();
  Result<std::unique_ptr<Service>> service = Service::start(options);
  if (!service) return fail(service.error(), false);
  const bool six = options.address.find(':') != std::string::npos;
  const std::string host = six ? "[" + options.address + "]" : options.address;
  std::printf("Toile serves on http://%s:%d/  (data in %s, drapes at once: %d; Ctrl-C ends it)\n",
              host.c_str(), (*service)->port(), options.data.c_str(), options.workers);
  if (options.web.empty()) std::printf("The page has not been built; the service answers under /api/v1.\n");
  std::fflush(stdout);
  int signal = 0;
  sigwait(&signals, &signal);
  (*service)->log().info("stopping; running drapes go back to the queue");
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second signal ends at once
  end_anyway_in(std::chrono::seconds(25), (*service)->log());
  (*service)->stop();
  return kDone;
}

}  // namespace toile::app
