#include "server/http/admission.h"

#include <algorithm>
#include <utility>

#include "core/base/names.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace toile::http {
namespace {

Admission refused(HttpResponse response) { return {nullptr, std::move(response)}; }

/// A filter that is not known would let through all that it was meant to keep out.
std::optional<HttpResponse> unknown_parameter(const Route& route, const HttpRequest& request) {
  if (route.any_parameter) return std::nullopt;
  for (const auto& [name, value] : request.query) {
    if (std::find(route.parameters.begin(), route.parameters.end(), name) != route.parameters.end()) continue;
    return problem(
        400, {"request.unknown_parameter",
              "the parameter " + in_quotes(name) + " is not known here; " + advice(name, route.parameters),
              clipped(name)});
  }
  return std::nullopt;
}

/// What Beast would refuse of a handshake, in words of its own.
std::optional<HttpResponse> wrong_handshake(const HttpRequest& request) {
  constexpr std::size_t kKeyLength = 24;  // 16 bytes in base64 (RFC 6455, 4.2.1)
  if (request.header("sec-websocket-key").size() != kKeyLength) {
    return problem(400,
                   {"http.handshake", "a handshake has a key of 16 bytes in base64", "Sec-WebSocket-Key"});
  }
  if (request.header("sec-websocket-version") == "13") return std::nullopt;
  HttpResponse wanted =
      problem(426, {"http.upgrade", "this speaks version 13 of WebSocket", "Sec-WebSocket-Version"});
  wanted.headers.emplace_back("Sec-WebSocket-Version", "13");
  wanted.headers.emplace_back("Upgrade", "websocket");
  return wanted;
}

}  // namespace

namespace {

/// What the route itself has against the request.
std::optional<HttpResponse> refused_by(const Route& route, const HttpRequest& request,
                                       const Incoming& incoming) {
  if (auto unknown = unknown_parameter(route, request)) return unknown;
  if (route.websocket && !incoming.upgrade) {
    HttpResponse wanted = problem(426, {"http.upgrade", "this address is a WebSocket", "Upgrade"});
    wanted.headers.emplace_back("Upgrade", "websocket");
    return wanted;
  }
  if (route.websocket) {
    if (auto wrong = wrong_handshake(request)) return wrong;
  }
  return refused_body(route, request, incoming.has_body, incoming.length);
}

}  // namespace

Admission admit(const Router& router, HttpRequest& request, const Incoming& incoming, const Site& site) {
  if (auto away = turned_away(request, incoming.upgrade, site)) return refused(std::move(*away));
  std::optional<Target> target = parse_target(request.target);
  if (!target) return refused(problem(400, {"http.target", "this is no address of ours", ""}));
  request.segments = std::move(target->segments);
  request.query = std::move(target->query);
  Router::Match match = router.match(request.method, request.segments);
  if (!match.route) {
    const bool api = !request.segments.empty() && request.segments.front() == "api";
    return {nullptr, no_route(request, match), api ? Access::kRead : Access::kOpen};
  }
  request.captures = std::move(match.captures);
  const Access access = access_of(*match.route);
  if (auto wrong = refused_by(*match.route, request, incoming)) return {nullptr, std::move(*wrong), access};
  return {match.route, {}, access};
}

}  // namespace toile::http
