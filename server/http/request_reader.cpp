#include "server/http/request_reader.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "server/http/problem.h"
#include "server/ws/tuple.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using Failure = boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kBufferBytes = 64 << 10;

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

// Why a body is not read to its end, beside what Beast says.
const Failure kNoRoom = asio::error::no_memory;   // the budget is spent
const Failure kTooSlow = asio::error::timed_out;  // Beast's own timeout is another

/// Whether the bytes are at fault, and not the connection.
bool is_malformed(const Failure& failure) {
  const bool parsing = failure.category() == http::make_error_code(http::error::bad_method).category();
  return parsing && failure != http::error::end_of_stream && failure != http::error::partial_message;
}

HttpResponse not_http(const Failure& failure) {
  return problem(400, {"http.malformed", "this is not HTTP: " + failure.message(), ""});
}

}  // namespace

RequestReader::RequestReader(ws::Line line, const ServerSettings& settings)
    : line_(std::move(line)), settings_(settings), buffer_(kBufferBytes) {}

asio::awaitable<bool> RequestReader::wait() {
  line_.expires_after(settings_.idle_within);
  const auto [failure, size] = co_await line_.async_read_some(buffer_.prepare(4096), ws::kTuple);
  if (failure) co_return false;
  buffer_.commit(size);
  co_return true;
}

/// Beast's own limit holds for the start line and for single fields, not for all fields together.
asio::awaitable<Failure> RequestReader::read_header(RequestParser& parser) {
  parser.header_limit(static_cast<std::uint32_t>(settings_.most_header_bytes));
  parser.body_limit(boost::none);  // known once the route is
  line_.expires_after(settings_.header_within);
  std::size_t total = 0;
  while (!parser.is_header_done()) {
    const auto [failure, size] = co_await http::async_read_some(line_, buffer_, parser, ws::kTuple);
    if (failure) co_return failure;
    total += size;
    if (total > settings_.most_header_bytes) co_return make_error_code(http::error::header_limit);
  }
  co_return Failure();
}

asio::awaitable<Failure> RequestReader::read_body(RequestParser& parser, std::size_t most, Taken& taken) {
  parser.body_limit(most);
  if (beast::iequals(parser.get()[http::field::expect], "100-continue")) {
    static constexpr std::string_view kGoOn = "HTTP/1.1 100 Continue\r\n\r\n";
    const auto [failure, size] = co_await asio::async_write(line_, asio::buffer(kGoOn), ws::kTuple);
    if (failure) co_return failure;
  }
  co_return co_await read_all(parser, taken);
}

asio::awaitable<Failure> RequestReader::read_all(RequestParser& parser, Taken& taken) {
  const Clock::time_point began = Clock::now();
  parser.eager(true);
  while (!parser.is_done()) {
    line_.expires_after(settings_.body_pause_within);
    const auto [failure, size] = co_await http::async_read_some(line_, buffer_, parser, ws::kTuple);
    if (failure) co_return failure;
    const std::size_t has = parser.get().body().size();
    if (!taken.have(has)) co_return kNoRoom;
    const std::chrono::duration<double> late = Clock::now() - began - settings_.slow_for;
    if (late.count() * static_cast<double>(settings_.least_body_rate) > static_cast<double>(has))
      co_return kTooSlow;
  }
  co_return Failure();
}

asio::awaitable<void> RequestReader::linger() {
  constexpr std::size_t kMostBytes = std::size_t{128} << 20;
  constexpr auto kLongest = std::chrono::seconds(3);
  boost::system::error_code ignored;
  if (line_.tls() == nullptr) line_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  buffer_.clear();
  line_.expires_after(kLongest);
  for (std::size_t seen = 0; seen < kMostBytes;) {
    const auto [failure, size] = co_await line_.async_read_some(buffer_.prepare(kBufferBytes), ws::kTuple);
    if (failure) break;
    seen += size;
  }
}

std::optional<HttpResponse> header_refusal(const Failure& failure) {
  if (!is_malformed(failure)) return std::nullopt;
  const bool large = failure == http::error::header_limit || failure == http::error::buffer_overflow;
  if (large) return problem(431, {"http.header_too_large", "the header is larger than is read here", ""});
  return not_http(failure);
}

std::optional<HttpResponse> body_refusal(const Failure& failure, std::size_t most) {
  if (failure == kNoRoom) return no_room();
  if (failure == kTooSlow)
    return problem(408, {"http.too_slow", "the body came too slowly; send it again", ""});
  if (failure == http::error::body_limit) {
    const std::string bytes = std::to_string(most);
    return problem(413,
                   {"http.too_large", "the body has more than the " + bytes + " bytes allowed here", ""});
  }
  if (!is_malformed(failure)) return std::nullopt;
  return not_http(failure);
}

}  // namespace toile::http
