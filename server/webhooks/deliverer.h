#pragma once
// Tells webhooks what has become of jobs, on threads of its own. What is to be told stands in the store, so
// that it is told after a restart as well; a crash between telling and writing it down tells it twice.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/base/log.h"
#include "server/http/client.h"
#include "server/store/webhooks.h"
#include "server/webhooks/attempt.h"

namespace toile::webhooks {

struct DeliverySettings {
  bool to_private = false;         ///< also to addresses that are not of the internet (http/public_address.h)
  std::string roots;               ///< PEM file of whom to believe; empty: whom this machine does
  std::chrono::seconds within{8};  ///< to connect, and again for the answer
  std::chrono::milliseconds look_every{500};  ///< into the store
  std::vector<std::int64_t> waits_ms = usual_waits();
  int threads = 4;
};

/// One delivery of an owner at a time, so that nobody's slow address holds up others. Redirections are not
/// followed.
class Deliverer {
 public:
  /// `store` outlives it.
  Deliverer(store::Webhooks& store, DeliverySettings settings, const Log& log);
  ~Deliverer();  ///< breaks off what is under way, which is told after the next start
  Deliverer(const Deliverer&) = delete;
  Deliverer& operator=(const Deliverer&) = delete;

 private:
  void work();
  std::optional<store::DueDelivery> next();
  Result<int> tell(const store::DueDelivery& due);
  Result<int> ask(http::HttpClient& client, const http::HttpClient::Request& request);
  void keep(std::unique_lock<std::mutex>& lock, const store::DeliveryRow& row);

  store::Webhooks& store_;
  const DeliverySettings settings_;
  const Log log_;
  std::mutex mutex_;
  std::condition_variable bell_;
  std::set<store::OwnerId> busy_;  ///< owners of what is under way
  std::set<http::HttpClient*> asking_;
  bool stopping_ = false;
  std::vector<std::thread> threads_;  // last: they use all of the above
};

}  // namespace toile::webhooks
