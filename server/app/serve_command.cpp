#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/end_of_program.h"
#include "server/app/wiring.h"

namespace toile::app {
ExitCode serve_command(const ServeOptions& given) {
  const ServeOptions options = completed(given);
  ::umask(0077);  // what users upload and drape is for nobody else on this machine
  const sigset_t signals = hold_ending_signals(!options.tls_certificate.empty());
  Result<std::unique_ptr<Service>> service = Service::start(options);
  if (!service) return fail(service.error(), false);
  const bool six = options.address.find(':') != std::string::npos;
  const std::string host = six ? "[" + options.address + "]" : options.address;
  std::printf("Toile serves on %s://%s:%d/  (data in %s, drapes at once: %d; Ctrl-C ends it)\n",
              options.tls_certificate.empty() ? "http" : "https", host.c_str(), (*service)->port(),
              options.data.c_str(), options.workers);
  if ((*service)->has_accounts())
    std::printf("Only who has an account is let in (toile account, toile token).\n");
  if (options.web.empty()) std::printf("The page has not been built; the service answers under /api/v1.\n");
  std::fflush(stdout);
  wait_for_the_end(signals, [&] { (*service)->read_certificate_again(); });
  (*service)->log().info("stopping; running drapes go back to the queue");
  end_anyway_in(std::chrono::seconds(25), (*service)->log());
  (*service)->stop();
  return kDone;
}

}  // namespace toile::app
