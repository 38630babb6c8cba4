#pragma once
// Asks a server over HTTP, one request after the other, and waits for each answer.

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace toile::http {

struct HttpReply {
  int status = 0;
  std::map<std::string, std::string> headers;  ///< names in lower case
  std::string body;
};

/// Not thread-safe.
class HttpClient {
 public:
  /// `url` is http://host:port, or https:// where the server must show a certificate that the PEM file
  /// `roots` vouches for, or without one this machine. Errors: client.url, client.tls. Nothing is connected
  /// yet.
  static Result<HttpClient> make(const std::string& url, const std::string& roots = "");
  HttpClient(HttpClient&&) noexcept;
  ~HttpClient();

  struct Request {
    std::string method = "GET";
    std::string target = "/";
    std::string body;
    std::string content_type;
    std::vector<std::pair<std::string, std::string>> headers;
    std::uint64_t most_reply_bytes = std::uint64_t{1} << 30;  ///< of the answer's body
  };
  /// Connects where need be; asks once more when a connection that was kept turns out to be closed and asking
  /// twice does no harm (GET, or with an Idempotency-Key). Errors: client.unreachable, client.cut_off,
  /// client.timeout, client.tls, client.malformed, client.failed (no memory for the answer).
  Result<HttpReply> ask(const Request& request, std::chrono::seconds within = std::chrono::seconds(120));

  /// Whether what is said can be read on the way: neither TLS nor the loopback.
  bool tells_others() const;
  /// From now on connects to addresses of the internet only (public_address.h), whatever names lead to; else
  /// asking ends with client.private_address.
  void keep_to_public();
  /// What is asked ends at once with client.given_up, and so does all later. From any thread.
  void give_up();

 private:
  struct Impl;
  explicit HttpClient(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace toile::http
