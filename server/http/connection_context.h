#pragma once
// What all connections of a server share. Internal to http.

#include <boost/asio/thread_pool.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/log.h"
#include "server/http/identify.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/http/server_settings.h"
#include "server/ws/session.h"

namespace toile {

class HttpSession;

/// Who is connected, so that a stop can tell them. Thread-safe.
class Connections {
 public:
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

struct ConnectionContext {
  const Log& log;
  RequestIds& request_ids;
  const ServerSettings& settings;
  const Router& router;
  Metrics& metrics;
  boost::asio::thread_pool& light;
  boost::asio::thread_pool& heavy;
  BodyBudget& budget;
  Connections& connections;
  const StreamServices& streams;
};

}  // namespace toile
