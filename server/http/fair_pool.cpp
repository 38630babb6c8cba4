#include "server/http/fair_pool.h"

#include <boost/asio/post.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace toile::http {

bool FairPool::post(const store::OwnerId& owner, std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    std::deque<std::function<void()>>& own = waiting_[owner];
    if (own.size() >= most_waiting_) return false;
    own.push_back(std::move(work));
    shares_.enter(owner);
  }
  boost::asio::post(threads_, [this] { do_next(); });  // one for each task, whichever it will take
  return true;
}

/// REQUIRES that something waits. Its owner stays charged with what is done until it is.
FairPool::Task FairPool::take() {
  const std::lock_guard lock(mutex_);
  const auto next = std::min_element(waiting_.begin(), waiting_.end(), [this](const auto& a, const auto& b) {
    return shares_.had(a.first) < shares_.had(b.first);
  });
  Task task{next->first, std::move(next->second.front())};
  next->second.pop_front();
  if (next->second.empty()) waiting_.erase(next);
  return task;
}

/// Time by the clock: much of it is spent in processes that read for us.
void FairPool::do_next() {
  Task task = take();
  const auto before = std::chrono::steady_clock::now();
  task.work();
  task.work = nullptr;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
  const std::lock_guard lock(mutex_);
  shares_.charge(task.owner, took.count());
  shares_.leave(task.owner);
}

double FairPool::had(const store::OwnerId& owner) const {
  const std::lock_guard lock(mutex_);
  return shares_.had(owner);
}

}  // namespace toile::http
