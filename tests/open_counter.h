#pragma once
// Counts how often a file is opened, by whatever process.

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace toile::test {

/// From its making on. REQUIRES a file that is there.
class OpenCounter {
 public:
  explicit OpenCounter(const std::filesystem::path& file) : queue_(::inotify_init1(IN_NONBLOCK)) {
    EXPECT_GE(::inotify_add_watch(queue_, file.c_str(), IN_OPEN | IN_CLOSE), 0)
        << file << ": " << std::strerror(errno);
  }
  OpenCounter(const OpenCounter&) = delete;
  OpenCounter& operator=(const OpenCounter&) = delete;
  ~OpenCounter() { ::close(queue_); }

  /// Times until now.
  int opened() {
    // The kernel joins an event to the one before it when both are alike and nobody has read that one yet;
    // so the queue is watched for openings and closings, which take turns.
    alignas(inotify_event) std::array<char, 65536> bytes;
    for (;;) {
      const ssize_t got = ::read(queue_, bytes.data(), bytes.size());
      if (got <= 0) return opened_;
      for (ssize_t at = 0; at < got;) {
        const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
        if ((event->mask & IN_OPEN) != 0) ++opened_;
        at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
      }
    }
  }

 private:
  int queue_;
  int opened_ = 0;
};

}  // namespace toile::test
