#pragma once
// What there is to see of one job right now. A channel holds the newest of everything and no queue, so that
// its cost does not depend on how many look on or how slowly they read.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/jobs/publisher.h"

namespace toile::ws {

/// A frame that many viewers share. Thread-safe.
class SharedFrame {
 public:
  explicit SharedFrame(std::shared_ptr<const jobs::StreamFrame> frame) : frame_(std::move(frame)) {}

  const jobs::StreamFrame& operator*() const { return *frame_; }
  const jobs::StreamFrame* operator->() const { return frame_.get(); }
  /// The frame by itself, encoded when somebody first wants it.
  const std::string& key() const;

 private:
  std::shared_ptr<const jobs::StreamFrame> frame_;
  mutable std::once_flag once_;
  mutable std::string key_;
};

/// A consistent look at a channel.
struct ChannelView {
  std::shared_ptr<const jobs::StreamTopology> topology;  ///< null until the job runs
  std::shared_ptr<const SharedFrame> frame;  ///< newest of the topology's epoch; null until there is one
  jobs::JobProgress progress;
  std::uint64_t progress_version = 0;  ///< rises with every report; 0: none yet
  bool ended = false;
};

/// Somebody who wants to know that there is something new. wake() must return at once and not call back.
class ChannelListener {
 public:
  virtual ~ChannelListener() = default;
  virtual void wake() = 0;
};

/// Thread-safe.
class Channel {
 public:
  void set_topology(std::shared_ptr<const jobs::StreamTopology> topology);
  /// Passed over when it is not of the topology's epoch.
  void set_frame(std::shared_ptr<const jobs::StreamFrame> frame);
  void set_progress(const jobs::JobProgress& progress);
  void end(const jobs::JobProgress& last);

  ChannelView look() const;

  void add(ChannelListener* listener);
  void remove(ChannelListener* listener);
  std::size_t listeners() const;
  /// Nothing was published and nobody listens.
  bool idle() const;

 private:
  void wake_all();  // with mutex_ held

  mutable std::mutex mutex_;
  ChannelView view_;
  std::vector<ChannelListener*> listeners_;
};

}  // namespace toile::ws
