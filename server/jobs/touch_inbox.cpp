#include "server/jobs/touch_inbox.h"

#include <utility>

namespace toile::jobs {
namespace {

Error over() {
  return {"live.over", "the drape is done; hands are for cloth that drapes", "", ErrorKind::kConflict};
}

bool draws_on(const drape::Touch& before, const drape::Touch& now) {
  return before.kind == drape::TouchKind::kPull && now.kind == drape::TouchKind::kPull && before.id == now.id;
}

}  // namespace

Status TouchInbox::put(LiveTouch touch) {
  const std::lock_guard lock(mutex_);
  if (closed_) return over();
  if (!waiting_.empty() && draws_on(waiting_.back().touch, touch.touch)) {
    waiting_.back().touch.target = touch.touch.target;  // it holds what it took hold of first
    return {};
  }
  // Whoever goes lets go, however many wait: each has let go once only.
  if (waiting_.size() >= kMost && touch.touch.kind != drape::TouchKind::kLetGo)
    return Error{"live.busy", "more is done to this drape than it can follow; wait a moment", "",
                 ErrorKind::kTooMany};
  waiting_.push_back(std::move(touch));
  return {};
}

std::vector<LiveTouch> TouchInbox::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(waiting_, {});
}

void TouchInbox::close() {
  std::vector<LiveTouch> late;
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    late = std::exchange(waiting_, {});
  }
  for (const LiveTouch& touch : late) {
    if (touch.refused && touch.touch.kind != drape::TouchKind::kLetGo) touch.refused(over());
  }
}

}  // namespace toile::jobs
