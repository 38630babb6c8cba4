#include "server/store/sqlite/group_commit.h"

#include <utility>

namespace toile::sqlite {

Status GroupCommit::run(const Write& write) {
  Entry mine;
  mine.write = &write;
  std::unique_lock lock(gate_);
  waiting_.push_back(&mine);
  bell_.wait(lock, [&] { return mine.done || !led_; });
  if (!mine.done) {
    led_ = true;
    lock.unlock();
    lead();
  }
  if (mine.thrown) std::rethrow_exception(mine.thrown);
  return std::move(mine.outcome);
}

std::size_t GroupCommit::waiting() const {
  const std::lock_guard lock(gate_);
  return waiting_.size();
}

/// For all that have come when it is its turn with the database; its own is among them.
void GroupCommit::lead() {
  std::vector<Entry*> batch;
  {
    const std::lock_guard hold(mutex_);
    {
      const std::lock_guard lock(gate_);
      batch = std::exchange(waiting_, {});
    }
    while (!commit(batch)) {
    }
  }
  {
    const std::lock_guard lock(gate_);
    for (Entry* entry : batch) entry->done = true;
    led_ = false;
  }
  bell_.notify_all();
}

/// One transaction for all that have not failed. False: one more has failed, and its end was that of the
/// transaction, so that the others are to be done again.
bool GroupCommit::commit(const std::vector<Entry*>& batch) {
  const auto fail_the_rest = [&](const Error& error) {
    for (Entry* entry : batch) {
      if (!entry->failed()) entry->outcome = error;
    }
  };
  Result<SqlTransaction> transaction = SqlTransaction::begin(database_);
  if (!transaction) {
    fail_the_rest(transaction.error());
    return true;
  }
  for (Entry* entry : batch) {
    if (entry->failed()) continue;
    const Status kept = attempt(*entry);
    if (kept && database_.in_transaction()) continue;
    if (!entry->failed())
      entry->outcome =
          kept ? Error{"store.failed", "the database gave up what was to be written", "", ErrorKind::kSystem}
               : kept.error();
    return false;
  }
  if (const Status committed = transaction->commit(); !committed) fail_the_rest(committed.error());
  return true;
}

/// Does one write within the transaction, or leaves no trace of it. Error: it may have left some.
Status GroupCommit::attempt(Entry& entry) {
  TRY(database_.run_script("SAVEPOINT one"));
  try {
    entry.outcome = (*entry.write)();
  } catch (...) {  // its caller's, who is on another thread
    entry.thrown = std::current_exception();
  }
  if (!entry.failed()) return database_.run_script("RELEASE one");
  return database_.run_script("ROLLBACK TO one; RELEASE one");
}

}  // namespace toile::sqlite
