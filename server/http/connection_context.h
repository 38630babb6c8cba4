#pragma once
// What all connections of a server share. Internal to http.

#include <boost/asio/thread_pool.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "core/base/log.h"
#include "server/http/connections.h"
#include "server/http/identify.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/http/server_settings.h"
#include "server/ws/session.h"

namespace toile::http {

/// Bytes of bodies in memory. Thread-safe.
class BodyBudget {
 public:
  explicit BodyBudget(std::size_t most) : most_(most) {}
  bool take(std::size_t bytes) {
    std::size_t had = taken_.load();
    do {
      if (bytes > most_ - had) return false;
    } while (!taken_.compare_exchange_weak(had, had + bytes));
    return true;
  }
  void give_back(std::size_t bytes) { taken_ -= bytes; }

 private:
  const std::size_t most_;
  std::atomic<std::size_t> taken_{0};
};

/// Threads for each kind of work.
class WorkPools {
 public:
  WorkPools(int light, int heavy)
      : store_(threads(light)), document_(threads(light)), heavy_(threads(heavy)), upload_(threads(heavy)) {}
  boost::asio::thread_pool& of(Work work) {
    switch (work) {
      case Work::kStore:
        break;
      case Work::kDocument:
        return document_;
      case Work::kHeavy:
        return heavy_;
      case Work::kUpload:
        return upload_;
    }
    return store_;
  }
  void join() {
    for (boost::asio::thread_pool* pool : {&store_, &document_, &heavy_, &upload_}) pool->join();
  }

 private:
  static std::size_t threads(int count) { return static_cast<std::size_t>(count); }
  boost::asio::thread_pool store_, document_, heavy_, upload_;
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
};

}  // namespace toile::http
