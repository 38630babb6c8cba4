#pragma once
// One HTTP connection: who it is, and what comes after what. Internal to http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "server/http/answer_writer.h"
#include "server/http/connection_context.h"
#include "server/http/message.h"
#include "server/http/request_reader.h"
#include "server/http/request_work.h"
#include "server/ws/line.h"

namespace toile::http {

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
  using Clock = std::chrono::steady_clock;

  boost::asio::awaitable<void> serve();
  boost::asio::awaitable<bool> shake_hands();
  boost::asio::awaitable<void> say_good_bye();
  boost::asio::awaitable<bool> wait_for_request();
  boost::asio::awaitable<bool> serve_one();
  boost::asio::awaitable<bool> serve_known(RequestParser& parser, HttpRequest& request, const Route& route,
                                           bool has_body);
  /// Why somebody is not let in; nothing when they are, and what they ask is asked as themselves.
  boost::asio::awaitable<std::optional<HttpResponse>> let_in(HttpRequest& request, Access access,
                                                             bool websocket);
  void begin_as_nobody(const HttpRequest& request);
  std::string sender_of(const HttpRequest& request) const;
  boost::asio::awaitable<bool> refuse(const HttpRequest& request, HttpResponse response);
  boost::asio::awaitable<bool> answer(const HttpRequest& request, HttpResponse response, bool keep_alive);
  boost::asio::awaitable<bool> serve_stream(RequestParser& parser, const std::string& job);
  boost::asio::awaitable<bool> serve_feed(const HttpRequest& request, HttpResponse response);
  void tell(const HttpRequest& request, int status, const std::string& code, double seconds) const;

  static constexpr Clock::time_point kBusy = Clock::time_point::max();

  ws::Line stream_;
  const std::string address_;
  std::atomic<Clock::time_point> idle_since_{Clock::now()};
  const ConnectionContext& context_;
  RequestReader reader_;
  RequestWork work_;
  AnswerWriter writer_;
  std::shared_ptr<ws::StreamSession> viewer_;  ///< once the connection is a WebSocket
  EventFeed* feed_ = nullptr;                  ///< while the connection is one
  Clock::time_point began_;                    ///< of the request at hand
  store::RequestContext asked_;                ///< whose it is
  bool stopping_ = false, idle_ = false;
  bool keep_alive_ = false;  ///< whether the connection can go on after the request at hand is refused
};

}  // namespace toile::http
