#include "server/http/admission.h"

#include <utility>

#include "server/http/guard.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace toile::http {
namespace {

Admission refused(HttpResponse response) { return {nullptr, std::move(response)}; }

}  // namespace

Admission admit(const Router& router, HttpRequest& request, const Incoming& incoming) {
  if (auto away = turned_away(request, incoming.upgrade)) return refused(std::move(*away));
  std::optional<Target> target = parse_target(request.target);
  if (!target) return refused(problem(400, {"http.target", "this is no address of ours", ""}));
  request.segments = std::move(target->segments);
  request.query = std::move(target->query);
  Router::Match match = router.match(request.method, request.segments);
  if (!match.route) return refused(no_route(request, match));
  request.captures = std::move(match.captures);
  if (match.route->websocket && !incoming.upgrade) {
    HttpResponse wanted = problem(426, {"http.upgrade", "this address is a WebSocket", "Upgrade"});
    wanted.headers.emplace_back("Upgrade", "websocket");
    return refused(std::move(wanted));
  }
  if (auto wrong = refused_body(*match.route, request, incoming.has_body, incoming.length)) {
    return refused(std::move(*wrong));
  }
  return {match.route, {}};
}

}  // namespace toile::http
