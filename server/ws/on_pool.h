#pragma once
// Blocking work off the io threads, awaited. Internal to ws and http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <optional>
#include <type_traits>
#include <utility>

namespace toile::ws {

/// Runs `work` on the pool and comes back to the caller's executor with what it returned. The pool must be
/// joined before the caller's frame is destroyed.
template <typename Work>
boost::asio::awaitable<std::invoke_result_t<Work&>> on_pool(boost::asio::thread_pool& pool, Work work) {
  std::optional<std::invoke_result_t<Work&>> out;
  const auto run = [&out, &work]() -> boost::asio::awaitable<void> {
    out.emplace(work());
    co_return;
  };
  co_await boost::asio::co_spawn(pool, run, boost::asio::use_awaitable);
  co_return std::move(*out);
}

}  // namespace toile::ws
