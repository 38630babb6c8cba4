#pragma once

#include <ctime>

namespace toile::jobs {

/// Processor time of one thread, lap by lap. It stays with the thread that began it.
class WorkClock {
 public:
  WorkClock() : last_(now()) {}
  /// s of this thread since the last lap, or since this was made.
  double lap() {
    const double before = last_;
    last_ = now();
    return last_ - before;
  }

 private:
  static double now() {
    std::timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double last_;
};

}  // namespace toile::jobs
