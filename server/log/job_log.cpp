#include "server/log/job_log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <string>
#include <utility>

#include "server/log/log_line.h"

namespace toile::log {
namespace {

/// The job that a line is about; empty when it is about none, or about what could be no file's name here.
std::string job_of(std::span<const LogField> fields) {
  for (const LogField& field : fields) {
    if (field.key != "job") continue;
    const bool plain = std::all_of(field.value.begin(), field.value.end(), [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '_';
    });
    return plain && field.value.size() <= 64 ? field.value : std::string();
  }
  return "";
}

class JobLog final : public LogSink {
 public:
  JobLog(LogSink& next, std::filesystem::path folder) : next_(next), folder_(std::move(folder)) {}

  void write(LogLevel level, std::string_view event, std::span<const LogField> bound,
             std::span<const LogField> more) noexcept override {
    next_.write(level, event, bound, more);
    try {
      std::string job = job_of(bound);
      if (job.empty()) job = job_of(more);
      if (job.empty()) return;
      append(job, log_json(std::chrono::system_clock::now(), level, event, bound, more) + "\n");
    } catch (const std::exception&) {  // no memory for the line: `next` has said it, or said so
    }
  }

 private:
  /// Opened for each line, of which a job has a few dozen: thousands of jobs may wait, and none keeps a file
  /// open.
  void append(const std::string& job, const std::string& line) {
    const std::lock_guard lock(mutex_);
    const int file =
        ::open((folder_ / job).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0) return;
    struct stat about {};
    const bool room = ::fstat(file, &about) == 0 &&
                      static_cast<std::size_t>(about.st_size) + line.size() <= kMostJobLogBytes;
    [[maybe_unused]] const ssize_t written = room ? ::write(file, line.data(), line.size()) : 0;
    ::close(file);
  }

  LogSink& next_;
  const std::filesystem::path folder_;
  std::mutex mutex_;
};

}  // namespace

std::unique_ptr<LogSink> make_job_log(LogSink& next, std::filesystem::path folder) {
  return std::make_unique<JobLog>(next, std::move(folder));
}

}  // namespace toile::log
