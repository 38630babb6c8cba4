#pragma once
// Addresses that are told when a drape has ended.

#include "server/http/handlers/api.h"

namespace toile::handlers {

ApiRoutes webhook_routes();

}  // namespace toile::handlers
