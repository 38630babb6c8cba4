#include "server/log/stderr_sink.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>

#include "server/log/log_line.h"

namespace toile::log {
namespace {

spdlog::level::level_enum level_of(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return spdlog::level::debug;
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kWarning:
      return spdlog::level::warn;
    case LogLevel::kError:
      return spdlog::level::err;
  }
  return spdlog::level::err;
}

class StderrSink final : public LogSink {
 public:
  /// A logger of its own and none of spdlog's registry: that is one for the whole process.
  StderrSink(LogFormat format, LogLevel least)
      : format_(format), logger_("toile", std::make_shared<spdlog::sinks::stderr_sink_mt>()) {
    const bool json = format == LogFormat::kJson;
    logger_.set_pattern(json ? "%v" : "%Y-%m-%dT%H:%M:%S.%eZ %-7l %v", spdlog::pattern_time_type::utc);
    logger_.set_level(level_of(least));
    logger_.flush_on(
        spdlog::level::debug);  // a line that a crash takes along would be the one that is wanted
  }

  void write(LogLevel level, std::string_view event, std::span<const LogField> bound,
             std::span<const LogField> more) noexcept override {
    try {
      const spdlog::level::level_enum at = level_of(level);
      if (!logger_.should_log(at)) return;
      const auto now = std::chrono::system_clock::now();
      logger_.log(at, format_ == LogFormat::kJson ? log_json(now, level, event, bound, more)
                                                  : log_text(event, bound, more));
    } catch (const std::exception& e) {  // no memory for the line: say so without any
      std::fputs("toile: a log line was lost: ", stderr);
      std::fputs(e.what(), stderr);
      std::fputs("\n", stderr);
    }
  }

 private:
  const LogFormat format_;
  spdlog::logger logger_;
};

}  // namespace

std::unique_ptr<LogSink> make_stderr_sink(LogFormat format, LogLevel least) {
  return std::make_unique<StderrSink>(format, least);
}

}  // namespace toile::log
