#include "server/jobs/render_worker.h"

#include <chrono>
#include <utility>

namespace toile::jobs {
namespace {

constexpr auto kAskEvery = std::chrono::milliseconds(10);

}  // namespace

RenderWorker::RenderWorker(std::size_t max_waiting)
    : max_waiting_(max_waiting), thread_([this] { work(); }) {}

RenderWorker::~RenderWorker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Status RenderWorker::draw(Drawing drawing, const std::function<bool()>& given_up) {
  const auto dropped = std::make_shared<std::atomic<bool>>(false);
  std::packaged_task<Status(const RunContext&)> task(std::move(drawing));
  std::future<Status> drawn = task.get_future();
  {
    const std::lock_guard lock(mutex_);
    if (orders_.size() >= max_waiting_) {
      return Error{"render.busy", "too many drapes wait for their pictures", "", ErrorKind::kInternal};
    }
    orders_.push_back({std::move(task), dropped});
  }
  changed_.notify_one();
  while (drawn.wait_for(kAskEvery) != std::future_status::ready) {
    if (!given_up()) continue;
    dropped->store(true, std::memory_order_relaxed);
    return Error{"render.given_up", "nobody waits for the pictures any more", "", ErrorKind::kCancelled};
  }
  return drawn.get();
}

void RenderWorker::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !orders_.empty(); });
    if (stopping_) return;
    Order order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    RunContext context;
    context.cancel = order.dropped.get();
    if (!context.cancelled()) order.drawing(context);
    order = {};  // what the drawing owns goes before the lock is taken
    lock.lock();
  }
}

}  // namespace toile::jobs
