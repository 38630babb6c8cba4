#pragma once

#include "server/http/handlers/api.h"

namespace toile::handlers {

ApiRoutes sweep_routes();

}  // namespace toile::handlers
