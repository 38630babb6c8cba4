#pragma once
// What one viewer gets next. Pure: a function of what there is to see and what this viewer has been sent.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "server/ws/channel.h"

namespace toile::ws {

/// Every viewer gets a frame by itself at least this often, so that a lost thread is never lost for long.
inline constexpr std::uint32_t kFramesPerKey = 30;

struct FeedMessage {
  enum class Kind { kTopology, kFrame, kProgress };
  Kind kind = Kind::kFrame;
  /// Shares the bytes with all other viewers of the same moment.
  std::shared_ptr<const std::string> bytes;
};

/// Newest wins: what a viewer was too slow for is never sent. It gets a delta when it has the frame before,
/// else a key. Frames and progress take turns.
class Feed {
 public:
  /// The next message, which counts as sent; nothing when the viewer is up to date.
  std::optional<FeedMessage> next(const ChannelView& view);
  /// The viewer has all there will be.
  bool finished(const ChannelView& view) const { return view.ended && !frame_due(view); }

 private:
  bool frame_due(const ChannelView& view) const;
  FeedMessage take_frame(const ChannelView& view);

  std::shared_ptr<const jobs::StreamTopology> topology_;
  std::uint32_t seq_ = 0;  ///< of the last frame sent in this epoch; 0: none
  std::uint64_t progress_version_ = 0;
  bool frame_last_ = false;
};

}  // namespace toile::ws
