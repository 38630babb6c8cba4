#include "server/http/problem.h"

#include <map>

#include "core/base/names.h"
#include "core/json/tree.h"

namespace toile::http {
namespace {

constexpr std::size_t kMostWords = 2000;  // of a message that quotes its input

}  // namespace

std::string status_phrase(int status) {
  static const std::map<int, std::string> phrases{
      {200, "OK"},
      {201, "Created"},
      {204, "No Content"},
      {304, "Not Modified"},
      {400, "Bad Request"},
      {401, "Unauthorized"},
      {403, "Forbidden"},
      {404, "Not Found"},
      {405, "Method Not Allowed"},
      {408, "Request Timeout"},
      {409, "Conflict"},
      {410, "Gone"},
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

int status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kInput:
      return 422;
    case ErrorKind::kMalformed:
      return 400;
    case ErrorKind::kTooLarge:
      return 413;
    case ErrorKind::kNotFound:
      return 404;
    case ErrorKind::kConflict:
      return 409;
    case ErrorKind::kStale:
      return 412;
    case ErrorKind::kUnconditional:
      return 428;
    case ErrorKind::kTooMany:
      return 429;
    case ErrorKind::kUnavailable:
      return 503;
    case ErrorKind::kNoRoom:
      return 507;
    case ErrorKind::kCancelled:  // nobody reads the answer to what he has given up
    case ErrorKind::kSystem:
    case ErrorKind::kInternal:
      break;
  }
  return 500;
}

HttpResponse problem(int status, const Error& error) {
  const std::vector<json::JsonMember> members{
      {"type", std::string("about:blank")},           {"title", status_phrase(status)},
      {"status", static_cast<double>(status)},        {"code", error.code},
      {"detail", clipped(error.message, kMostWords)}, {"where", clipped(error.where, kMostWords)}};
  HttpResponse response;
  response.status = status;
  response.code = error.code;
  response.content_type = "application/problem+json";
  response.body = json::write_json(members);
  if (status == 429 || status == 503) response.headers.emplace_back("Retry-After", "5");
  return response;
}

HttpResponse problem(const Error& error) { return problem(status_of(error.kind), error); }

}  // namespace toile::http
