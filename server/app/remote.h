#pragma once
// The service as a program on the other side sees it: what the verbs ask for that have it work for them.

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "server/http/client.h"
#include "server/store/job_priority.h"

namespace toile::app {

/// How a server is reached, and who asks.
struct RemoteOptions {
  std::string server = "http://127.0.0.1:8460";
  std::string roots;       ///< PEM file of who vouches for the server; empty: who does on this machine
  std::string token_file;  ///< path; empty: the environment's TOILE_TOKEN, if there is one
  double patience_s = 60;  ///< for how long a server that has answered before is waited for
};

/// Once the server has answered, a line that breaks or a server that starts anew is waited for, and what was
/// asked is asked again: nothing is done twice by it, since uploads are named by their contents and what
/// makes something brings an idempotency key. Errors of all calls: those of HttpClient::ask, and what the
/// server says (its code, message and place); client.malformed when the answer lacks what it must have.
class Remote {
 public:
  /// Errors: client.url, client.tls, usage.token, those of read_token.
  static Result<Remote> make(const RemoteOptions& options);

  /// The asset's id. Bytes that the server has are not sent again.
  Result<std::string> upload(const std::string& kind, const std::string& name, const std::string& bytes);
  /// The project's id. `files`: name in the document → asset id.
  Result<std::string> create_project(const std::string& document,
                                     const std::vector<std::pair<std::string, std::string>>& files);
  Result<json::JsonValue> submit(const std::string& project_id, store::JobPriority priority, bool pictures);
  /// `body` is that of POST /api/v1/sweeps.
  Result<json::JsonValue> submit_sweep(const json::JsonValue& body);
  /// What is at an address beneath /api/v1/, "jobs/j_…".
  Result<json::JsonValue> show(const std::string& what);
  Result<json::JsonValue> cancel(const std::string& what);
  /// The bytes of what is there.
  Result<std::string> fetch(const std::string& what);

 private:
  Remote(http::HttpClient client, std::string token, std::chrono::duration<double> patience)
      : client_(std::move(client)), token_(std::move(token)), patience_(patience) {}
  Result<http::HttpReply> ask(http::HttpClient::Request request);
  Result<std::string> text(const http::HttpClient::Request& request);
  Result<json::JsonValue> json(const http::HttpClient::Request& request);
  Result<std::string> id_of(const http::HttpClient::Request& request);

  http::HttpClient client_;
  std::string token_;
  std::chrono::duration<double> patience_;
  bool answered_ = false;  ///< there is a server
};

/// An error in the words of a server, which knows it by its code only.
Error told_by_server(std::string code, std::string message, std::string where);

/// `text` as one part of an address.
std::string percent_encoded(const std::string& text);

/// A text member of a JSON object; empty when it is not there.
std::string text_member(const json::JsonValue& object, std::string_view key);

}  // namespace toile::app
