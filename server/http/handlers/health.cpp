// /healthz, /readyz and /metrics.

#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile {
namespace {

HttpResponse alive(const Api&, const RequestContext&, const HttpRequest&) {
  return json_answer(200, {{"status", std::string("ok")}});
}

HttpResponse ready(const Api& api, const RequestContext&, const HttpRequest&) {
  if (!api.ready.load())
    return problem(503, {"server.draining", "the server is stopping", "", ErrorKind::kUnavailable});
  if (Status alive = api.store.ping(); !alive) return problem(503, alive.error());
  return json_answer(200, {{"status", std::string("ready")}});
}

HttpResponse metrics(const Api& api, const RequestContext&, const HttpRequest&) {
  HttpResponse response;
  response.content_type = "text/plain; version=0.0.4; charset=utf-8";
  response.body = api.metrics.text(api.jobs.counts(), api.hub.viewers());
  return response;
}

}  // namespace

ApiRoutes health_routes() {
  return {{.pattern = "/healthz", .handler = alive},
          {.pattern = "/readyz", .handler = ready},
          {.pattern = "/metrics", .handler = metrics}};
}

}  // namespace toile
