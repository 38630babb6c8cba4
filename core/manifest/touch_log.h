#pragma once
// drape.log: the hands that were on the cloth while it draped, each touch with its step. With the inputs of
// the manifest it gives the same drape again. proto/schema/drape_log.schema.json has each key.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/drape/touch.h"
#include "core/json/tree.h"

namespace toile::manifest {

inline constexpr const char* kTouchLogFile = "drape.log";

/// JSON with a line a touch; numbers read back as the same doubles.
std::string write_touch_log(const std::vector<drape::Touch>& touches);

/// Errors: log.damaged (no JSON, or not of this form), with the place in `where`. Whether the touches are of
/// a certain garment is for drape::check_touches to say.
Result<std::vector<drape::Touch>> parse_touch_log(std::string_view text);

json::JsonValue touch_log_schema();

}  // namespace toile::manifest
