#include "server/jobs/shape_wish.h"

#include <utility>

namespace toile::jobs {

std::optional<std::string> ShapeWish::ask(std::chrono::milliseconds within) {
  std::unique_lock lock(mutex_);
  ++asking_;
  answered_.wait_for(lock, within, [&] { return shape_.has_value(); });
  std::optional<std::string> shape = shape_;
  if (--asking_ == 0) shape_.reset();
  return shape;
}

bool ShapeWish::is_asked() {
  const std::lock_guard lock(mutex_);
  return asking_ > 0 && !shape_;
}

void ShapeWish::answer(std::string shape) {
  {
    const std::lock_guard lock(mutex_);
    if (asking_ == 0) return;
    shape_ = std::move(shape);
  }
  answered_.notify_all();
}

}  // namespace toile::jobs
