#pragma once

#include "core/json/tree.h"
#include "server/jobs/wish.h"

namespace toile::handlers {

/// "priority", "anew", "from" and "tags" of a request for drapes, as far as they are there. Errors:
/// request.priority, request.anew, request.from, request.tags.
Result<jobs::JobWish> read_job_wish(const json::JsonValue& given);

}  // namespace toile::handlers
