#pragma once
// Writes that wait at the same time share one wait for the disk. Internal to the store.

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

#include "core/base/result.h"
#include "server/store/sqlite/database.h"

namespace toile::sqlite {

/// Group commit (DeWitt et al. 1984). Of those who come with a write, one leads: it does all that have come
/// by then, in their order and in one transaction, while the next ones gather. Thread-safe.
class GroupCommit {
 public:
  /// Changes the database, on whichever thread. What it does is undone when it gives an error or throws.
  using Write = std::function<Status()>;

  /// `mutex` guards the database; both outlive this.
  GroupCommit(std::mutex& mutex, SqlDatabase& database) : mutex_(mutex), database_(database) {}

  /// Has `write` done with the mutex held, and returns when the disk has it, or when it has failed: then no
  /// other has failed with it. It may be done again from the beginning, where a write before it has broken
  /// their transaction off. What it throws is thrown here. Errors: its own, those of beginning and
  /// committing.
  Status run(const Write& write);
  /// How many have come and have not been begun.
  std::size_t waiting() const;

 private:
  struct Entry {
    const Write* write = nullptr;
    Status outcome;
    std::exception_ptr thrown;
    bool done = false;  ///< guarded by gate_; all else is the leader's until then

    bool failed() const { return !outcome.ok() || thrown != nullptr; }
  };
  void lead();
  bool commit(const std::vector<Entry*>& batch);
  Status attempt(Entry& entry);

  std::mutex& mutex_;  // before gate_
  SqlDatabase& database_;
  mutable std::mutex gate_;
  std::condition_variable bell_;
  std::vector<Entry*> waiting_;
  bool led_ = false;
};

}  // namespace toile::sqlite
