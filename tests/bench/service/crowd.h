#pragma once
// Many viewers of a drape's stream in one thread.

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace toile::bench {

/// Connects its viewers, who count the frames that come and answer pings, or read nothing at all.
class Crowd {
 public:
  Crowd(int port, const std::string& job, int viewers, bool read);
  ~Crowd();
  Crowd(const Crowd&) = delete;

  /// Frames that each has got so far.
  std::vector<long> frames() const;
  /// How many have been parted from by the server. REQUIRES that they read.
  int gone() const { return gone_; }

 private:
  struct Viewer {
    int socket = -1;
    std::string buffer;  ///< what has come and is not yet a whole message
    std::atomic<long> frames{0};
  };
  void read_on();
  void take(Viewer& viewer);

  std::vector<Viewer> viewers_;
  std::atomic<bool> over_{false};
  std::atomic<int> gone_{0};
  std::thread reader_;
};

}  // namespace toile::bench
