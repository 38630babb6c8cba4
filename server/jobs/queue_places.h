#pragma once
// How many more jobs may come to wait, while several are on their way at once. Internal to jobs.

#include <functional>
#include <mutex>
#include <utility>

#include "core/base/result.h"

namespace toile::jobs {

/// Places for jobs that the store is taking on and that do not stand in the queue yet, so that those who
/// submit need not wait for one another. Thread-safe.
class QueuePlaces {
 public:
  /// Held until it goes. The job is to stand in the queue by then: counted twice for a moment rather than not
  /// at all.
  class Held {
   public:
    Held(Held&& other) noexcept : places_(std::exchange(other.places_, nullptr)), count_(other.count_) {}
    Held& operator=(Held&&) = delete;
    ~Held() {
      if (places_ != nullptr) places_->give_back(count_);
    }

   private:
    friend class QueuePlaces;
    Held(QueuePlaces& places, int count) : places_(&places), count_(count) {}
    QueuePlaces* places_;
    int count_;
  };

  /// `most` may wait; `waiting` tells how many do.
  QueuePlaces(int most, std::function<int()> waiting) : most_(most), waiting_(std::move(waiting)) {}

  /// Whether so many more may wait as things stand. Error: jobs.queue_full.
  Status check(int count) const {
    const std::lock_guard lock(mutex_);
    return check_with_lock(count);
  }
  /// Errors: jobs.queue_full.
  Result<Held> take(int count) {
    const std::lock_guard lock(mutex_);
    TRY(check_with_lock(count));
    held_ += count;
    return Held(*this, count);
  }

 private:
  Status check_with_lock(int count) const {
    if (waiting_() + held_ + count <= most_) return {};
    return Error{"jobs.queue_full", "the queue is full; try again when some drapes have ended", "",
                 ErrorKind::kTooMany};
  }
  void give_back(int count) {
    const std::lock_guard lock(mutex_);
    held_ -= count;
  }

  const int most_;
  const std::function<int()> waiting_;
  mutable std::mutex mutex_;
  int held_ = 0;
};

}  // namespace toile::jobs
