#include "server/http/session.h"

#include <boost/asio/post.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <exception>
#include <utility>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/admission.h"
#include "server/http/event_text.h"
#include "server/http/problem.h"
#include "server/http/request_header.h"
#include "server/ws/on_pool.h"
#include "server/ws/tuple.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

}  // namespace

HttpSession::HttpSession(asio::ip::tcp::socket socket, std::string address, const ConnectionContext& context)
    : stream_(beast::tcp_stream(std::move(socket)), context.tls ? context.tls->now().get() : nullptr),
      address_(std::move(address)),
      context_(context),
      reader_(stream_, context.settings),
      work_(stream_, context),
      writer_(stream_, context.settings.write_within, context.pools.store()),
      asked_("", "", context.log) {}  // nobody has asked yet

asio::awaitable<void> HttpSession::run() {
  const auto self = shared_from_this();
  if (!context_.connections.add(self)) co_return;
  ++context_.metrics.connections;
  try {
    co_await serve();
  } catch (const std::exception& e) {
    // Out of memory, or a socket that went away: it is this connection's end and nobody else's.
    asked_.log.warn("connection broke off", LogFields{{"what", e.what()}});
  }
  --context_.metrics.connections;
  context_.connections.remove(this);
}

asio::awaitable<void> HttpSession::serve() {
  boost::system::error_code ignored;
  stream_.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
  const bool met = co_await shake_hands();
  if (!met) co_return;
  while (!stopping_) {
    const bool arrived = co_await wait_for_request();
    if (!arrived) break;
    const bool again = co_await serve_one();
    if (!again) break;
  }
  if (viewer_) co_return;
  co_await say_good_bye();
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

/// Under TLS, which a client has to begin at once.
asio::awaitable<bool> HttpSession::shake_hands() {
  if (stream_.tls() == nullptr) co_return true;
  idle_ = true;  // a stop ends it
  stream_.expires_after(context_.settings.header_within);
  const auto [failure] = co_await stream_.tls()->async_handshake(asio::ssl::stream_base::server, ws::kTuple);
  idle_ = false;
  co_return !failure;
}

/// So that the other side knows that nothing was cut off. What it says to it is not waited for long.
asio::awaitable<void> HttpSession::say_good_bye() {
  if (stream_.tls() == nullptr || !stream_.socket().is_open()) co_return;
  idle_ = true;
  stream_.expires_after(std::chrono::seconds(1));
  co_await stream_.tls()->async_shutdown(ws::kTuple);
  idle_ = false;
}

/// Until the first byte of a request is there.
asio::awaitable<bool> HttpSession::wait_for_request() {
  if (reader_.has_bytes()) co_return true;
  idle_ = true;
  idle_since_ = Clock::now();
  const bool arrived = co_await reader_.wait();
  idle_ = false;
  idle_since_ = kBusy;
  if (arrived) began_ = Clock::now();
  co_return arrived;
}

/// False when the connection is to end.
asio::awaitable<bool> HttpSession::serve_one() {
  RequestParser parser;
  keep_alive_ = false;
  const boost::system::error_code failure = co_await reader_.read_header(parser);
  if (failure) {
    std::optional<HttpResponse> why = header_refusal(failure);
    if (!why) co_return false;
    const HttpRequest unknown;
    begin_as_nobody(unknown);
    co_return co_await refuse(unknown, std::move(*why));
  }
  HttpRequest request = request_of(parser.get());
  begin_as_nobody(request);
  if (auto wrong = malformed(parser.get(), parser.chunked()))
    co_return co_await refuse(request, std::move(*wrong));
  Incoming incoming;
  if (const auto length = parser.content_length()) incoming.length = *length;
  incoming.has_body = parser.chunked() || incoming.length.value_or(0) > 0;
  incoming.upgrade = beast::websocket::is_upgrade(parser.get());
  keep_alive_ = parser.get().keep_alive() && !incoming.has_body;  // should it be refused
  Admission admission = admit(context_.router, request, incoming, context_.site);
  std::optional<HttpResponse> shut = co_await let_in(request, admission.access, incoming.upgrade);
  if (shut) co_return co_await refuse(request, std::move(*shut));
  if (!admission.route) co_return co_await refuse(request, std::move(admission.refusal));
  co_return co_await serve_known(parser, request, *admission.route, incoming.has_body);
}

/// Once it is known who asks for what.
asio::awaitable<bool> HttpSession::serve_known(RequestParser& parser, HttpRequest& request,
                                               const Route& route, bool has_body) {
  Taken taken(context_.budget);
  if (has_body) {
    keep_alive_ = false;
    const std::size_t most = route.limit(request);
    const boost::system::error_code failure = co_await reader_.read_body(parser, most, taken);
    if (failure) {
      std::optional<HttpResponse> why = body_refusal(failure, most);
      if (!why) co_return false;
      co_return co_await refuse(request, std::move(*why));
    }
    request.body = std::move(parser.get().body());
  }
  HttpResponse response = co_await work_.answer(route, request, asked_, stopping_);
  if (route.websocket && response.status == 200) {
    if (response.watched) asked_ = response.watched->context;
    const std::string job = response.watched ? response.watched->job : request.captures[0];
    co_return co_await serve_stream(parser, job);
  }
  if (request.method == "GET" && feed_after(response)) {
    co_return co_await serve_feed(request, std::move(response));
  }
  const bool again = parser.get().keep_alive() && !stopping_;
  const bool written = co_await answer(request, std::move(response), again);
  co_return written&& again;
}

/// Where there are accounts, until somebody is known.
void HttpSession::begin_as_nobody(const HttpRequest& request) {
  const std::string id = request_id_of(request, context_.request_ids);
  asked_ = context_.gate ? nobody(id, context_.log) : local_user(id, context_.log);
}

/// Whom the last proxy on the way had before it, where there is one; else the other side itself.
std::string HttpSession::sender_of(const HttpRequest& request) const {
  return context_.settings.behind_proxy ? forwarded_for(request).value_or(address_) : address_;
}

/// Before its body is read: who is not known sends us nothing.
asio::awaitable<std::optional<HttpResponse>> HttpSession::let_in(HttpRequest& request, Access access,
                                                                 bool websocket) {
  request.sender = sender_of(request);
  if (!context_.gate || access == Access::kOpen) co_return std::nullopt;
  const auto ask = [this, &request] { return context_.gate->who(credentials_of(request, context_.cookie)); };
  const accounts::Answer answer = co_await ws::on_pool(context_.pools.store(), ask);
  if (!answer.caller) co_return not_let_in(answer.caller.error(), answer.unknown, answer.wait);
  asked_ = context_of(*answer.caller, asked_.request_id, context_.log);
  co_return not_allowed(*answer.caller, access, request, websocket);
}

/// Answers before the body was read. When there is one the connection ends: what is still under way is not
/// looked at.
asio::awaitable<bool> HttpSession::refuse(const HttpRequest& request, HttpResponse response) {
  const bool written = co_await answer(request, std::move(response), keep_alive_ && !stopping_);
  if (written && !keep_alive_ && !stopping_) {
    idle_ = true;  // a stop ends it
    co_await reader_.linger();
    idle_ = false;
  }
  co_return written&& keep_alive_ && !stopping_;
}

asio::awaitable<bool> HttpSession::answer(const HttpRequest& request, HttpResponse response,
                                          bool keep_alive) {
  Taken taken(context_.answers);
  AnswerWriter::take_room(response, taken);
  const bool own_id = request.header("x-request-id") == asked_.request_id;
  AnswerHeader header = answer_header(response, keep_alive, own_id ? asked_.request_id : "");

  // Before it is sent: who has got the answer finds it counted.
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  context_.metrics.count_request(request.method, response.status, response.code, seconds);
  tell(request, response.status, response.code, seconds);
  const bool written = co_await writer_.write(header, response, request.method != "HEAD");
  began_ = Clock::now();
  co_return written;
}

/// What only looks and goes well is told when somebody wants to hear all: a page asks several times a second.
void HttpSession::tell(const HttpRequest& request, int status, const std::string& code,
                       double seconds) const {
  const bool looks = request.method == "GET" || request.method == "HEAD";
  const LogLevel level = status >= 500           ? LogLevel::kError
                         : looks && status < 400 ? LogLevel::kDebug
                                                 : LogLevel::kInfo;
  constexpr std::size_t kLongestTarget = 200;
  const auto ms = static_cast<long long>(seconds * 1000);
  asked_.log.write(level, "answered",
                   {{"method", request.method},
                    {"target", clipped(request.target, kLongestTarget)},
                    {"status", std::to_string(status)},
                    {"code", code},
                    {"ms", std::to_string(ms)}});
}

asio::awaitable<bool> HttpSession::serve_stream(RequestParser& parser, const std::string& job) {
  viewer_ = std::make_shared<ws::StreamSession>(stream_, context_.streams, asked_, job);
  if (stopping_) viewer_->stop();
  ws::StreamSession::Handshake handshake = parser.release();
  co_await viewer_->run(std::move(handshake));
  co_return false;
}

/// The connection ends with it: nobody knows how long the answer is.
asio::awaitable<bool> HttpSession::serve_feed(const HttpRequest& request, HttpResponse response) {
  if (!context_.seats.take(asked_.owner)) {
    HttpResponse full =
        problem({"events.too_many", "you have as many event feeds open as one may; end one of them", "",
                 ErrorKind::kTooMany});
    co_return co_await answer(request, std::move(full), false);
  }
  const SeatTaken seat(context_.seats, asked_.owner);
  EventFeed feed(stream_, writer_, context_.streams, asked_, feed_after(response).value_or(0));
  feed_ = &feed;
  const bool begun = co_await answer(request, std::move(response), false);
  if (begun && !stopping_) co_await feed.run();
  feed_ = nullptr;
  co_return false;
}

void HttpSession::stop() {
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    self->stopping_ = true;
    self->work_.give_up();
    if (self->feed_ != nullptr) self->feed_->stop();
    if (self->viewer_) {
      self->viewer_->stop();
    } else if (self->idle_) {
      boost::system::error_code ignored;
      self->stream_.socket().close(ignored);
    }
  });
}

void HttpSession::make_room() {
  idle_since_ = kBusy;  // not to be asked twice
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    if (!self->idle_ || self->viewer_) return;
    boost::system::error_code ignored;
    self->stream_.socket().close(ignored);
  });
}

}  // namespace toile::http
