#pragma once
// Lines to stderr, one each, for people or for programs.

#include <memory>

#include "core/base/log.h"

namespace toile::log {

enum class LogFormat {
  kText,  ///< "2026-05-04T10:11:12.123Z info  job queued owner=local request=r_… job=j_…"
  kJson,  ///< {"time": "2026-05-04T10:11:12.123Z", "level": "info", "event": "job queued", "owner": "local",
          ///< …}
};

/// Tells what is at least as grave as `least`.
std::unique_ptr<LogSink> make_stderr_sink(LogFormat format = LogFormat::kText,
                                          LogLevel least = LogLevel::kInfo);

}  // namespace toile::log
