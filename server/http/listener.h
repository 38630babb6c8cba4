#pragma once
// Takes connections on one port. Internal to http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>

#include <optional>
#include <string>

#include "core/base/result.h"
#include "server/http/connection_context.h"

namespace toile::http {

class Listener {
 public:
  Listener(boost::asio::io_context& io, const ConnectionContext& context);

  /// Errors: those of listening_address, server.port when the port cannot be had.
  Status open(const ServerSettings& settings);
  /// Takes connections from now on.
  void start();
  /// From any thread.
  void close();
  int port() const { return port_; }

 private:
  boost::asio::awaitable<void> accept_all();
  bool is_stranger(const boost::asio::ip::address& other, const boost::asio::ip::address& own) const;

  boost::asio::io_context& io_;
  const ConnectionContext& context_;
  boost::asio::ip::tcp::acceptor acceptor_;
  std::optional<boost::asio::ip::address> gateway_;  ///< of the network of a container without accounts
  int port_ = 0;
};

}  // namespace toile::http
