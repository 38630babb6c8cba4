#pragma once
// Figures of the server for /metrics, in the text format that Prometheus reads.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "server/jobs/service.h"

namespace toile::http {

/// Thread-safe.
class Metrics {
 public:
  void count_request(const std::string& method, int status, double seconds);

  std::atomic<int> connections{0};  ///< open now

  std::string text(const jobs::JobService::Counts& jobs, std::size_t viewers) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::pair<std::string, int>, std::uint64_t> requests_;  ///< by method and status
  double seconds_ = 0;                                             ///< of all requests together
};

}  // namespace toile::http
