#pragma once
// The one thread that draws. OpenGL's context lives on it, and several would gain nothing: Mesa already uses
// all cores for a picture.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/log.h"
#include "core/base/result.h"
#include "core/base/run_context.h"

namespace toile::render {
class Stills;
}

namespace toile::jobs {

class RenderWorker {
 public:
  /// At most `max_waiting` drawings wait.
  explicit RenderWorker(std::size_t max_waiting = 64);
  /// Ends the drawing that is under way, drops those that wait, joins.
  ~RenderWorker();
  RenderWorker(const RenderWorker&) = delete;
  RenderWorker& operator=(const RenderWorker&) = delete;

  /// Something to draw, with the thread's own renderer; it looks now and then whether its context is
  /// cancelled.
  using Drawing = std::function<Status(render::Stills& stills, const RunContext& context)>;

  /// Runs `drawing` on the drawing thread, waits for it and gives back what it gives; what it throws is
  /// thrown here. `given_up` is asked every few milliseconds: once it says so, the drawing is cancelled and
  /// not waited for, so it must own all that it uses, and what it throws from then on goes to `log`. Errors:
  /// render.busy, render.given_up, those of `drawing`.
  Status draw(Drawing drawing, const std::function<bool()>& given_up, const Log& log = {});

 private:
  struct Order {
    std::packaged_task<Status(render::Stills&, const RunContext&)> drawing;
    std::shared_ptr<const std::atomic<bool>> dropped;
  };
  void work();

  const std::size_t max_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Order> orders_;
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace toile::jobs
