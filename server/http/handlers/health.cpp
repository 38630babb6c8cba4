// /healthz, /readyz and /metrics.

#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

http::HttpResponse alive(const Api&, const store::RequestContext&, const http::HttpRequest&) {
  return json_answer(200, {{"status", std::string("ok")}});
}

http::HttpResponse ready(const Api& api, const store::RequestContext&, const http::HttpRequest&) {
  if (!api.ready.load())
    return http::problem(503, {"server.draining", "the server is stopping", "", ErrorKind::kUnavailable});
  if (Status alive = api.store.ping(); !alive) return http::problem(503, alive.error());
  return json_answer(200, {{"status", std::string("ready")}});
}

http::HttpResponse metrics(const Api& api, const store::RequestContext&, const http::HttpRequest&) {
  http::HttpResponse response;
  response.content_type = "text/plain; version=0.0.4; charset=utf-8";
  const auto readers = api.documents.importer().ends();
  response.body = api.metrics.text({.jobs = api.jobs.counts(),
                                    .store = api.store.figures(),
                                    .readers = {readers.started, readers.crashed, readers.refused},
                                    .viewers = api.hub.viewers()});
  return response;
}

}  // namespace

ApiRoutes health_routes() {
  return {{.pattern = "/healthz", .handler = alive, .access = http::Access::kOpen},
          {.pattern = "/readyz", .handler = ready, .access = http::Access::kOpen},
          {.pattern = "/metrics", .handler = metrics, .access = http::Access::kAdmin}};
}

}  // namespace toile::handlers
