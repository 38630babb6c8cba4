#pragma once
// Events of jobs as text/event-stream (HTML, 9.2.6). Pure.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"
#include "server/store/events.h"

namespace toile::http {

inline constexpr std::string_view kEventStream = "text/event-stream";

/// The answer from which a feed goes on that has everything up to the event `after`. `gap`: what the client
/// has heard before is not followed by that.
HttpResponse event_stream(std::int64_t after, bool gap);
/// After which event a feed goes on that such an answer begins; nothing for any other answer.
std::optional<std::int64_t> feed_after(const HttpResponse& response);

/// {"job", "sweep", "project_id", "name", "state", "reason_code", "at_ms"} on one line.
std::string event_json(const store::EventRow& event);
/// The events that follow number `after`, and before them that some are missing where they are.
std::string event_text(const std::vector<store::EventRow>& events, std::int64_t after);

}  // namespace toile::http
