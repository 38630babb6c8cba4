#pragma once
// A connection's bytes, as they are or under TLS: one type, so that sessions and viewers are written once.
// Internal to ws and http.

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace toile::ws {

/// A handle: copies are the same connection. What Beast asks of a stream, and no more.
class Line {
 public:
  using next_layer_type = boost::beast::tcp_stream;
  using executor_type = next_layer_type::executor_type;
  using Tls = boost::asio::ssl::stream<boost::beast::tcp_stream&>;

  /// `tls` outlives this; null: bytes as they are.
  explicit Line(boost::beast::tcp_stream tcp, boost::asio::ssl::context* tls = nullptr)
      : parts_(std::make_shared<Parts>(std::move(tcp))) {
    if (tls != nullptr) parts_->tls.emplace(parts_->tcp, *tls);
  }

  executor_type get_executor() noexcept { return parts_->tcp.get_executor(); }
  next_layer_type& next_layer() noexcept { return parts_->tcp; }
  const next_layer_type& next_layer() const noexcept { return parts_->tcp; }
  boost::asio::ip::tcp::socket& socket() { return parts_->tcp.socket(); }
  /// For what is begun next; TLS has no time of its own.
  void expires_after(std::chrono::steady_clock::duration time) { parts_->tcp.expires_after(time); }
  /// Null: bytes go as they are.
  Tls* tls() { return parts_->tls ? &*parts_->tls : nullptr; }

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    if (parts_->tls) return parts_->tls->async_read_some(buffers, std::forward<Token>(token));
    return parts_->tcp.async_read_some(buffers, std::forward<Token>(token));
  }
  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    if (parts_->tls) return parts_->tls->async_write_some(buffers, std::forward<Token>(token));
    return parts_->tcp.async_write_some(buffers, std::forward<Token>(token));
  }

 private:
  struct Parts {
    explicit Parts(boost::beast::tcp_stream stream) : tcp(std::move(stream)) {}
    boost::beast::tcp_stream tcp;
    std::optional<Tls> tls;  // works on tcp
  };
  std::shared_ptr<Parts> parts_;
};

/// How a WebSocket's connection ends once both sides have said so. Beast looks for it by this name.
template <typename Handler>
void async_teardown(boost::beast::role_type role, Line& line, Handler&& handler) {
  if (line.tls() != nullptr) {
    boost::beast::async_teardown(role, *line.tls(), std::forward<Handler>(handler));
  } else {
    boost::beast::websocket::async_teardown(role, line.socket(), std::forward<Handler>(handler));
  }
}

}  // namespace toile::ws
