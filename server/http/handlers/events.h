#pragma once
// What a client is told of jobs as events, over the feed.

#include "server/http/handlers/api.h"

namespace toile::handlers {

ApiRoutes event_routes();

}  // namespace toile::handlers
