#pragma once
// What all connections of a server share. Internal to http.

#include <boost/asio/thread_pool.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/base/log.h"
#include "server/accounts/gate.h"
#include "server/http/body_budget.h"
#include "server/http/connections.h"
#include "server/http/event_feed.h"
#include "server/http/fair_pool.h"
#include "server/http/guard.h"
#include "server/http/identify.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/http/server_settings.h"
#include "server/http/tls_files.h"
#include "server/ws/session.h"

namespace toile::http {

/// Threads for each kind of work.
class WorkPools {
 public:
  explicit WorkPools(const ServerSettings& settings)
      : store_(threads(settings.light_threads)),
        document_(threads(settings.light_threads)),
        submit_(threads(settings.submit_threads)),
        heavy_(threads(settings.heavy_threads), settings.most_waiting),
        upload_(threads(settings.heavy_threads), settings.most_waiting) {}
  boost::asio::thread_pool& store() { return store_; }
  /// For work that costs nobody a turn. REQUIRES that fair() has none for it.
  boost::asio::thread_pool& light(Work work) {
    if (work == Work::kSubmit) return submit_;
    return work == Work::kDocument ? document_ : store_;
  }
  /// For work that costs whoever asked for it; null for any other.
  FairPool* fair(Work work) {
    if (work == Work::kHeavy) return &heavy_;
    return work == Work::kUpload ? &upload_ : nullptr;
  }
  void join() {
    store_.join();
    document_.join();
    submit_.join();
    heavy_.join();
    upload_.join();
  }

 private:
  static std::size_t threads(int count) { return static_cast<std::size_t>(count); }
  boost::asio::thread_pool store_, document_, submit_;
  FairPool heavy_, upload_;
};

struct ConnectionContext {
  const Log& log;
  RequestIds& request_ids;
  const ServerSettings& settings;
  const Router& router;
  Metrics& metrics;
  WorkPools& pools;
  BodyBudget& budget;   ///< of requests
  BodyBudget& answers;  ///< that lie in memory
  Connections& connections;
  const ws::StreamServices& streams;
  FeedSeats& seats;
  Site site;
  std::string cookie;    ///< name of that of a session
  const TlsFiles* tls;   ///< null: plain HTTP
  accounts::Gate* gate;  ///< null: there are no accounts, and whoever comes is the single user
};

}  // namespace toile::http
