#pragma once
// What a program tells of its own running, for whoever has to find out later what happened. Here is only what
// a line is; where lines go is server/log's. The core itself has nothing to tell: it answers.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace toile {

enum class LogLevel { kDebug, kInfo, kWarning, kError };

/// A word of a line that can be searched for: {"job", "j_…"}.
struct LogField {
  std::string key;
  std::string value;
};
using LogFields = std::vector<LogField>;

/// Where lines go. Thread-safe. A line that cannot be kept is no reason to fail: write() throws nothing.
class LogSink {
 public:
  virtual ~LogSink() = default;
  /// `bound` is what the log says with every line, `more` what belongs to this one.
  virtual void write(LogLevel level, std::string_view event, std::span<const LogField> bound,
                     std::span<const LogField> more) noexcept = 0;
};

/// A sink, and the fields that every line to it carries: whose request it is, which job. A value: copies
/// share the sink, which outlives them all. Without a sink it is silent.
class Log {
 public:
  Log() = default;
  explicit Log(LogSink& sink) : sink_(&sink) {}

  /// The same log, each line of it with one more field.
  Log with(std::string key, std::string value) const {
    Log more = *this;
    LogFields fields = bound_ ? *bound_ : LogFields{};
    fields.push_back({std::move(key), std::move(value)});
    more.bound_ = std::make_shared<const LogFields>(std::move(fields));
    return more;
  }

  void write(LogLevel level, std::string_view event, const LogFields& more = {}) const noexcept {
    if (sink_ != nullptr) sink_->write(level, event, bound_ ? *bound_ : std::span<const LogField>{}, more);
  }
  void debug(std::string_view event, const LogFields& more = {}) const {
    write(LogLevel::kDebug, event, more);
  }
  void info(std::string_view event, const LogFields& more = {}) const { write(LogLevel::kInfo, event, more); }
  void warn(std::string_view event, const LogFields& more = {}) const {
    write(LogLevel::kWarning, event, more);
  }
  void error(std::string_view event, const LogFields& more = {}) const {
    write(LogLevel::kError, event, more);
  }
  /// Of an error that nobody will be answered with.
  void warn(std::string_view event, const Error& error) const {
    warn(event, {{"code", error.code}, {"message", error.message}, {"where", error.where}});
  }

 private:
  LogSink* sink_ = nullptr;
  std::shared_ptr<const LogFields> bound_;  // shared: a context is copied with every call that it outlives
};

}  // namespace toile
