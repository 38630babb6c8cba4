#pragma once
// From who looks at a drape to the worker that has it: hands on the cloth, until the worker looks up.

#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "core/base/result.h"
#include "core/drape/touch.h"

namespace toile::jobs {

/// What a viewer does to the cloth that it sees.
struct LiveTouch {
  std::uint32_t epoch = 0;  ///< of the stream whose triangles it names; 0: it names none
  drape::Touch touch;
  /// Told why it was not taken, from any thread; may be empty, and must not call back.
  std::function<void(const Error&)> refused;
};

/// Thread-safe.
class TouchInbox {
 public:
  static constexpr std::size_t kMost = 256;

  /// Puts a touch behind those that wait; of a hand that draws on, only the newest place is kept. Errors:
  /// live.over once it is closed, live.busy while too many wait.
  Status put(LiveTouch touch);
  /// All that wait, in their order.
  std::vector<LiveTouch> take();
  /// The cloth is done: what waits is refused, and what comes from now on.
  void close();

 private:
  std::mutex mutex_;
  std::vector<LiveTouch> waiting_;
  bool closed_ = false;
};

}  // namespace toile::jobs
