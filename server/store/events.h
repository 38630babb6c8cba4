#pragma once
// What became of an owner's jobs, one event after the other: made, taken, paused, ended, removed. The store
// writes them where it writes the job, in the same transaction, whichever process does it.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/store/store.h"

namespace toile::store {

/// A job's new state, or that it is gone.
struct EventRow {
  std::int64_t number = 0;  ///< rises by one within the owner
  std::int64_t at_ms = 0;   ///< Unix time
  std::string job, project_id, name;
  std::string state;        ///< a JobState's word, or kRemoved
  std::string reason_code;  ///< of a final state
  std::string sweep;  ///< the job's; without a job the event is the sweep's own: its end, or that it is gone
};

inline constexpr const char* kRemoved = "removed";

/// Calls are thread-safe, as those of Store, with its errors. The newest thousand of an owner are kept.
class Events {
 public:
  virtual ~Events() = default;
  /// Those with numbers above `number`, the oldest first, at most `limit`. Where the first is not the next,
  /// some between are kept no more.
  virtual Result<std::vector<EventRow>> events_after(const OwnerId& owner, std::int64_t number,
                                                     int limit) = 0;
  /// 0: there was none.
  virtual Result<std::int64_t> newest_event(const OwnerId& owner) = 0;
};

/// Those of a store that keeps events; null else.
inline Events* events_of(Store& store) { return dynamic_cast<Events*>(&store); }

}  // namespace toile::store
