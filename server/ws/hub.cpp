#include "server/ws/hub.h"

#include <algorithm>
#include <utility>

namespace toile::ws {

Subscription::Subscription(Hub& hub, std::string job_id, std::shared_ptr<Channel> channel,
                           ChannelListener* listener)
    : hub_(&hub), job_id_(std::move(job_id)), channel_(std::move(channel)), listener_(listener) {}

Subscription::Subscription(Subscription&& other) noexcept { *this = std::move(other); }

Subscription& Subscription::operator=(Subscription&& other) noexcept {
  if (this == &other) return *this;
  reset();
  hub_ = std::exchange(other.hub_, nullptr);
  job_id_ = std::move(other.job_id_);
  channel_ = std::move(other.channel_);
  listener_ = std::exchange(other.listener_, nullptr);
  return *this;
}

void Subscription::reset() {
  if (!hub_) return;
  channel_->remove(listener_);
  channel_.reset();
  std::exchange(hub_, nullptr)->forget_if_idle(job_id_);
}

void Hub::topology(const std::string& job_id, std::shared_ptr<const jobs::StreamTopology> topology) {
  channel(job_id)->set_topology(std::move(topology));
  const std::lock_guard lock(mutex_);
  std::erase(ended_, job_id);
}

void Hub::frame(const std::string& job_id, std::shared_ptr<const jobs::StreamFrame> frame) {
  channel(job_id)->set_frame(std::move(frame));
}

void Hub::progress(const std::string& job_id, const jobs::JobProgress& progress) {
  channel(job_id)->set_progress(progress);
}

void Hub::ended(const std::string& job_id, const jobs::JobProgress& last) {
  channel(job_id)->end(last);
  const std::lock_guard lock(mutex_);
  std::erase(ended_, job_id);
  ended_.push_back(job_id);
  while (ended_.size() > kKeptAfterEnd) {  // viewers that are still there hold their channel by themselves
    channels_.erase(ended_.front());
    ended_.pop_front();
  }
}

Subscription Hub::subscribe(const std::string& job_id, ChannelListener* listener) {
  const std::lock_guard lock(mutex_);  // so that nobody forgets the channel before the listener is on it
  std::shared_ptr<Channel>& found = channels_[job_id];
  if (!found) found = std::make_shared<Channel>();
  found->add(listener);
  return {*this, job_id, found, listener};
}

std::size_t Hub::viewers() const {
  const std::lock_guard lock(mutex_);
  std::size_t sum = 0;
  for (const auto& [id, channel] : channels_) sum += channel->listeners();
  return sum;
}

std::size_t Hub::channels() const {
  const std::lock_guard lock(mutex_);
  return channels_.size();
}

std::shared_ptr<Channel> Hub::channel(const std::string& job_id) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<Channel>& found = channels_[job_id];
  if (!found) found = std::make_shared<Channel>();
  return found;
}

/// A channel that somebody holds beside the map is about to be published on: copies are made under the lock.
void Hub::forget_if_idle(const std::string& job_id) {
  const std::lock_guard lock(mutex_);
  const auto found = channels_.find(job_id);
  if (found == channels_.end() || found->second.use_count() > 1) return;
  if (found->second->idle()) channels_.erase(found);
}

}  // namespace toile::ws
