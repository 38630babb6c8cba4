#pragma once
// What a line of a log reads like.

#include <chrono>
#include <span>
#include <string>
#include <string_view>

#include "core/base/log.h"

namespace toile::log {

/// One line's text, without time and level. What is no plain word stands in quotes, with what could end the
/// line or the quotes escaped: a stranger's header must not forge a line.
std::string log_text(std::string_view event, std::span<const LogField> bound, std::span<const LogField> more);

/// The line as a JSON object without a line's end: time, level, event, then the fields that are not empty. A
/// field whose key stands twice has its later value. Bytes that are no UTF-8 become U+FFFD.
std::string log_json(std::chrono::system_clock::time_point time, LogLevel level, std::string_view event,
                     std::span<const LogField> bound, std::span<const LogField> more);

}  // namespace toile::log
