#include "server/jobs/queue.h"

#include <algorithm>

namespace toile::jobs {

void JobQueue::put(const std::string& id, QueuePlace place) {
  std::erase(ids_, id);
  if (place == QueuePlace::kFront) ids_.push_front(id);
  if (place == QueuePlace::kBack) ids_.push_back(id);
}

bool JobQueue::contains(const std::string& id) const {
  return std::find(ids_.begin(), ids_.end(), id) != ids_.end();
}

std::optional<std::string> JobQueue::first(const std::function<bool(const std::string&)>& ready) const {
  const auto found = std::find_if(ids_.begin(), ids_.end(), ready);
  if (found == ids_.end()) return std::nullopt;
  return *found;
}

}  // namespace toile::jobs
