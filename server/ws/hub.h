#pragma once
// Between the worker that drapes and those who look on: jobs publish here without knowing who listens.

#include <atomic>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/jobs/publisher.h"
#include "server/ws/channel.h"

namespace toile::ws {

class Hub;

/// Holds a listener on a job's channel for as long as it lives.
class Subscription {
 public:
  Subscription() = default;
  ~Subscription() { reset(); }
  Subscription(Subscription&& other) noexcept;
  Subscription& operator=(Subscription&& other) noexcept;

  ChannelView look() const { return channel_->look(); }
  void reset();

 private:
  friend class Hub;
  Subscription(Hub& hub, std::string job_id, std::shared_ptr<Channel> channel, ChannelListener* listener);

  Hub* hub_ = nullptr;
  std::string job_id_;
  std::shared_ptr<Channel> channel_;
  ChannelListener* listener_ = nullptr;
};

/// Job → viewers. Never waits for a viewer. Thread-safe.
class Hub final : public jobs::Publisher {
 public:
  /// The last view of an ended job stays until this many other jobs have ended after it.
  static constexpr std::size_t kKeptAfterEnd = 64;

  void topology(const std::string& job_id, std::shared_ptr<const jobs::StreamTopology> topology) override;
  void frame(const std::string& job_id, std::shared_ptr<const jobs::StreamFrame> frame) override;
  void progress(const std::string& job_id, const jobs::JobProgress& progress) override;
  void ended(const std::string& job_id, const jobs::JobProgress& last) override;

  /// `listener` is woken whenever the job has something new, until the subscription goes. The hub must
  /// outlive it.
  Subscription subscribe(const std::string& job_id, ChannelListener* listener);

  /// A number that no other hand on cloth has had.
  int new_hand() { return ++hands_; }

  std::size_t viewers() const;
  std::size_t channels() const;

 private:
  friend class Subscription;
  std::shared_ptr<Channel> channel(const std::string& job_id);
  void forget_if_idle(const std::string& job_id);

  std::atomic<int> hands_{0};
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Channel>> channels_;
  std::deque<std::string> ended_;  ///< ids of channels_, the longest ended first
};

}  // namespace toile::ws
