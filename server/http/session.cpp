#include "server/http/session.h"

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <sys/socket.h>

#include <array>
#include <ctime>
#include <exception>
#include <new>
#include <sstream>
#include <utility>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/admission.h"
#include "server/http/problem.h"
#include "server/http/request_header.h"
#include "server/ws/on_pool.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

constexpr auto kTuple = asio::as_tuple(asio::use_awaitable);
constexpr std::size_t kBufferBytes = 64 << 10;
constexpr std::size_t kPieceBytes = 256 << 10;  // of an answer: what a connection that does not read can hold

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

// Why a body is not read to its end, beside what Beast says.
const boost::system::error_code kNoRoom = asio::error::no_memory;   // the budget is spent
const boost::system::error_code kTooSlow = asio::error::timed_out;  // Beast's own timeout is another

HttpResponse busy() {
  return problem(503, {"server.busy", "too many uploads or large answers at once; try again in a few seconds",
                       "", ErrorKind::kUnavailable});
}

HttpResponse broke(const char* code, const char* words) { return problem(500, {code, words, ""}); }

/// "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7), of now.
std::string http_date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 40> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%a, %d %b %Y %H:%M:%S GMT", &utc);
  return {text.data(), size};
}

template <typename Message>
std::string header_text(const Message& message) {
  std::ostringstream out;
  out << message.base();
  return out.str();
}

HttpResponse gave_up() {
  return problem(
      503, {"server.gave_up", "this took too long, or the server is stopping", "", ErrorKind::kUnavailable});
}

}  // namespace

HttpSession::HttpSession(asio::ip::tcp::socket socket, std::string address, const ConnectionContext& context)
    : stream_(beast::tcp_stream(std::move(socket)), context.tls),
      address_(std::move(address)),
      context_(context),
      buffer_(kBufferBytes),
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
  const auto [failure] = co_await stream_.tls()->async_handshake(asio::ssl::stream_base::server, kTuple);
  idle_ = false;
  co_return !failure;
}

/// So that the other side knows that nothing was cut off. What it says to it is not waited for long.
asio::awaitable<void> HttpSession::say_good_bye() {
  if (stream_.tls() == nullptr || !stream_.socket().is_open()) co_return;
  idle_ = true;
  stream_.expires_after(std::chrono::seconds(1));
  co_await stream_.tls()->async_shutdown(kTuple);
  idle_ = false;
}

/// Until the first byte of a request is there.
asio::awaitable<bool> HttpSession::wait_for_request() {
  if (buffer_.size() > 0) co_return true;
  idle_ = true;
  idle_since_ = Clock::now();
  stream_.expires_after(context_.settings.idle_within);
  const auto [failure, size] = co_await stream_.async_read_some(buffer_.prepare(4096), kTuple);
  idle_ = false;
  idle_since_ = kBusy;
  if (failure) co_return false;
  buffer_.commit(size);
  began_ = Clock::now();
  co_return true;
}

/// False when the connection is to end.
asio::awaitable<bool> HttpSession::serve_one() {
  Parser parser;
  keep_alive_ = false;
  parser.header_limit(static_cast<std::uint32_t>(context_.settings.most_header_bytes));
  parser.body_limit(boost::none);  // known once the route is
  stream_.expires_after(context_.settings.header_within);
  const boost::system::error_code failure = co_await read_header(parser);
  if (failure) co_return co_await refuse_header(failure);

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

  const Route& route = *admission.route;
  Taken taken(context_.budget);
  if (incoming.has_body) {
    keep_alive_ = false;
    const bool whole = co_await read_body(parser, route, taken, request);
    if (!whole) co_return false;
  }
  HttpResponse response = co_await handle(route, request);
  if (route.websocket && response.status == 200) co_return co_await serve_stream(parser, request);
  const bool again = parser.get().keep_alive() && !stopping_;
  const bool written = co_await write(request, std::move(response), again);
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

/// Beast's own limit holds for the start line and for single fields, not for all fields together.
asio::awaitable<boost::system::error_code> HttpSession::read_header(Parser& parser) {
  std::size_t total = 0;
  while (!parser.is_header_done()) {
    const auto [failure, size] = co_await http::async_read_some(stream_, buffer_, parser, kTuple);
    if (failure) co_return failure;
    total += size;
    if (total > context_.settings.most_header_bytes) co_return make_error_code(http::error::header_limit);
  }
  co_return boost::system::error_code();
}

/// What could not even be read as a header.
asio::awaitable<bool> HttpSession::refuse_header(boost::system::error_code failure) {
  const bool parsing = failure.category() == http::make_error_code(http::error::bad_method).category();
  if (!parsing || failure == http::error::end_of_stream || failure == http::error::partial_message) {
    co_return false;  // gone, or too slow
  }
  const bool large = failure == http::error::header_limit || failure == http::error::buffer_overflow;
  HttpResponse response =
      large ? problem(431, {"http.header_too_large", "the header is larger than is read here", ""})
            : problem(400, {"http.malformed", "this is not HTTP: " + failure.message(), ""});
  const HttpRequest unknown;
  begin_as_nobody(unknown);
  co_return co_await refuse(unknown, std::move(response));
}

/// Answers before the body was read. When there is one the connection ends: what is still under way is not
/// looked at.
asio::awaitable<bool> HttpSession::refuse(const HttpRequest& request, HttpResponse response) {
  const bool written = co_await write(request, std::move(response), keep_alive_ && !stopping_);
  if (written && !keep_alive_) co_await linger();
  co_return written&& keep_alive_ && !stopping_;
}

/// Reads away what the other side still sends, for a while: closing on unread bytes would reset the
/// connection and could take the answer with it.
asio::awaitable<void> HttpSession::linger() {
  constexpr std::size_t kMostBytes = std::size_t{128} << 20;
  constexpr auto kLongest = std::chrono::seconds(3);
  boost::system::error_code ignored;
  if (stream_.tls() == nullptr) stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  buffer_.clear();
  stream_.expires_after(kLongest);
  idle_ = true;
  for (std::size_t seen = 0; seen < kMostBytes && !stopping_;) {
    const auto [failure, size] = co_await stream_.async_read_some(buffer_.prepare(kBufferBytes), kTuple);
    if (failure) break;
    seen += size;
  }
  idle_ = false;
}

/// Until the body is whole. What comes counts against the budget as it comes: who announces much and sends
/// nothing takes nothing from others, and is not waited for.
asio::awaitable<boost::system::error_code> HttpSession::read_all(Parser& parser, Taken& taken) {
  const ServerSettings& settings = context_.settings;
  const Clock::time_point began = Clock::now();
  parser.eager(true);
  while (!parser.is_done()) {
    stream_.expires_after(settings.body_pause_within);
    const auto [failure, size] = co_await http::async_read_some(stream_, buffer_, parser, kTuple);
    if (failure) co_return failure;
    const std::size_t has = parser.get().body().size();
    if (!taken.have(has)) co_return kNoRoom;
    const std::chrono::duration<double> late = Clock::now() - began - settings.slow_for;
    if (late.count() * static_cast<double>(settings.least_body_rate) > static_cast<double>(has))
      co_return kTooSlow;
  }
  co_return boost::system::error_code();
}

asio::awaitable<bool> HttpSession::read_body(Parser& parser, const Route& route, Taken& taken,
                                             HttpRequest& request) {
  parser.body_limit(route.limit(request));
  if (beast::iequals(parser.get()[http::field::expect], "100-continue")) {
    static constexpr std::string_view kGoOn = "HTTP/1.1 100 Continue\r\n\r\n";
    const auto [failure, size] = co_await asio::async_write(stream_, asio::buffer(kGoOn), kTuple);
    if (failure) co_return false;
  }
  const boost::system::error_code failure = co_await read_all(parser, taken);
  if (!failure) {
    request.body = std::move(parser.get().body());
    co_return true;
  }
  if (failure == kNoRoom) co_return co_await refuse(request, busy());
  if (failure == kTooSlow) {
    HttpResponse slow = problem(408, {"http.too_slow", "the body came too slowly; send it again", ""});
    co_return co_await refuse(request, std::move(slow));
  }
  if (failure == http::error::body_limit) {
    const std::string most = std::to_string(route.limit(request));
    HttpResponse large =
        problem(413, {"http.too_large", "the body has more than the " + most + " bytes allowed here", ""});
    co_return co_await refuse(request, std::move(large));
  }
  const bool parsing = failure.category() == http::make_error_code(http::error::bad_chunk).category();
  if (!parsing || failure == http::error::partial_message || failure == http::error::end_of_stream)
    co_return false;
  HttpResponse broken = problem(400, {"http.malformed", "this is not HTTP: " + failure.message(), ""});
  co_return co_await refuse(request, std::move(broken));
}

/// On a thread of the route's kind of work. What waited so long for one that nobody waits for it is not
/// begun.
HttpResponse HttpSession::work_on(const Route& route, const HttpRequest& request) const {
  try {
    if (asked_.is_given_up()) return gave_up();
    HttpResponse response = route.handler(asked_, request);
    return asked_.is_given_up() && response.status >= 500 ? gave_up() : response;
  } catch (const std::bad_alloc&) {
    asked_.log.error("handler ran out of memory", LogFields{{"route", route.pattern}});
    return broke("internal.memory", "there is not enough memory for this");
  } catch (const std::exception& e) {
    asked_.log.error("handler threw", LogFields{{"route", route.pattern}, {"what", e.what()}});
    return broke("internal.exception", e.what());
  } catch (...) {  // it must not leave a thread of a pool
    asked_.log.error("handler threw what is no exception", LogFields{{"route", route.pattern}});
    return broke("internal.unknown", "the handler broke off for a reason that it did not name");
  }
}

/// Heavy work waits its owner's turn.
asio::awaitable<HttpResponse> HttpSession::have_done(const Route& route, const HttpRequest& request) {
  const auto work = [this, &route, &request] { return work_on(route, request); };
  FairPool* const fair = context_.pools.fair(route.work);
  if (fair == nullptr) {
    auto& pool = route.work == Work::kDocument ? context_.pools.document() : context_.pools.store();
    co_return co_await ws::on_pool(pool, work);
  }
  std::optional<HttpResponse> response;
  const bool taken = co_await on_fair_pool(*fair, asked_.owner, [&] { response = work(); });
  if (taken) co_return std::move(*response);
  co_return problem({"server.too_much_at_once",
                     "too much that you have asked for waits already; try again when some of it is done", "",
                     ErrorKind::kTooMany});
}

/// Work is given up when the other side ends the connection, when it takes too long, and when the server
/// stops.
asio::awaitable<HttpResponse> HttpSession::handle(const Route& route, const HttpRequest& request) {
  const auto given_up = std::make_shared<std::atomic<bool>>(stopping_);
  given_up_ = given_up;
  asked_.given_up = given_up;
  asio::steady_timer limit(stream_.get_executor(), context_.settings.work_within);
  limit.async_wait([given_up](boost::system::error_code cancelled) {
    if (!cancelled) given_up->store(true);
  });
  const bool watched = route.work != Work::kStore;
  if (watched) watch_for_end();
  HttpResponse response = co_await have_done(route, request);
  boost::system::error_code ignored;
  if (watched) stream_.socket().cancel(ignored);
  given_up_ = nullptr;
  co_return response;
}

/// Looks whether the other side has gone while its request is worked on. One that has sent its next request
/// already is not watched any further.
void HttpSession::watch_for_end() {
  auto readable = [self = shared_from_this(), given_up = given_up_](boost::system::error_code cancelled) {
    if (cancelled) return;
    char byte = 0;
    const int socket = self->stream_.socket().native_handle();
    if (::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0) given_up->store(true);
  };
  stream_.socket().async_wait(asio::ip::tcp::socket::wait_read, std::move(readable));
}

/// Piece by piece, each within a time: who does not read is not waited for.
asio::awaitable<bool> HttpSession::write_bytes(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::string_view piece = bytes.substr(0, kPieceBytes);
    stream_.expires_after(context_.settings.write_within);
    const auto [failure, size] = co_await asio::async_write(stream_, asio::buffer(piece), kTuple);
    if (failure) co_return false;
    bytes.remove_prefix(piece.size());
  }
  co_return true;
}

/// The disk is not waited for on a thread of the sockets.
asio::awaitable<bool> HttpSession::write_file(const AnswerFile& file) {
  for (std::uint64_t at = 0; at < file.size();) {
    const std::string piece =
        co_await ws::on_pool(context_.pools.store(), [&file, at] { return file.read(at, kPieceBytes); });
    if (piece.empty()) co_return false;  // it has become shorter: the other side sees that it is cut off
    const bool written = co_await write_bytes(piece);
    if (!written) co_return false;
    at += piece.size();
  }
  co_return true;
}

asio::awaitable<bool> HttpSession::write(const HttpRequest& request, HttpResponse response, bool keep_alive) {
  Taken taken(context_.answers);
  if (response.body.size() > kPieceBytes && !taken.have(response.body.size())) response = busy();
  const bool bodiless = response.status == 204 || response.status == 304;
  http::response<http::empty_body> message;
  message.version(11);
  message.result(static_cast<unsigned>(response.status));
  message.reason(status_phrase(response.status));
  message.keep_alive(keep_alive);
  message.set(http::field::server, "toile");
  message.set(http::field::date, http_date());
  message.set("X-Content-Type-Options", "nosniff");
  message.set("Referrer-Policy", "no-referrer");
  message.set("Cross-Origin-Resource-Policy", "same-origin");
  if (!response.content_type.empty()) message.set(http::field::content_type, response.content_type);
  if (request.header("x-request-id") == asked_.request_id) message.set("X-Request-Id", asked_.request_id);
  for (const auto& [name, value] : response.headers) message.set(name, value);
  if (!bodiless) message.content_length(response.file ? response.file->size() : response.body.size());

  // Before it is sent: who has got the answer finds it counted.
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  context_.metrics.count_request(request.method, response.status, response.code, seconds);
  tell(request, response.status, response.code, seconds);
  const bool written = co_await write_message(message, response, request.method != "HEAD" && !bodiless);
  began_ = Clock::now();
  co_return written;
}

asio::awaitable<bool> HttpSession::write_message(Header& message, const HttpResponse& response, bool body) {
  stream_.expires_after(context_.settings.write_within);
  http::response_serializer<http::empty_body> serializer(message);
  // A small answer goes with its header in one piece.
  if (body && !response.file && response.body.size() <= kPieceBytes) {
    std::string whole = header_text(message);
    whole += response.body;
    co_return co_await write_bytes(whole);
  }
  const auto [failure, size] = co_await http::async_write_header(stream_, serializer, kTuple);
  if (failure) co_return false;
  if (!body) co_return true;
  if (response.file) co_return co_await write_file(*response.file);
  co_return co_await write_bytes(response.body);
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

asio::awaitable<bool> HttpSession::serve_stream(Parser& parser, const HttpRequest& request) {
  viewer_ = std::make_shared<ws::StreamSession>(stream_, context_.streams, asked_, request.captures[0]);
  if (stopping_) viewer_->stop();
  ws::StreamSession::Handshake handshake = parser.release();
  co_await viewer_->run(std::move(handshake));
  co_return false;
}

void HttpSession::stop() {
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    self->stopping_ = true;
    if (self->given_up_) self->given_up_->store(true);
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
