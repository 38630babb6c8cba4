#pragma once

#include "core/preflight/finding.h"
#include "proto/cpp/json_codec.h"

namespace toile {

/// {"code", "severity", "message", "where", "place": [x, y, z] (m), "repaired"}.
JsonValue finding_json(const Finding& finding);

}  // namespace toile
