#include "server/ws/channel.h"

#include <algorithm>
#include <utility>

#include "proto/cpp/frame_codec.h"

namespace toile::ws {

const std::string& SharedFrame::key() const {
  std::call_once(once_, [this] {
    const proto::FrameHeader header{frame_->epoch, frame_->seq, frame_->step,
                                    static_cast<float>(frame_->time)};
    key_ = proto::encode_key(header, frame_->grid);
  });
  return key_;
}

void Channel::set_topology(std::shared_ptr<const jobs::StreamTopology> topology) {
  const std::lock_guard lock(mutex_);
  view_.topology = std::move(topology);
  view_.frame = nullptr;
  view_.ended = false;  // a job that was cut off runs again
  wake_all();
}

void Channel::set_frame(std::shared_ptr<const jobs::StreamFrame> frame) {
  auto shared = std::make_shared<const SharedFrame>(std::move(frame));
  const std::lock_guard lock(mutex_);
  if (!view_.topology || view_.topology->epoch != (*shared)->epoch) return;
  view_.frame = std::move(shared);
  wake_all();
}

void Channel::set_progress(const jobs::JobProgress& progress) {
  const std::lock_guard lock(mutex_);
  view_.progress = progress;
  ++view_.progress_version;
  wake_all();
}

void Channel::end(const jobs::JobProgress& last) {
  const std::lock_guard lock(mutex_);
  view_.progress = last;
  ++view_.progress_version;
  view_.ended = true;
  wake_all();
}

ChannelView Channel::look() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

void Channel::add(ChannelListener* listener) {
  const std::lock_guard lock(mutex_);
  listeners_.push_back(listener);
}

void Channel::remove(ChannelListener* listener) {
  const std::lock_guard lock(mutex_);
  std::erase(listeners_, listener);
}

std::size_t Channel::listeners() const {
  const std::lock_guard lock(mutex_);
  return listeners_.size();
}

bool Channel::idle() const {
  const std::lock_guard lock(mutex_);
  return listeners_.empty() && !view_.topology && view_.progress_version == 0;
}

void Channel::wake_all() {
  for (ChannelListener* listener : listeners_) listener->wake();
}

}  // namespace toile::ws
