#include "server/http/router.h"

#include <algorithm>
#include <utility>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace toile::http {
namespace {

bool is_capture(const std::string& part) { return part.starts_with('{'); }

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> parts;
  while (path.size() > 1) {
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find('/'), path.size());
    parts.emplace_back(path.substr(0, end));
    path.remove_prefix(end);
  }
  return parts;
}

std::optional<std::vector<std::string>> captured(const std::vector<std::string>& pattern,
                                                 const std::vector<std::string>& segments) {
  if (segments.size() != pattern.size()) return std::nullopt;
  std::vector<std::string> captures;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (is_capture(pattern[i])) {
      if (segments[i].empty()) return std::nullopt;
      captures.push_back(segments[i]);
    } else if (pattern[i] != segments[i]) {
      return std::nullopt;
    }
  }
  return captures;
}

/// "application/json" of "Application/JSON; charset=utf-8".
std::string media_type(std::string_view value) {
  value = value.substr(0, std::min(value.find(';'), value.size()));
  while (!value.empty() && value.back() == ' ') value.remove_suffix(1);
  return lower_case(value);
}

bool is_file_type(const std::string& type) {
  if (type.empty() || type.starts_with("model/") || type.starts_with("image/")) return true;
  for (const char* known :
       {"application/octet-stream", "application/dxf", "application/x-dxf", "text/plain"}) {
    if (type == known) return true;
  }
  return false;
}

}  // namespace

Access access_of(const Route& route) {
  if (route.access != Access::kByMethod) return route.access;
  return route.method == "GET" ? Access::kRead : Access::kSubmit;
}

void Router::add(Route route) {
  patterns_.push_back(split(route.pattern));
  routes_.push_back(std::move(route));
}

void Router::add_page(HttpHandler handler) {
  page_.emplace();
  page_->method = "GET";
  page_->any_parameter = true;
  page_->access = Access::kOpen;
  page_->handler = std::move(handler);
}

Router::Match Router::match(const std::string& method, const std::vector<std::string>& segments) const {
  const std::string wanted = method == "HEAD" ? "GET" : method;
  Match match;
  for (std::size_t i = 0; i < routes_.size(); ++i) {
    std::optional<std::vector<std::string>> captures = captured(patterns_[i], segments);
    if (!captures) continue;
    if (routes_[i].method == wanted) return {&routes_[i], std::move(*captures), ""};
    match.allow += (match.allow.empty() ? "" : ", ") + routes_[i].method;
    if (routes_[i].method == "GET") match.allow += ", HEAD";
  }
  const bool api = !segments.empty() && segments.front() == "api";
  if (!match.allow.empty() || api || !page_) return match;
  if (wanted == "GET") return {&*page_, {}, ""};
  match.allow = "GET, HEAD";
  return match;
}

std::optional<HttpResponse> refused_body(const Route& route, const HttpRequest& request, bool has_body,
                                         std::optional<std::uint64_t> length) {
  const std::string type = media_type(request.header("content-type"));
  if (route.body == BodyKind::kJson && type != "application/json") {
    return problem(
        415, {"http.content_type", "this takes application/json, not " + in_quotes(type), "Content-Type"});
  }
  if (route.body == BodyKind::kFile && has_body && !is_file_type(type)) {
    return problem(415,
                   {"http.content_type",
                    "this takes the file's own bytes as application/octet-stream, not " + in_quotes(type),
                    "Content-Type"});
  }
  const std::size_t limit = route.limit(request);
  if (!length || *length <= limit) return std::nullopt;
  return problem(413, {"http.too_large",
                       "the body has " + std::to_string(*length) + " bytes, and " + std::to_string(limit) +
                           " are allowed here",
                       "Content-Length"});
}

HttpResponse no_route(const HttpRequest& request, const Router::Match& match) {
  if (match.allow.empty()) {
    return problem(404, {"http.not_found", "there is nothing at this address", clipped(request.target, 200)});
  }
  HttpResponse response = problem(
      405, {"http.method", "this address takes " + match.allow + " only", clipped(request.method, 20)});
  response.headers.emplace_back("Allow", match.allow);
  return response;
}

}  // namespace toile::http
