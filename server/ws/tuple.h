#pragma once
// How ws and http wait for the network. Internal to them.

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/use_awaitable.hpp>

namespace toile::ws {

/// With it failures come as values: const auto [failure, size] = co_await line.async_read_some(buffer,
/// kTuple).
inline constexpr auto kTuple = boost::asio::as_tuple(boost::asio::use_awaitable);

}  // namespace toile::ws
