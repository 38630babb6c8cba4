#include "server/jobs/render_worker.h"

#include <chrono>
#include <exception>
#include <utility>

#include "server/render/still.h"

namespace toile::jobs {
namespace {

constexpr auto kAskEvery = std::chrono::milliseconds(10);

/// Who of the two comes first: the caller who gives up, or the drawing that throws. The other knows by it
/// whether the caller will hear of what was thrown.
using FirstOfTwo = std::atomic_flag;

/// Throws what the drawing throws; tells the log when nobody is there any more to catch it.
RenderWorker::Drawing telling(RenderWorker::Drawing drawing, std::shared_ptr<FirstOfTwo> first, Log log) {
  return [drawing = std::move(drawing), first = std::move(first), log = std::move(log)](
             render::Stills& stills, const RunContext& context) -> Status {
    try {
      return drawing(stills, context);
    } catch (const std::exception& e) {
      if (first->test_and_set()) log.error("a drawing that was given up threw", {{"what", e.what()}});
      throw;
    } catch (...) {
      if (first->test_and_set()) log.error("a drawing that was given up threw what is no exception");
      throw;
    }
  };
}

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

Status RenderWorker::draw(Drawing drawing, const std::function<bool()>& given_up, const Log& log) {
  const auto dropped = std::make_shared<std::atomic<bool>>(false);
  const auto first = std::make_shared<FirstOfTwo>();
  std::packaged_task<Status(render::Stills&, const RunContext&)> task(
      telling(std::move(drawing), first, log));
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
    if (first->test_and_set()) break;  // it has thrown just now
    dropped->store(true, std::memory_order_relaxed);
    return Error{"render.given_up", "nobody waits for the pictures any more", "", ErrorKind::kCancelled};
  }
  return drawn.get();
}

void RenderWorker::work() {
  render::Stills stills;  // begins and ends on this thread, as OpenGL wants it
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !orders_.empty(); });
    if (stopping_) return;
    Order order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    RunContext context;
    context.cancel = order.dropped.get();
    if (!context.cancelled()) order.drawing(stills, context);
    order = {};  // what the drawing owns goes before the lock is taken
    lock.lock();
  }
}

}  // namespace toile::jobs
