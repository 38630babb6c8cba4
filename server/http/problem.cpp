#include "server/http/problem.h"

#include <map>
#include <string_view>

#include "core/base/names.h"
#include "core/json/tree.h"

namespace toile {
namespace {

constexpr std::size_t kMostWords = 2000;  // of a message that quotes its input

const std::map<std::string_view, int>& known_codes() {
  static const std::map<std::string_view, int> codes{
      {"store.not_found", 404},      {"store.conflict", 412},
      {"store.full", 507},           {"store.busy", 503},
      {"store.cursor", 400},         {"store.idempotency_key", 400},
      {"store.bad_name", 422},       {"store.idempotency_mismatch", 409},
      {"jobs.state", 409},           {"jobs.too_many_paused", 429},
      {"jobs.queue_full", 429},      {"jobs.stopped", 503},
      {"mesh.reader", 500},          {"documents.kind", 400},
      {"edit.nothing_to_undo", 409}, {"edit.nothing_to_redo", 409},
  };
  return codes;
}

}  // namespace

std::string status_phrase(int status) {
  static const std::map<int, std::string> phrases{
      {200, "OK"},
      {201, "Created"},
      {204, "No Content"},
      {304, "Not Modified"},
      {400, "Bad Request"},
      {403, "Forbidden"},
      {404, "Not Found"},
      {405, "Method Not Allowed"},
      {409, "Conflict"},
      {412, "Precondition Failed"},
      {413, "Content Too Large"},
      {414, "URI Too Long"},
      {415, "Unsupported Media Type"},
      {421, "Misdirected Request"},
      {422, "Unprocessable Content"},
      {426, "Upgrade Required"},
      {428, "Precondition Required"},
      {429, "Too Many Requests"},
      {431, "Request Header Fields Too Large"},
      {500, "Internal Server Error"},
      {503, "Service Unavailable"},
      {507, "Insufficient Storage"},
  };
  const auto found = phrases.find(status);
  return found == phrases.end() ? "Status" : found->second;
}

int status_of(const Error& error) {
  const std::string_view code = error.code;
  if (const auto found = known_codes().find(code); found != known_codes().end()) return found->second;
  if (code.ends_with(".too_large")) return 413;
  if (code.starts_with("json.")) return 400;
  for (const std::string_view ours : {"store.", "jobs.", "internal", "render.", "export."}) {
    if (code.starts_with(ours)) return 500;
  }
  return 422;
}

HttpResponse problem(int status, const Error& error) {
  const std::vector<JsonMember> members{
      {"type", std::string("about:blank")},           {"title", status_phrase(status)},
      {"status", static_cast<double>(status)},        {"code", error.code},
      {"detail", clipped(error.message, kMostWords)}, {"where", clipped(error.where, kMostWords)}};
  HttpResponse response;
  response.status = status;
  response.content_type = "application/problem+json";
  response.body = write_json(members);
  if (status == 429 || status == 503) response.headers.emplace_back("Retry-After", "5");
  return response;
}

HttpResponse problem(const Error& error) { return problem(status_of(error), error); }

}  // namespace toile
