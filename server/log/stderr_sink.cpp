#include "server/log/stderr_sink.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>

namespace toile {
namespace {

bool is_plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("-_.:/{}*,%?&+@#~").find(c) != std::string_view::npos;
}

/// Bytes beyond ASCII stay: names and messages are UTF-8.
void add_quoted(std::string& line, std::string_view value) {
  line += '"';
  for (const char c : value) {
    if (c == '"' || c == '\\') line += '\\';
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) {
      line += c;
      continue;
    }
    std::array<char, 8> escape;
    std::snprintf(escape.data(), escape.size(), "\\x%02x",
                  static_cast<unsigned>(static_cast<unsigned char>(c)));
    line += escape.data();
  }
  line += '"';
}

void add_fields(std::string& line, std::span<const LogField> fields) {
  for (const LogField& field : fields) {
    if (field.value.empty()) continue;
    line += ' ';
    line += field.key;
    line += '=';
    if (std::all_of(field.value.begin(), field.value.end(), is_plain)) {
      line += field.value;
    } else {
      add_quoted(line, field.value);
    }
  }
}

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
  explicit StderrSink(LogLevel least) : logger_("toile", std::make_shared<spdlog::sinks::stderr_sink_mt>()) {
    logger_.set_pattern("%Y-%m-%dT%H:%M:%S.%eZ %-7l %v", spdlog::pattern_time_type::utc);
    logger_.set_level(level_of(least));
    logger_.flush_on(
        spdlog::level::debug);  // a line that a crash takes along would be the one that is wanted
  }

  void write(LogLevel level, std::string_view event, std::span<const LogField> bound,
             std::span<const LogField> more) noexcept override {
    try {
      const spdlog::level::level_enum at = level_of(level);
      if (logger_.should_log(at)) logger_.log(at, log_text(event, bound, more));
    } catch (const std::exception& e) {  // no memory for the line: say so without any
      std::fputs("toile: a log line was lost: ", stderr);
      std::fputs(e.what(), stderr);
      std::fputs("\n", stderr);
    }
  }

 private:
  spdlog::logger logger_;
};

}  // namespace

std::unique_ptr<LogSink> make_stderr_sink(LogLevel least) { return std::make_unique<StderrSink>(least); }

std::string log_text(std::string_view event, std::span<const LogField> bound,
                     std::span<const LogField> more) {
  std::string line(event);
  add_fields(line, bound);
  add_fields(line, more);
  return line;
}

}  // namespace toile
