#pragma once
// One HTTP connection. Internal to http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include <cstdint>
#include <memory>
#include <optional>

#include "server/http/connection_context.h"
#include "server/http/message.h"

namespace toile::http {

/// All members run on the socket's strand, but for stop().
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket, const ConnectionContext& context);

  /// Serves request after request until either side ends it.
  boost::asio::awaitable<void> run();
  boost::asio::any_io_executor executor() { return stream_.get_executor(); }
  /// From any thread: an idle connection ends now, a busy one with its answer, a viewer with a close.
  void stop();

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;
  using Clock = std::chrono::steady_clock;

  boost::asio::awaitable<void> serve();
  boost::asio::awaitable<bool> wait_for_request();
  boost::asio::awaitable<bool> serve_one();
  boost::asio::awaitable<boost::system::error_code> read_header(Parser& parser);
  boost::asio::awaitable<bool> refuse(const HttpRequest& request, HttpResponse response);
  boost::asio::awaitable<bool> refuse_header(boost::system::error_code failure);
  boost::asio::awaitable<bool> read_body(Parser& parser, const Route& route, HttpRequest& request);
  boost::asio::awaitable<HttpResponse> handle(const Route& route, const HttpRequest& request);
  boost::asio::awaitable<bool> write(const HttpRequest& request, HttpResponse response, bool keep_alive);
  boost::asio::awaitable<bool> serve_stream(Parser& parser, const HttpRequest& request);
  boost::asio::awaitable<void> linger();
  void tell(const HttpRequest& request, int status, double seconds) const;

  boost::beast::tcp_stream stream_;
  const ConnectionContext& context_;
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<ws::StreamSession> viewer_;  ///< once the connection is a WebSocket
  Clock::time_point began_;                    ///< of the request at hand
  store::RequestContext asked_;                ///< whose it is
  bool stopping_ = false, idle_ = false;
  bool keep_alive_ = false;  ///< whether the connection can go on after the request at hand is refused
};

}  // namespace toile::http
