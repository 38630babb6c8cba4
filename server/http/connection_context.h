#pragma once
// What all connections of a server share. Internal to http.

#include <boost/asio/thread_pool.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "server/http/identify.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/http/server_settings.h"
#include "server/ws/session.h"

namespace toile::http {

class HttpSession;

/// Who is connected, so that a stop can tell them. Thread-safe.
class Connections {
 public:
  /// Whether one more of that address may come: when there are too many, of all or of the address, the one of
  /// them that has been idle longest is ended. `count` are connected.
  bool make_room(const std::string& address, int count, const ServerSettings& settings);
  /// False when the server is stopping.
  bool add(const std::shared_ptr<HttpSession>& session);
  void remove(const HttpSession* session);
  /// Asks everybody to come to an end; nobody may join any more.
  void stop_all();
  /// Those that did not come to an end. Nothing may run any more.
  void forget_all();
  std::size_t count() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<HttpSession>> sessions_;
  bool stopping_ = false;
};

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
