#include "server/http/session.h"

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <utility>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/admission.h"
#include "server/http/problem.h"
#include "server/ws/on_pool.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

constexpr auto kTuple = asio::as_tuple(asio::use_awaitable);
constexpr std::size_t kBufferBytes = 64 << 10;

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

std::string text_of(beast::string_view view) { return {view.data(), view.size()}; }

template <typename Header>
HttpRequest request_of(const Header& header) {
  HttpRequest request;
  request.method = text_of(header.method_string());
  request.target = text_of(header.target());
  for (const auto& field : header) {
    request.headers[lower_case(text_of(field.name_string()))] = text_of(field.value());
  }
  return request;
}

/// What makes it doubtful where this request ends and the next begins, or whom it is meant for.
template <typename Header>
std::optional<HttpResponse> malformed(const Header& header, bool chunked) {
  const auto refused = [](const char* code, const char* words, const char* where) {
    return problem(400, {code, words, where});
  };
  const beast::string_view length = header[http::field::content_length];
  const bool digits = std::all_of(length.begin(), length.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (header.count(http::field::content_length) > 1 || !digits) {
    return refused("http.content_length", "a request has one Content-Length, a number", "Content-Length");
  }
  if (header.count(http::field::transfer_encoding) > 0 && !chunked) {
    return refused("http.transfer_encoding", "only chunked is understood here", "Transfer-Encoding");
  }
  if (header.count(http::field::host) > 1) return refused("http.host", "a request has one Host", "Host");
  return std::nullopt;
}

/// Returns what it took of the budget.
class Taken {
 public:
  explicit Taken(BodyBudget& budget) : budget_(budget) {}
  ~Taken() { budget_.give_back(bytes_); }
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;
  bool take(std::size_t bytes) {
    if (!budget_.take(bytes)) return false;
    bytes_ += bytes;
    return true;
  }

 private:
  BodyBudget& budget_;
  std::size_t bytes_ = 0;
};

HttpResponse broke(const char* code, const char* words) { return problem(500, {code, words, ""}); }

}  // namespace

HttpSession::HttpSession(asio::ip::tcp::socket socket, const ConnectionContext& context)
    : stream_(std::move(socket)),
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
  while (!stopping_) {
    const bool arrived = co_await wait_for_request();
    if (!arrived) break;
    const bool again = co_await serve_one();
    if (!again) break;
  }
  if (viewer_) co_return;
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

/// Until the first byte of a request is there.
asio::awaitable<bool> HttpSession::wait_for_request() {
  if (buffer_.size() > 0) co_return true;
  idle_ = true;
  stream_.expires_after(context_.settings.idle_within);
  const auto [failure, size] = co_await stream_.async_read_some(buffer_.prepare(4096), kTuple);
  idle_ = false;
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
  asked_ = identify(request, context_.request_ids, context_.log);
  if (auto wrong = malformed(parser.get(), parser.chunked()))
    co_return co_await refuse(request, std::move(*wrong));
  Incoming incoming;
  if (const auto length = parser.content_length()) incoming.length = *length;
  incoming.has_body = parser.chunked() || incoming.length.value_or(0) > 0;
  incoming.upgrade = beast::websocket::is_upgrade(parser.get());
  keep_alive_ = parser.get().keep_alive() && !incoming.has_body;  // should it be refused
  Admission admission = admit(context_.router, request, incoming);
  if (!admission.route) co_return co_await refuse(request, std::move(admission.refusal));

  const Route& route = *admission.route;
  Taken taken(context_.budget);
  const std::size_t most = incoming.has_body ? incoming.length.value_or(route.limit(request)) : 0;
  if (!taken.take(most)) {
    HttpResponse busy = problem(503, {"server.busy", "too many uploads at once; try again in a few seconds",
                                      "", ErrorKind::kUnavailable});
    co_return co_await refuse(request, std::move(busy));
  }
  if (incoming.has_body) {
    keep_alive_ = false;
    const bool whole = co_await read_body(parser, route, request);
    if (!whole) co_return false;
  }
  HttpResponse response = co_await handle(route, request);
  if (route.websocket && response.status == 200) co_return co_await serve_stream(parser, request);
  const bool again = parser.get().keep_alive() && !stopping_;
  const bool written = co_await write(request, std::move(response), again);
  co_return written&& again;
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
  asked_ = identify(unknown, context_.request_ids, context_.log);
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
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
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

asio::awaitable<bool> HttpSession::read_body(Parser& parser, const Route& route, HttpRequest& request) {
  parser.body_limit(route.limit(request));
  stream_.expires_after(context_.settings.body_within);
  if (beast::iequals(parser.get()[http::field::expect], "100-continue")) {
    static constexpr std::string_view kGoOn = "HTTP/1.1 100 Continue\r\n\r\n";
    const auto [failure, size] = co_await asio::async_write(stream_, asio::buffer(kGoOn), kTuple);
    if (failure) co_return false;
  }
  const auto [failure, size] = co_await http::async_read(stream_, buffer_, parser, kTuple);
  if (!failure) {
    request.body = std::move(parser.get().body());
    co_return true;
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

asio::awaitable<HttpResponse> HttpSession::handle(const Route& route, const HttpRequest& request) {
  co_return co_await ws::on_pool(route.heavy ? context_.heavy : context_.light, [this, &route, &request] {
    try {
      return route.handler(asked_, request);
    } catch (const std::bad_alloc&) {
      asked_.log.error("handler ran out of memory", LogFields{{"route", route.pattern}});
      return broke("internal.memory", "there is not enough memory for this");
    } catch (const std::exception& e) {
      asked_.log.error("handler threw", LogFields{{"route", route.pattern}, {"what", e.what()}});
      return broke("internal.exception", e.what());
    }
  });
}

asio::awaitable<bool> HttpSession::write(const HttpRequest& request, HttpResponse response, bool keep_alive) {
  const bool bodiless = response.status == 204 || response.status == 304;
  http::response<http::string_body> message;
  message.version(11);
  message.result(static_cast<unsigned>(response.status));
  message.reason(status_phrase(response.status));
  message.keep_alive(keep_alive);
  message.set(http::field::server, "toile");
  message.set("X-Content-Type-Options", "nosniff");
  message.set("Referrer-Policy", "no-referrer");
  message.set("Cross-Origin-Resource-Policy", "same-origin");
  if (!response.content_type.empty()) message.set(http::field::content_type, response.content_type);
  if (request.header("x-request-id") == asked_.request_id) message.set("X-Request-Id", asked_.request_id);
  for (const auto& [name, value] : response.headers) message.set(name, value);
  if (!bodiless) message.content_length(response.body.size());
  if (request.method != "HEAD" && !bodiless) message.body() = std::move(response.body);

  // Before it is sent: who has got the answer finds it counted.
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  context_.metrics.count_request(request.method, response.status, seconds);
  tell(request, response.status, seconds);
  stream_.expires_after(context_.settings.write_within);
  http::response_serializer<http::string_body> serializer(message);
  const auto [failure, size] = co_await http::async_write(stream_, serializer, kTuple);
  began_ = Clock::now();
  co_return !failure;
}

/// What only looks and goes well is told when somebody wants to hear all: a page asks several times a second.
void HttpSession::tell(const HttpRequest& request, int status, double seconds) const {
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
                    {"ms", std::to_string(ms)}});
}

asio::awaitable<bool> HttpSession::serve_stream(Parser& parser, const HttpRequest& request) {
  viewer_ =
      std::make_shared<ws::StreamSession>(std::move(stream_), context_.streams, asked_, request.captures[0]);
  if (stopping_) viewer_->stop();
  ws::StreamSession::Handshake handshake = parser.release();
  co_await viewer_->run(std::move(handshake));
  co_return false;
}

void HttpSession::stop() {
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    self->stopping_ = true;
    if (self->viewer_) {
      self->viewer_->stop();
    } else if (self->idle_) {
      boost::system::error_code ignored;
      self->stream_.socket().close(ignored);
    }
  });
}

bool Connections::add(const std::shared_ptr<HttpSession>& session) {
  const std::lock_guard lock(mutex_);
  if (!stopping_) sessions_.push_back(session);
  return !stopping_;
}

void Connections::remove(const HttpSession* session) {
  const std::lock_guard lock(mutex_);
  std::erase_if(sessions_, [session](const auto& other) { return other.get() == session; });
}

void Connections::stop_all() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  for (const auto& session : sessions_) session->stop();
}

void Connections::forget_all() {
  const std::lock_guard lock(mutex_);
  sessions_.clear();
}

std::size_t Connections::count() const {
  const std::lock_guard lock(mutex_);
  return sessions_.size();
}

}  // namespace toile::http
