#pragma once

#include "server/http/handlers/api.h"

namespace toile::handlers {

/// Adds every route of the service.
void add_routes(http::Router& router, const Api& api);

}  // namespace toile::handlers
