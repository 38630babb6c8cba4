#pragma once
// Threads for work that takes long, which cost whoever asked for it. Internal to http.

#include <boost/asio/async_result.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "server/shares/owner_shares.h"
#include "server/store/request_context.h"

namespace toile::http {

/// Of all that waits, what is begun next is the oldest of the owner who has had least of the threads' time.
/// So whoever sends much heavy work waits for it himself, and others do not. Thread-safe.
class FairPool {
 public:
  /// At most `most_waiting` of one owner wait.
  FairPool(std::size_t threads, std::size_t most_waiting) : most_waiting_(most_waiting), threads_(threads) {}

  /// Has `work` done on one of the threads. False when too much of this owner waits already. What it throws
  /// ends the program.
  [[nodiscard]] bool post(const store::OwnerId& owner, std::function<void()> work);
  /// Waits until all is done that was posted.
  void join() { threads_.join(); }
  /// s of the threads that each owner has had, as far as it is remembered.
  double had(const store::OwnerId& owner) const;

 private:
  struct Task {
    store::OwnerId owner;
    std::function<void()> work;
  };
  void do_next();
  Task take();

  const std::size_t most_waiting_;
  mutable std::mutex mutex_;
  std::map<store::OwnerId, std::deque<std::function<void()>>> waiting_;  ///< none is empty
  shares::OwnerShares shares_;
  boost::asio::thread_pool threads_;  // last: it works on the others
};

/// Has `work` done on the pool and comes back to the caller's executor; false, with nothing done, when the
/// pool takes no more of this owner. The pool must be joined before the caller's frame is destroyed.
inline boost::asio::awaitable<bool> on_fair_pool(FairPool& pool, const store::OwnerId& owner,
                                                 std::function<void()> work) {
  namespace asio = boost::asio;
  const auto executor = co_await asio::this_coro::executor;
  const auto start = [&](auto handler) {
    const auto kept = std::make_shared<decltype(handler)>(std::move(handler));  // a function is copied
    const auto finish = [executor, kept](bool taken) {
      asio::post(executor, [kept, taken] { std::move (*kept)(taken); });
    };
    const bool taken = pool.post(owner, [work = std::move(work), finish] {
      work();
      finish(true);
    });
    if (!taken) finish(false);
  };
  co_return co_await asio::async_initiate<const asio::use_awaitable_t<>&, void(bool)>(start,
                                                                                      asio::use_awaitable);
}

}  // namespace toile::http
