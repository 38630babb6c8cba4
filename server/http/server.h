#pragma once
// The HTTP and WebSocket service on a port, plain or under TLS.

#include <atomic>
#include <memory>

#include "core/base/log.h"
#include "core/base/result.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/http/server_settings.h"
#include "server/jobs/service.h"
#include "server/store/store.h"
#include "server/ws/hub.h"

namespace toile::http {

class HttpServer {
 public:
  /// `store`, `jobs`, `hub` and the log's sink must outlive the server.
  HttpServer(store::Store& store, jobs::JobService& jobs, ws::Hub& hub, ServerSettings settings,
             const Log& log = {});
  ~HttpServer();  ///< stops

  /// Where routes are added, before start(). The page's files are there already.
  Router& router();
  const Metrics& metrics() const;
  /// False once the server drains.
  const std::atomic<bool>& ready() const;

  /// Opens the port and serves from threads of its own. Errors: server.address for one that is not of the
  /// loopback and may not be listened on (address_rules.h), server.port when it cannot be had, server.tls.
  Status start();
  /// From now on /readyz says no, so that nobody sends new work. The rest is answered as before.
  void drain();
  /// Takes up a certificate that has been renewed, for new connections; the one of before stays where the new
  /// cannot be used, and the log says why. It also looks by itself (ServerSettings::tls_look_every). From any
  /// thread, while it serves.
  void read_certificate_again();
  /// Says good-bye to viewers, ends all connections, joins the threads. Twice is safe.
  void stop();

  /// That was opened; REQUIRES a start that went well.
  int port() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace toile::http
