#pragma once
// What a viewer may say on a stream.

#include <string_view>

#include "core/base/result.h"
#include "server/jobs/touch_inbox.h"

namespace toile::ws {

struct Control {
  enum class Kind { kPause, kResume, kStep, kCancel, kTouch };
  Kind kind = Kind::kPause;
  jobs::LiveTouch touch;  ///< of kTouch; whose hand it is, is for the stream to say
};

/// Reads {"type": "pause"}, "resume", "step", "cancel", and what hands do: "pull" and "pin" with epoch,
/// triangle and shares, "pull" with "to" (m) as well, "let_go", and "unpin" with the pin's number
/// (proto/asyncapi.yaml). Errors: json.*, stream.unknown_type, stream.unknown_key, stream.bad_value, with the
/// place.
Result<Control> parse_control(std::string_view text);

}  // namespace toile::ws
