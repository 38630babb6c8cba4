#pragma once

#include <functional>
#include <thread>
#include <vector>

namespace toile::jobs {

/// Threads that do one thing after the other.
class WorkerPool {
 public:
  /// Each thread calls `work_once` until it returns false. It must throw nothing.
  WorkerPool(int threads, std::function<bool()> work_once);
  /// Joins; REQUIRES that work_once returns false before long.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

 private:
  std::function<bool()> work_once_;
  std::vector<std::jthread> threads_;
};

}  // namespace toile::jobs
