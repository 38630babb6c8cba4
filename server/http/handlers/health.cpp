// /healthz, /readyz and /metrics.

#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile {
namespace {

HttpResponse ready(const Api& api) {
  if (!api.ready.load())
    return problem(503, {"server.draining", "the server is stopping", "", ErrorKind::kUnavailable});
  if (Status alive = api.store.ping(); !alive) return problem(503, alive.error());
  return json_answer(200, {{"status", std::string("ready")}});
}

HttpResponse metrics(const Api& api) {
  HttpResponse response;
  response.content_type = "text/plain; version=0.0.4; charset=utf-8";
  response.body = api.metrics.text(api.jobs.counts(), api.hub.viewers());
  return response;
}

}  // namespace

void add_health_routes(Router& router, const Api& api) {
  router.add({.method = "GET", .pattern = "/healthz", .handler = [](const HttpRequest&) {
                return json_answer(200, {{"status", std::string("ok")}});
              }});
  router.add(
      {.method = "GET", .pattern = "/readyz", .handler = [&api](const HttpRequest&) { return ready(api); }});
  router.add({.method = "GET", .pattern = "/metrics", .handler = [&api](const HttpRequest&) {
                return metrics(api);
              }});
}

}  // namespace toile
