#pragma once

#include "core/json/tree.h"
#include "core/preflight/finding.h"

namespace toile {

/// {"code", "severity", "message", "where", "place": [x, y, z] (m), "repaired"}.
JsonValue finding_json(const Finding& finding);

}  // namespace toile
