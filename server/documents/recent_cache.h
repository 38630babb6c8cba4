#pragma once
// What was made lately and may be asked for again, by key, up to a budget; what was used longest ago goes
// first.

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace toile::documents {

/// Thread-safe. Two threads that miss at once both make the value; the first one kept stays.
template <typename Value>
class RecentCache {
 public:
  /// `most`: of all sizes together, in the unit that keep() is told.
  explicit RecentCache(std::size_t most) : most_(most) {}

  /// Null where nothing is kept.
  std::shared_ptr<const Value> find(const std::string& key) {
    const std::lock_guard hold(mutex_);
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found->second);
    return found->second->value;
  }

  /// What is larger than the whole budget is not kept.
  void keep(const std::string& key, std::shared_ptr<const Value> value, std::size_t size) {
    const std::lock_guard hold(mutex_);
    if (size > most_ || by_key_.contains(key)) return;
    entries_.push_front({key, std::move(value), size});
    by_key_[key] = entries_.begin();
    for (size_ += size; size_ > most_;) {
      size_ -= entries_.back().size;
      by_key_.erase(entries_.back().key);
      entries_.pop_back();
    }
  }

  std::size_t size() const {
    const std::lock_guard hold(mutex_);
    return size_;
  }

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const Value> value;
    std::size_t size = 0;
  };
  const std::size_t most_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // newest use first
  std::map<std::string, typename std::list<Entry>::iterator> by_key_;
  std::size_t size_ = 0;
};

}  // namespace toile::documents
