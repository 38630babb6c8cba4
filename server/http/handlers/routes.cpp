#include "server/http/handlers/routes.h"

#include <utility>

#include "server/http/handlers/events.h"
#include "server/http/handlers/sweeps.h"
#include "server/http/handlers/webhooks.h"

namespace toile::handlers {

void add_routes(http::Router& router, const Api& api) {
  for (const auto& table : {health_routes, asset_routes, project_routes, pattern_file_routes, edit_routes,
                            version_routes, body_routes, fabric_routes, arrangement_routes, job_routes,
                            sweep_routes, event_routes, webhook_routes, movie_routes, still_routes,
                            link_routes, shared_routes, session_routes, admin_routes}) {
    for (ApiRoute& line : table()) {
      http::Route route;
      route.method = line.method;
      route.pattern = line.pattern;
      route.handler = [api, handler = std::move(line.handler)](const store::RequestContext& context,
                                                               const http::HttpRequest& request) {
        return handler(api, context, request);
      };
      route.body = line.body;
      route.limit = std::move(line.limit);
      route.work = line.work;
      route.access = line.access;
      route.parameters = std::move(line.parameters);
      route.websocket = line.websocket;
      router.add(std::move(route));
    }
  }
}

}  // namespace toile::handlers
