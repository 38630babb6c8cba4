#pragma once
// The service put together: store, hub, jobs and HTTP server, started and stopped in the right order.

#include <memory>

#include "core/base/log.h"
#include "core/base/result.h"
#include "server/app/config.h"
#include "server/documents/documents.h"
#include "server/http/handlers/api.h"
#include "server/http/server.h"
#include "server/jobs/job_stills.h"
#include "server/jobs/movies.h"
#include "server/jobs/retention.h"
#include "server/jobs/service.h"
#include "server/store/store.h"
#include "server/webhooks/deliverer.h"
#include "server/ws/hub.h"

namespace toile::app {

class Service {
 public:
  /// Opens the store, takes up what was left, serves; a new store without accounts gets the sample project
  /// and its drape. Errors: store.*, server.address, server.port.
  static Result<std::unique_ptr<Service>> start(const ServeOptions& options);
  ~Service();  ///< stops

  int port() const { return server_->port(); }
  /// Whether only who is known is let in.
  bool has_accounts() const { return doors_ != nullptr; }
  Log log() const { return Log(*job_log_); }
  /// HttpServer::read_certificate_again.
  void read_certificate_again() { server_->read_certificate_again(); }
  /// Takes no new work, lets running drapes go back to the queue, says good-bye to viewers. Twice is safe.
  void stop();

 private:
  Service() = default;

  // Destroyed from below: each of these works with what stands above it.
  std::unique_ptr<LogSink> log_sink_;
  std::unique_ptr<store::Store> store_;
  std::unique_ptr<LogSink> job_log_;  ///< log_sink_, and a file for each job
  std::unique_ptr<documents::Documents> documents_;
  std::unique_ptr<ws::Hub> hub_;
  std::unique_ptr<jobs::JobService> jobs_;
  std::unique_ptr<jobs::Movies> movies_;
  std::unique_ptr<jobs::JobStills> stills_;
  std::unique_ptr<jobs::Retention> retention_;
  std::unique_ptr<handlers::Doors> doors_;  ///< null: there are no accounts
  std::unique_ptr<handlers::LinkDoor> link_door_;
  std::unique_ptr<http::HttpServer> server_;
  std::unique_ptr<webhooks::Deliverer> deliverer_;
};

}  // namespace toile::app
