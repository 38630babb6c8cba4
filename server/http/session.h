#pragma once
// One HTTP connection. Internal to http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/connection_context.h"
#include "server/http/message.h"
#include "server/ws/line.h"

namespace toile::http {

/// Bytes taken of a budget, given back at the end.
class Taken {
 public:
  explicit Taken(BodyBudget& budget) : budget_(budget) {}
  ~Taken() { budget_.give_back(bytes_); }
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;
  /// Has `bytes` in all from now on; false, and as before, when the budget has not that much.
  bool have(std::size_t bytes) {
    if (bytes <= bytes_) return true;
    if (!budget_.take(bytes - bytes_)) return false;
    bytes_ = bytes;
    return true;
  }

 private:
  BodyBudget& budget_;
  std::size_t bytes_ = 0;
};

/// All members run on the socket's strand, but for those that say otherwise.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  /// `address` is the other side's.
  HttpSession(boost::asio::ip::tcp::socket socket, std::string address, const ConnectionContext& context);

  /// Serves request after request until either side ends it.
  boost::asio::awaitable<void> run();
  boost::asio::any_io_executor executor() { return stream_.get_executor(); }
  /// From any thread: an idle connection ends now, a busy one with its answer, a viewer with a close.
  void stop();
  /// Ends the connection if it is still idle. From any thread; what is asked once counts as busy.
  void make_room();
  /// Since when no request is under way; the latest time while one is. From any thread.
  std::chrono::steady_clock::time_point idle_since() const { return idle_since_.load(); }
  const std::string& address() const { return address_; }

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;
  using Clock = std::chrono::steady_clock;

  boost::asio::awaitable<void> serve();
  boost::asio::awaitable<bool> shake_hands();
  boost::asio::awaitable<void> say_good_bye();
  boost::asio::awaitable<bool> wait_for_request();
  boost::asio::awaitable<bool> serve_one();
  boost::asio::awaitable<boost::system::error_code> read_header(Parser& parser);
  /// Why somebody is not let in; nothing when they are, and what they ask is asked as themselves.
  boost::asio::awaitable<std::optional<HttpResponse>> let_in(HttpRequest& request, Access access,
                                                             bool websocket);
  void begin_as_nobody(const HttpRequest& request);
  std::string sender_of(const HttpRequest& request) const;
  boost::asio::awaitable<bool> refuse(const HttpRequest& request, HttpResponse response);
  boost::asio::awaitable<bool> refuse_header(boost::system::error_code failure);
  boost::asio::awaitable<bool> read_body(Parser& parser, const Route& route, Taken& taken,
                                         HttpRequest& request);
  boost::asio::awaitable<boost::system::error_code> read_all(Parser& parser, Taken& taken);
  boost::asio::awaitable<HttpResponse> have_done(const Route& route, const HttpRequest& request);
  boost::asio::awaitable<HttpResponse> handle(const Route& route, const HttpRequest& request);
  HttpResponse work_on(const Route& route, const HttpRequest& request) const;
  void watch_for_end();
  boost::asio::awaitable<bool> write(const HttpRequest& request, HttpResponse response, bool keep_alive);
  using Header = boost::beast::http::response<boost::beast::http::empty_body>;
  boost::asio::awaitable<bool> write_message(Header& message, const HttpResponse& response, bool body);
  boost::asio::awaitable<bool> write_bytes(std::string_view bytes);
  boost::asio::awaitable<bool> write_file(const AnswerFile& file);
  boost::asio::awaitable<bool> serve_stream(Parser& parser, const HttpRequest& request);
  boost::asio::awaitable<void> linger();
  void tell(const HttpRequest& request, int status, const std::string& code, double seconds) const;

  static constexpr Clock::time_point kBusy = Clock::time_point::max();

  ws::Line stream_;
  const std::string address_;
  std::atomic<Clock::time_point> idle_since_{Clock::now()};
  const ConnectionContext& context_;
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<ws::StreamSession> viewer_;    ///< once the connection is a WebSocket
  Clock::time_point began_;                      ///< of the request at hand
  store::RequestContext asked_;                  ///< whose it is
  std::shared_ptr<std::atomic<bool>> given_up_;  ///< the request at hand: nobody waits for it any more
  bool stopping_ = false, idle_ = false;
  bool keep_alive_ = false;  ///< whether the connection can go on after the request at hand is refused
};

}  // namespace toile::http
