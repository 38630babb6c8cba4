#pragma once
// Lines to stderr, one each: "2026-05-04T10:11:12.123Z info  job queued owner=local request=r_… job=j_…".

#include <memory>

#include "core/base/log.h"

namespace toile {

/// Tells what is at least as grave as `least`.
std::unique_ptr<LogSink> make_stderr_sink(LogLevel least = LogLevel::kInfo);

/// One line's text, without time and level. What is no plain word stands in quotes, with what could end the
/// line or the quotes escaped: a stranger's header must not forge a line.
std::string log_text(std::string_view event, std::span<const LogField> bound, std::span<const LogField> more);

}  // namespace toile
