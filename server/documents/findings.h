#pragma once

#include "core/json/tree.h"
#include "core/preflight/finding.h"

namespace toile::documents {

/// {"code", "severity", "message", "where", "about": [{"thing", "id"}], "place": [x, y, z] (m), "repaired"}.
json::JsonValue finding_json(const preflight::Finding& finding);

}  // namespace toile::documents
