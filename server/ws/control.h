#pragma once
// What a viewer may say on a stream.

#include <string_view>

#include "core/base/result.h"

namespace toile::ws {

enum class Control { kPause, kResume, kCancel };

/// Reads {"type": "pause"}, "resume" or "cancel". Errors: json.*, stream.unknown_type,
/// stream.unknown_key.
Result<Control> parse_control(std::string_view text);

}  // namespace toile::ws
