#include "server/jobs/worker_pool.h"

#include <utility>

namespace toile::jobs {

WorkerPool::WorkerPool(int threads, std::function<bool()> work_once) : work_once_(std::move(work_once)) {
  threads_.reserve(static_cast<std::size_t>(threads));
  for (int i = 0; i < threads; ++i) {
    threads_.emplace_back([this] {
      while (work_once_()) {
      }
    });
  }
}

WorkerPool::~WorkerPool() = default;  // a jthread joins

}  // namespace toile::jobs
