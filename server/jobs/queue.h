#pragma once
// The order in which jobs wait for a worker.

#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "server/jobs/transition.h"

namespace toile::jobs {

/// Ids of waiting jobs, each at most once. Not thread-safe: whoever owns it locks.
class JobQueue {
 public:
  /// Puts `id` where `place` says, away from where it stood; kOut takes it out.
  void put(const std::string& id, QueuePlace place);
  bool contains(const std::string& id) const;
  /// In their order.
  const std::deque<std::string>& ids() const { return ids_; }
  /// The first of which `ready` holds, which stays in the queue.
  std::optional<std::string> first(const std::function<bool(const std::string&)>& ready) const;

 private:
  std::deque<std::string> ids_;
};

}  // namespace toile::jobs
