#pragma once
// The service as a program on the other side sees it: what `toile submit` asks for.

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "server/http/client.h"
#include "server/store/job_priority.h"

namespace toile::app {

/// Errors of all calls: those of HttpClient::ask, and what the server says (its code, message and place);
/// client.malformed when the answer lacks what it must have.
class Remote {
 public:
  /// `token`: by which the server knows who asks; empty: by none.
  explicit Remote(http::HttpClient client, std::string token = "")
      : client_(std::move(client)), token_(std::move(token)) {}

  /// The asset's id.
  Result<std::string> upload(const std::string& kind, const std::string& name, const std::string& bytes);
  /// The project's id. `files`: name in the document → asset id.
  Result<std::string> create_project(const std::string& document,
                                     const std::vector<std::pair<std::string, std::string>>& files);
  Result<json::JsonValue> submit(const std::string& project_id, store::JobPriority priority);
  Result<json::JsonValue> job(const std::string& id);
  Result<json::JsonValue> cancel(const std::string& id);
  Result<std::string> result(const std::string& job_id, const std::string& name);

 private:
  Result<std::string> text(http::HttpClient::Request request);
  Result<json::JsonValue> json(const http::HttpClient::Request& request);
  Result<std::string> id_of(const http::HttpClient::Request& request);

  http::HttpClient client_;
  std::string token_;
};

/// An error in the words of a server, which knows it by its code only.
Error told_by_server(std::string code, std::string message, std::string where);

/// A text member of a JSON object; empty when it is not there.
std::string text_member(const json::JsonValue& object, std::string_view key);

}  // namespace toile::app
