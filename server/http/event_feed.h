#pragma once
// An answer that does not end: what becomes of somebody's jobs, told as it happens. Internal to http.

#include <boost/asio/awaitable.hpp>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "server/http/answer_writer.h"
#include "server/store/events.h"
#include "server/ws/line.h"
#include "server/ws/session.h"

namespace toile::http {

/// How many feeds an owner has open: they hold connections. Thread-safe.
class FeedSeats {
 public:
  static constexpr int kMost = 16;
  /// False when the owner has as many already.
  [[nodiscard]] bool take(const store::OwnerId& owner);
  void leave(const store::OwnerId& owner);

 private:
  std::mutex mutex_;
  std::map<store::OwnerId, int> taken_;  ///< none is 0
};

/// One that was taken, left with this.
class SeatTaken {
 public:
  SeatTaken(FeedSeats& seats, store::OwnerId owner) : seats_(seats), owner_(std::move(owner)) {}
  ~SeatTaken() { seats_.leave(owner_); }
  SeatTaken(const SeatTaken&) = delete;
  SeatTaken& operator=(const SeatTaken&) = delete;

 private:
  FeedSeats& seats_;
  const store::OwnerId owner_;
};

/// The store is asked four times a second, so that what other processes do is told as well. It ends when the
/// other side goes or does not read, when its key is good no more, and when somebody says so. All functions
/// run on the socket's strand.
class EventFeed {
 public:
  EventFeed(ws::Line line, AnswerWriter& writer, const ws::StreamServices& services,
            const store::RequestContext& asked, std::int64_t after);
  /// After the answer's beginning has been written.
  boost::asio::awaitable<void> run();
  /// It ends when it looks next.
  void stop() { over_ = true; }

 private:
  using Clock = std::chrono::steady_clock;
  boost::asio::awaitable<bool> tell_news();
  boost::asio::awaitable<bool> may_go_on();
  void watch_for_end();

  ws::Line line_;

  AnswerWriter& writer_;
  const ws::StreamServices& services_;
  const store::RequestContext& asked_;
  store::Events* const events_;
  std::int64_t after_;  ///< the last that has been told
  Clock::time_point told_ = Clock::now(), checked_ = Clock::now();
  const std::shared_ptr<bool> gone_ = std::make_shared<bool>(false);  ///< the other side is
  bool over_ = false;
};

}  // namespace toile::http
