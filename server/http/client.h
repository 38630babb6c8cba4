#pragma once
// Asks a server over HTTP, one request after the other, and waits for each answer.

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace toile {

struct HttpReply {
  int status = 0;
  std::map<std::string, std::string> headers;  ///< names in lower case
  std::string body;
};

/// Not thread-safe.
class HttpClient {
 public:
  /// `url` is http://host:port. Error: client.url. Nothing is connected yet.
  static Result<HttpClient> make(const std::string& url);
  HttpClient(HttpClient&&) noexcept;
  ~HttpClient();

  struct Request {
    std::string method = "GET";
    std::string target = "/";
    std::string body;
    std::string content_type;
    std::vector<std::pair<std::string, std::string>> headers;
  };
  /// Connects where need be; asks once more when a connection that was kept turns out to be closed and asking
  /// twice does no harm (GET, or with an Idempotency-Key). Errors: client.unreachable, client.timeout,
  /// client.malformed, client.failed (no memory for the answer).
  Result<HttpReply> ask(const Request& request, std::chrono::seconds within = std::chrono::seconds(120));

 private:
  struct Impl;
  explicit HttpClient(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace toile
