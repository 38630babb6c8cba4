#include <sys/stat.h>

#include <cstdio>
#include <memory>

#include "server/app/commands.h"
#include "server/app/config.h"
#include "server/app/console.h"
#include "server/app/end_of_program.h"
#include "server/app/engine_id.h"
#include "server/app/mesh_reader.h"
#include "server/documents/documents.h"
#include "server/jobs/service.h"
#include "server/log/job_log.h"
#include "server/log/stderr_sink.h"
#include "server/store/sqlite/open.h"

namespace toile::app {
namespace {

/// Viewers are with the server, which learns from the store how far a drape is.
class NobodyLooksOn final : public jobs::Publisher {
 public:
  void topology(const std::string&, std::shared_ptr<const jobs::StreamTopology>) override {}
  void frame(const std::string&, std::shared_ptr<const jobs::StreamFrame>) override {}
  void progress(const std::string&, const jobs::JobProgress&) override {}
  void ended(const std::string&, const jobs::JobProgress&) override {}
};

jobs::JobServiceSettings settings_of(const WorkerOptions& options) {
  jobs::JobServiceSettings settings;
  settings.workers = options.workers > 0 ? options.workers : usual_workers();
  settings.checkpoint_every_s = options.checkpoint_every_s;
  settings.limits = options.limits;
  settings.engine = engine_of_this_program();
  return settings;
}

}  // namespace

ExitCode worker_command(const WorkerOptions& options) {
  ::umask(0077);
  const sigset_t signals = hold_ending_signals();
  const std::unique_ptr<LogSink> sink = log::make_stderr_sink(options.log.value_or(usual_log()));
  const Result<std::unique_ptr<store::Store>> store = sqlite::join_sqlite_store(options.store);
  if (!store) return fail(store.error(), false);
  const std::unique_ptr<LogSink> job_log = log::make_job_log(*sink, (*store)->log_folder());
  const Log log(*job_log);
  documents::Documents documents(**store, own_mesh_importer());
  NobodyLooksOn nobody;
  const jobs::JobServiceSettings settings = settings_of(options);
  const std::unique_ptr<jobs::JobService> jobs = jobs::make_job_service(documents, nobody, settings, log);
  if (Status started = jobs->start(); !started) return fail(started.error(), false);
  std::printf("Toile works on the jobs of %s (drapes at once: %d; Ctrl-C ends it)\n", options.store.c_str(),
              settings.workers);
  std::fflush(stdout);
  wait_for_the_end(signals);
  log.info("stopping; running drapes go back to the queue");
  end_anyway_in(std::chrono::seconds(25), log);
  jobs->stop();
  return kDone;
}

}  // namespace toile::app
