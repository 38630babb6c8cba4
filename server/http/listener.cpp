#include "server/http/listener.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>

#include <chrono>
#include <memory>
#include <utility>

#include "server/http/address_rules.h"
#include "server/http/session.h"
#include "server/http/thrown.h"
#include "server/ws/tuple.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

}  // namespace

Listener::Listener(asio::io_context& io, const ConnectionContext& context)
    : io_(io), context_(context), acceptor_(asio::make_strand(io)) {}

Status Listener::open(const ServerSettings& settings) {
  const int port = settings.port;
  const asio::ip::address address = TRY(listening_address(settings));
  if (settings.container && !settings.gate) gateway_ = default_gateway();
  boost::system::error_code failure;
  const tcp::endpoint place(address, static_cast<std::uint16_t>(port));
  acceptor_.open(place.protocol(), failure);
  if (!failure) acceptor_.set_option(asio::socket_base::reuse_address(true), failure);
  if (!failure) acceptor_.bind(place, failure);
  if (!failure) acceptor_.listen(asio::socket_base::max_listen_connections, failure);
  if (failure) {
    return Error{"server.port", "cannot listen on port " + std::to_string(port) + ": " + failure.message(),
                 settings.address};
  }
  port_ = acceptor_.local_endpoint().port();
  return {};
}

void Listener::start() {
  asio::co_spawn(acceptor_.get_executor(), accept_all(),
                 or_log(context_.log, "no more connections are taken"));
}

void Listener::close() {
  asio::post(acceptor_.get_executor(), [this] {
    boost::system::error_code ignored;
    acceptor_.close(ignored);
  });
}

/// In a container without accounts: whoever is not the machine around it.
bool Listener::is_stranger(const asio::ip::address& other, const asio::ip::address& own) const {
  const ServerSettings& settings = context_.settings;
  return settings.container && !settings.gate && !is_host_of_container(other, own, gateway_);
}

asio::awaitable<void> Listener::accept_all() {
  while (acceptor_.is_open()) {
    auto [failure, socket] = co_await acceptor_.async_accept(asio::make_strand(io_), ws::kTuple);
    if (failure == asio::error::operation_aborted) break;
    if (failure) {  // no more descriptors, most likely: some will be free again
      asio::steady_timer pause(acceptor_.get_executor(), std::chrono::milliseconds(100));
      co_await pause.async_wait(ws::kTuple);
      continue;
    }
    boost::system::error_code gone;
    const tcp::endpoint other = socket.remote_endpoint(gone);
    if (gone) continue;
    const tcp::endpoint own = socket.local_endpoint(gone);
    if (gone || is_stranger(other.address(), own.address())) continue;  // closes it
    const std::string address = other.address().to_string();
    if (!context_.connections.make_room(address, context_.metrics.connections.load(), context_.settings))
      continue;  // closes it
    const auto session = std::make_shared<HttpSession>(std::move(socket), address, context_);
    asio::co_spawn(session->executor(), session->run(), or_log(context_.log, "connection broke off"));
  }
}

}  // namespace toile::http
