#include "server/app/remote.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <thread>
#include <utility>

#include "server/accounts/secrets.h"
#include "server/app/read_token.h"
#include "server/store/ids.h"

namespace toile::app {
namespace {

constexpr json::JsonLimits kReplyLimits{.bytes = std::size_t{64} << 20, .depth = 64};

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

/// With a key of its own, under which the server does it once.
http::HttpClient::Request once(http::HttpClient::Request request) {
  request.headers.emplace_back("Idempotency-Key", accounts::new_secret());
  return request;
}

constexpr int kUnavailable = 503;  // it starts, stops, or has no room just now

}  // namespace

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

Result<Remote> Remote::make(const RemoteOptions& options) {
  http::HttpClient client = TRY(http::HttpClient::make(options.server, options.roots));
  std::string token = TRY(read_token(options.token_file));
  if (!token.empty() && client.tells_others()) {
    return Error{"usage.token",
                 "a token goes to other machines by https only, or everybody on the way has it",
                 options.server};
  }
  return Remote(std::move(client), std::move(token), std::chrono::duration<double>(options.patience_s));
}

/// What is asked must be good to be asked twice.
Result<http::HttpReply> Remote::ask(http::HttpClient::Request request) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kFirstWait = std::chrono::milliseconds(100), kLongestWait = std::chrono::milliseconds(2000);
  if (!token_.empty()) request.headers.emplace_back("Authorization", "Bearer " + token_);
  const Clock::time_point began = Clock::now();
  for (auto wait = kFirstWait;; wait = std::min(2 * wait, kLongestWait)) {
    Result<http::HttpReply> reply = client_.ask(request);
    const bool away = reply ? reply->status == kUnavailable : reply.error().kind == ErrorKind::kUnavailable;
    if (reply && !away) answered_ = true;
    if (!away || !answered_ || Clock::now() - began + wait > patience_) return reply;
    std::this_thread::sleep_for(wait);
  }
}

Result<std::string> Remote::text(const http::HttpClient::Request& request) {
  http::HttpReply reply = TRY(ask(request));
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
  const std::string id = store::asset_id(kind, name, bytes);
  const http::HttpReply there = TRY(ask(get("/api/v1/assets/" + id)));
  if (there.status == 200) return id;
  if (there.status != 404) return error_of(there);
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
  return id_of(once(post("/api/v1/projects", body, "application/json")));
}

Result<json::JsonValue> Remote::submit(const std::string& project_id, store::JobPriority priority,
                                       bool pictures) {
  std::vector<json::JsonMember> wish{{"project_id", project_id},
                                     {"priority", std::string(store::name_of(priority))}};
  if (!pictures) wish.push_back({"pictures", false});
  return json(once(post("/api/v1/jobs", json::write_json_line(wish), "application/json")));
}

Result<json::JsonValue> Remote::submit_sweep(const json::JsonValue& body) {
  return json(once(post("/api/v1/sweeps", json::write_json_line(body), "application/json")));
}

Result<json::JsonValue> Remote::show(const std::string& what) { return json(get("/api/v1/" + what)); }

Result<json::JsonValue> Remote::cancel(const std::string& what) {
  return json(post("/api/v1/" + what + "/cancel", "", ""));
}

Result<std::string> Remote::fetch(const std::string& what) { return text(get("/api/v1/" + what)); }

}  // namespace toile::app
