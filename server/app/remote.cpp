#include "server/app/remote.h"

#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

namespace toile::app {
namespace {

constexpr json::JsonLimits kReplyLimits{.bytes = std::size_t{64} << 20, .depth = 64};

std::string percent_encoded(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '-' || c == '.' || c == '_' || c == '~';
    std::array<char, 8> escape{c, '\0'};
    if (!plain) std::snprintf(escape.data(), escape.size(), "%%%02X", static_cast<unsigned char>(c));
    out += escape.data();
  }
  return out;
}

/// The kinds by the first word of a code. Here text comes in from another program: it is read once, and
/// nothing behind this line looks at codes.
constexpr std::pair<std::string_view, ErrorKind> kKinds[] = {
    {"internal", ErrorKind::kInternal}, {"render.", ErrorKind::kInternal}, {"export.", ErrorKind::kInternal},
    {"store.", ErrorKind::kSystem},     {"jobs.", ErrorKind::kSystem},     {"server.", ErrorKind::kSystem}};

/// What the server says went wrong.
Error error_of(const http::HttpReply& reply) {
  const Result<json::JsonValue> tree = json::parse_json(reply.body, kReplyLimits);
  const std::string code = tree ? text_member(*tree, "code") : "";
  if (!code.empty()) return told_by_server(code, text_member(*tree, "detail"), text_member(*tree, "where"));
  return {"client.malformed",
          "the server answers with status " + std::to_string(reply.status) + " and no reason", "",
          ErrorKind::kSystem};
}

http::HttpClient::Request post(const std::string& target, const std::string& body, const std::string& type) {
  return {.method = "POST", .target = target, .body = body, .content_type = type, .headers = {}};
}

http::HttpClient::Request get(const std::string& target) {
  return {.method = "GET", .target = target, .body = {}, .content_type = {}, .headers = {}};
}

}  // namespace

std::string text_member(const json::JsonValue& object, std::string_view key) {
  const json::JsonValue* member = object.find(key);
  return member && member->text() ? *member->text() : std::string();
}

Error told_by_server(std::string code, std::string message, std::string where) {
  ErrorKind kind = ErrorKind::kInput;
  for (const auto& [room, its_kind] : kKinds) {
    if (code.starts_with(room)) kind = its_kind;
  }
  return {std::move(code), std::move(message), std::move(where), kind};
}

Result<std::string> Remote::text(http::HttpClient::Request request) {
  if (!token_.empty()) request.headers.emplace_back("Authorization", "Bearer " + token_);
  http::HttpReply reply = TRY(client_.ask(request));
  if (reply.status < 200 || reply.status > 299) return error_of(reply);
  return std::move(reply.body);
}

Result<json::JsonValue> Remote::json(const http::HttpClient::Request& request) {
  const std::string body = TRY(text(request));
  Result<json::JsonValue> tree = json::parse_json(body, kReplyLimits);
  if (tree) return tree;
  return Error{"client.malformed", "the server's answer is no JSON: " + tree.error().message, request.target,
               ErrorKind::kSystem};
}

Result<std::string> Remote::id_of(const http::HttpClient::Request& request) {
  const json::JsonValue made = TRY(json(request));
  std::string id = text_member(made, "id");
  if (!id.empty()) return id;
  return Error{"client.malformed", "the server's answer has no id", request.target, ErrorKind::kSystem};
}

Result<std::string> Remote::upload(const std::string& kind, const std::string& name,
                                   const std::string& bytes) {
  return id_of(post("/api/v1/assets?kind=" + kind + "&name=" + percent_encoded(name), bytes,
                    "application/octet-stream"));
}

Result<std::string> Remote::create_project(const std::string& document,
                                           const std::vector<std::pair<std::string, std::string>>& files) {
  std::vector<json::JsonMember> names;
  names.reserve(files.size());
  for (const auto& [name, id] : files) names.push_back({name, id});
  const std::string body =
      "{\"document\": " + document + ", \"files\": " + json::write_json_line(names) + "}";
  return id_of(post("/api/v1/projects", body, "application/json"));
}

Result<json::JsonValue> Remote::submit(const std::string& project_id, store::JobPriority priority) {
  http::HttpClient::Request request =
      post("/api/v1/jobs",
           json::write_json_line(std::vector<json::JsonMember>{
               {"project_id", project_id}, {"priority", std::string(store::name_of(priority))}}),
           "application/json");
  request.headers.emplace_back("Idempotency-Key", project_id);  // the project was made for this one drape
  return json(request);
}

Result<json::JsonValue> Remote::job(const std::string& id) { return json(get("/api/v1/jobs/" + id)); }

Result<json::JsonValue> Remote::cancel(const std::string& id) {
  return json(post("/api/v1/jobs/" + id + "/cancel", "", ""));
}

Result<std::string> Remote::result(const std::string& job_id, const std::string& name) {
  return text(get("/api/v1/jobs/" + job_id + "/results/" + percent_encoded(name)));
}

}  // namespace toile::app
