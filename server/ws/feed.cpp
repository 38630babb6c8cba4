#include "server/ws/feed.h"

#include <utility>

namespace toile::ws {

bool Feed::frame_due(const ChannelView& view) const {
  return view.topology != topology_ || (view.frame && (*view.frame)->seq != seq_);
}

FeedMessage Feed::take_frame(const ChannelView& view) {
  const SharedFrame& frame = *view.frame;
  const std::uint32_t had = std::exchange(seq_, frame->seq);
  const bool delta =
      had != 0 && frame->seq == had + 1 && frame->seq % kFramesPerKey != 1 && !frame->delta.empty();
  const std::string& bytes = delta ? frame->delta : frame.key();
  return {FeedMessage::Kind::kFrame, std::shared_ptr<const std::string>(view.frame, &bytes)};
}

std::optional<FeedMessage> Feed::next(const ChannelView& view) {
  if (view.topology && view.topology != topology_) {
    topology_ = view.topology;
    seq_ = 0;
    return FeedMessage{FeedMessage::Kind::kTopology,
                       std::shared_ptr<const std::string>(topology_, &topology_->bytes)};
  }
  const bool progress_due = !view.ended && view.progress_version != progress_version_;
  if (frame_due(view) && !(progress_due && frame_last_)) {
    frame_last_ = true;
    return take_frame(view);
  }
  if (!progress_due) return std::nullopt;
  frame_last_ = false;
  progress_version_ = view.progress_version;
  return FeedMessage{FeedMessage::Kind::kProgress, nullptr};
}

}  // namespace toile::ws
