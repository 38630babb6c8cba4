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
#include "server/store/store.h"

namespace toile::http {

/// Of the processes that read strangers' meshes, since the start.
struct ReaderFigures {
  std::int64_t started = 0;
  std::int64_t crashed = 0;  ///< brought down by what they read
  std::int64_t refused = 0;  ///< ended for the time, memory or output that they took
};

/// What the rest of the service has to tell.
struct ServiceFigures {
  jobs::JobService::Counts jobs;
  store::StoreFigures store;
  ReaderFigures readers;
  std::size_t viewers = 0;
};

/// Of the certificate that is shown under TLS.
struct CertificateFigures {
  std::atomic<std::int64_t> expires_s{0};  ///< Unix time until which it is good; 0: there is none
  std::atomic<std::int64_t> renewed{0};    ///< how often another has taken its place since the start
  std::atomic<std::int64_t> refused{0};    ///< how often another could not be used
};

/// Thread-safe.
class Metrics {
 public:
  /// `code` is that of a problem, or empty.
  void count_request(const std::string& method, int status, const std::string& code, double seconds);

  std::atomic<int> connections{0};  ///< open now
  CertificateFigures certificate;

  std::string text(const ServiceFigures& service) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::pair<std::string, int>, std::uint64_t> requests_;  ///< by method and status
  std::map<std::string, std::uint64_t> problems_;                  ///< by code
  double seconds_ = 0;                                             ///< of all requests together
};

}  // namespace toile::http
