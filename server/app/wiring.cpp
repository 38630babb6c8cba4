#include "server/app/wiring.h"

#include <optional>
#include <string>
#include <utility>

#include "server/app/console.h"
#include "server/documents/projects.h"

namespace toile {
namespace {

/// The first thing that a newcomer sees: the sample, draped as an ordinary job. The key makes it one drape
/// however often the server starts; once the project has been removed there is nothing to do.
Status drape_sample(Store& store, JobService& jobs, const std::string& folder) {
  if (folder.empty()) return {};
  TRY(add_sample_project(store, kLocalOwner, folder));
  const Result<std::optional<std::string>> project = store.get_setting(kLocalOwner, kSampleSetting);
  if (!project) return project.error();
  if (!*project) return {};
  const Result<Made<JobRow>> job = jobs.submit(kLocalOwner, **project, "sample-first-drape");
  return job || job.error().kind == ErrorKind::kNotFound ? Status() : Status(job.error());
}

}  // namespace

Result<std::unique_ptr<Service>> Service::start(const ServeOptions& options) {
  std::unique_ptr<Service> service(new Service);
  std::unique_ptr<Store> store = TRY(open_sqlite_store(options.data));
  service->store_ = std::move(store);
  service->hub_ = std::make_unique<Hub>();
  JobServiceSettings jobs;
  jobs.workers = options.workers;
  jobs.checkpoint_every_s = options.checkpoint_every_s;
  service->jobs_ = make_job_service(*service->store_, *service->hub_, jobs);
  ServerSettings http;
  http.address = options.address;
  http.port = options.port;
  http.web = options.web;
  service->server_ = std::make_unique<HttpServer>(*service->store_, *service->jobs_, *service->hub_, http);
  TRY(service->server_->start());
  TRY(service->jobs_->start());
  if (Status sample = drape_sample(*service->store_, *service->jobs_, options.sample); !sample) {
    print_error(sample.error(), false);  // no reason not to serve
  }
  return service;
}

Service::~Service() { stop(); }

void Service::stop() {
  if (server_) server_->drain();
  if (jobs_) jobs_->stop();
  if (server_) server_->stop();
}

}  // namespace toile
