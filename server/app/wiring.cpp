#include "server/app/wiring.h"

#include <optional>
#include <string>
#include <utility>

#include "server/app/engine_id.h"
#include "server/app/mesh_reader.h"
#include "server/documents/projects.h"
#include "server/http/handlers/routes.h"
#include "server/http/identify.h"
#include "server/log/job_log.h"
#include "server/log/stderr_sink.h"
#include "server/store/sqlite/open.h"

namespace toile::app {
namespace {

/// Once there is an account, nobody gets in without one: not even where the option was forgotten.
Result<bool> wants_accounts(store::Store& store, const ServeOptions& options) {
  if (options.accounts || store.accounts() == nullptr) return options.accounts;
  const std::vector<store::AccountRow> known = TRY(store.accounts()->accounts());
  return !known.empty();
}

/// The first thing that a newcomer sees: the sample, draped as an ordinary job. The key makes it one drape
/// however often the server starts; once the project has been removed there is nothing to do.
Status drape_sample(documents::Documents& documents, jobs::JobService& jobs,
                    const store::RequestContext& context, const std::string& folder) {
  if (folder.empty()) return {};
  TRY(documents::add_sample_project(documents, context, folder));
  const std::optional<std::string> project =
      TRY(documents.store().get_setting(context, documents::kSampleSetting));
  if (!project) return {};
  const Result<store::Made<store::JobRow>> job =
      jobs.submit(context, *project, "sample-first-drape", store::JobPriority::kInteractive);
  return job || job.error().kind == ErrorKind::kNotFound ? Status() : Status(job.error());
}

}  // namespace

Result<std::unique_ptr<Service>> Service::start(const ServeOptions& options) {
  std::unique_ptr<Service> service(new Service);
  service->log_sink_ = log::make_stderr_sink(options.log.value_or(log::LogFormat::kText));
  std::unique_ptr<store::Store> store = TRY(sqlite::open_sqlite_store(options.data, options.quotas));
  service->store_ = std::move(store);
  service->job_log_ = log::make_job_log(*service->log_sink_, service->store_->log_folder());
  const Log log = service->log();
  service->documents_ = std::make_unique<documents::Documents>(*service->store_, own_mesh_importer());
  service->hub_ = std::make_unique<ws::Hub>();
  jobs::JobServiceSettings jobs;
  jobs.workers = options.workers;
  jobs.checkpoint_every_s = options.checkpoint_every_s;
  jobs.limits = options.limits;
  jobs.engine = engine_of_this_program();
  service->jobs_ = jobs::make_job_service(*service->documents_, *service->hub_, jobs, log);
  service->movies_ = std::make_unique<jobs::Movies>(*service->store_);
  service->stills_ = std::make_unique<jobs::JobStills>(*service->store_);
  http::ServerSettings http;
  http.address = options.address;
  http.container = options.container;
  http.tls_certificate = options.tls_certificate;
  http.tls_key = options.tls_key;
  http.behind_proxy = options.behind_proxy;
  http.port = options.port;
  http.web = options.web;
  const bool accounts = TRY(wants_accounts(*service->store_, options));
  if (accounts) {
    service->doors_ =
        std::make_unique<handlers::Doors>(*service->store_->accounts(), http::cookie_name(http.secure()));
    http.gate = &service->doors_->gate;
  }
  service->link_door_ =
      std::make_unique<handlers::LinkDoor>(*service->store_->links(), accounts, http.secure());
  http.links = &service->link_door_->gate;
  service->server_ =
      std::make_unique<http::HttpServer>(*service->store_, *service->jobs_, *service->hub_, http, log);
  http::HttpServer& server = *service->server_;
  handlers::add_routes(
      server.router(),
      {*service->documents_, *service->store_, *service->jobs_, *service->movies_, *service->stills_,
       *service->hub_, server.metrics(), server.ready(), service->doors_.get(), service->link_door_.get()});
  TRY(server.start());
  TRY(service->jobs_->start());
  service->retention_ =
      std::make_unique<jobs::Retention>(*service->store_, *service->jobs_, options.retention, log);
  webhooks::DeliverySettings telling;
  telling.to_private = options.webhooks_to_private;
  service->deliverer_ =
      std::make_unique<webhooks::Deliverer>(*store::webhooks_of(*service->store_), telling, log);
  if (accounts) return service;
  const store::RequestContext local = http::local_user("", log);
  if (Status sample = drape_sample(*service->documents_, *service->jobs_, local, options.sample); !sample) {
    log.warn("sample not draped", sample.error());  // no reason not to serve
  }
  return service;
}

Service::~Service() { stop(); }

void Service::stop() {
  if (server_) server_->drain();
  deliverer_.reset();
  retention_.reset();
  if (movies_) movies_->stop();
  if (stills_) stills_->stop();
  if (jobs_) jobs_->stop();
  if (server_) server_->stop();
}

}  // namespace toile::app
