#pragma once

#include "server/http/handlers/api.h"

namespace toile {

/// Adds every route of the service.
void add_routes(Router& router, const Api& api);

}  // namespace toile
