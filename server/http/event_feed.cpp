#include "server/http/event_feed.h"

#include <boost/asio/steady_timer.hpp>

#include <sys/socket.h>

#include <utility>

#include "server/http/event_text.h"
#include "server/ws/on_pool.h"
#include "server/ws/tuple.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;

constexpr auto kLookEvery = std::chrono::milliseconds(250);
constexpr auto kSignEvery = std::chrono::seconds(15);  // so that proxies and we see that the other side lives
constexpr int kAtOnce = 100;

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

}  // namespace

bool FeedSeats::take(const store::OwnerId& owner) {
  const std::lock_guard hold(mutex_);
  int& taken = taken_[owner];
  if (taken >= kMost) return false;
  ++taken;
  return true;
}

void FeedSeats::leave(const store::OwnerId& owner) {
  const std::lock_guard hold(mutex_);
  const auto found = taken_.find(owner);
  if (found != taken_.end() && --found->second == 0) taken_.erase(found);
}

EventFeed::EventFeed(ws::Line line, AnswerWriter& writer, const ws::StreamServices& services,
                     const store::RequestContext& asked, std::int64_t after)
    : line_(std::move(line)),
      writer_(writer),
      services_(services),
      asked_(asked),
      events_(store::events_of(services.store)),
      after_(after) {}

asio::awaitable<void> EventFeed::run() {
  watch_for_end();
  while (!over_ && !*gone_ && events_ != nullptr) {
    const bool told = co_await tell_news();
    if (!told) break;
    const bool good = co_await may_go_on();
    if (!good || over_) break;
    asio::steady_timer pause(line_.get_executor(), kLookEvery);
    co_await pause.async_wait(ws::kTuple);
  }
  boost::system::error_code ignored;
  line_.socket().cancel(ignored);
}

/// Who has gone leaves the seat to others. One that sends something all the same is not watched any further.
void EventFeed::watch_for_end() {
  line_.socket().async_wait(asio::ip::tcp::socket::wait_read,
                            [line = line_, gone = gone_](boost::system::error_code cancelled) mutable {
                              if (cancelled) return;
                              char byte = 0;
                              const int socket = line.socket().native_handle();
                              *gone = ::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
                            });
}

/// False when the other side is gone, or the store tells nothing.
asio::awaitable<bool> EventFeed::tell_news() {
  const auto look = [this] { return events_->events_after(asked_.owner, after_, kAtOnce); };
  const Result<std::vector<store::EventRow>> news = co_await ws::on_pool(services_.pool, look);
  if (!news) {
    asked_.log.warn("event feed ended: the store tells nothing", news.error());
    co_return false;
  }
  std::string text;
  if (!news->empty()) {
    text = event_text(*news, after_);
    after_ = news->back().number;
  } else if (Clock::now() - told_ > kSignEvery) {
    text = ":\n\n";
  }
  if (text.empty()) co_return true;
  told_ = Clock::now();
  co_return co_await writer_.write_bytes(text);
}

/// Who is not known any more hears no more.
asio::awaitable<bool> EventFeed::may_go_on() {
  if (!services_.may_go_on || Clock::now() - checked_ < services_.settings.check_every) co_return true;
  checked_ = Clock::now();
  const auto look = [this] { return services_.may_go_on(asked_); };
  co_return co_await ws::on_pool(services_.pool, look);
}

}  // namespace toile::http
