#pragma once
// What a request for a sweep says.

#include "core/json/tree.h"
#include "server/http/message.h"
#include "server/jobs/sweeps.h"

namespace toile::handlers {

/// Of POST /api/v1/sweeps. Errors: json.*, request.object, request.unknown_key, request.project_id,
/// request.label, request.body, request.fabric, request.priority, request.tags, request.anew, each with a
/// pointer into the request.
Result<jobs::SweepWish> read_sweep_wish(const http::HttpRequest& request);

}  // namespace toile::handlers
