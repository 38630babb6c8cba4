#include "server/http/client.h"

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/url/parse.hpp>
#include <boost/url/url_view.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/public_address.h"
#include "server/http/thrown.h"
#include "server/http/tls.h"
#include "server/http/url.h"
#include "server/ws/line.h"
#include "server/ws/tuple.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

bool may_repeat(const HttpClient::Request& request) {
  const auto is_key = [](const auto& header) { return header.first == "Idempotency-Key"; };
  return request.method == "GET" || std::any_of(request.headers.begin(), request.headers.end(), is_key);
}

}  // namespace

struct HttpClient::Impl {
  std::string host, port;
  asio::io_context io;
  std::atomic<bool> given_up{false};
  bool public_only = false;
  bool led_astray = false;  // the address was of no place that may be gone to
  TlsContext tls;           // null: http
  std::optional<ws::Line> stream;
  beast::flat_buffer buffer;

  http::request<http::string_body> message_of(const Request& request) const {
    http::request<http::string_body> message;
    message.version(11);
    message.method_string(request.method);
    message.target(request.target);
    message.set(http::field::host, host + ":" + port);
    message.set(http::field::user_agent, "toile");
    if (!request.content_type.empty()) message.set(http::field::content_type, request.content_type);
    for (const auto& [name, value] : request.headers) message.set(name, value);
    message.body() = request.body;
    message.prepare_payload();
    return message;
  }

  asio::awaitable<boost::system::error_code> connect(std::chrono::seconds within) {
    tcp::resolver resolver(io);
    const std::string name = host.starts_with('[') ? host.substr(1, host.size() - 2) : host;
    const auto [unknown, found] = co_await resolver.async_resolve(name, port, ws::kTuple);
    if (unknown) co_return unknown;
    // What is looked at is what is connected to: a name is not asked for again.
    std::vector<tcp::endpoint> places;
    for (const auto& place : found)
      if (!public_only || is_public(place.endpoint().address())) places.push_back(place.endpoint());
    led_astray = places.empty();
    if (led_astray) co_return asio::error::access_denied;
    stream.emplace(beast::tcp_stream(io), tls.get());
    buffer.clear();
    stream->expires_after(std::min(within, std::chrono::seconds(10)));
    const auto [failure, place] = co_await stream->next_layer().async_connect(places, ws::kTuple);
    boost::system::error_code unmet = failure;
    if (!unmet && tls) unmet = co_await meet(name);
    if (unmet) stream.reset();
    co_return unmet;
  }

  /// The other side must show that it is who was asked for.
  asio::awaitable<boost::system::error_code> meet(const std::string& name) {
    ws::Line::Tls& line = *stream->tls();
    boost::system::error_code failure;
    asio::ip::make_address(name, failure);
    const bool is_name = failure.failed();  // a number is not told beforehand (RFC 6066, 3)
    if (is_name && SSL_set_tlsext_host_name(line.native_handle(), name.c_str()) != 1)
      co_return asio::error::invalid_argument;
    line.set_verify_callback(asio::ssl::host_name_verification(name), failure);
    if (failure) co_return failure;
    const auto [unmet] = co_await line.async_handshake(asio::ssl::stream_base::client, ws::kTuple);
    co_return unmet;
  }

  asio::awaitable<boost::system::error_code> exchange(const Request& request, std::chrono::seconds within,
                                                      HttpReply& reply) {
    http::request<http::string_body> message = message_of(request);
    stream->expires_after(within);
    const auto [unsent, sent] = co_await http::async_write(*stream, message, ws::kTuple);
    http::response_parser<http::string_body> parser;
    parser.body_limit(request.most_reply_bytes);
    // A server that refuses may answer and close before it has read everything.
    const auto [failure, read] = co_await http::async_read(*stream, buffer, parser, ws::kTuple);
    if (failure) {
      stream.reset();
      co_return failure == beast::error::timeout || !unsent ? failure : unsent;
    }
    reply.status = static_cast<int>(parser.get().result_int());
    for (const auto& field : parser.get()) {
      reply.headers[lower_case({field.name_string().data(), field.name_string().size()})] =
          std::string(field.value().data(), field.value().size());
    }
    reply.body = std::move(parser.get().body());
    if (unsent || !parser.get().keep_alive()) stream.reset();
    co_return boost::system::error_code();
  }

  asio::awaitable<boost::system::error_code> ask(const Request& request, std::chrono::seconds within,
                                                 HttpReply& reply) {
    if (stream) {
      const auto failure = co_await exchange(request, within, reply);
      if (!failure || failure == beast::error::timeout || !may_repeat(request)) co_return failure;
    }
    const auto unreachable = co_await connect(within);
    if (unreachable) co_return unreachable;
    co_return co_await exchange(request, within, reply);
  }
};

HttpClient::HttpClient(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HttpClient::HttpClient(HttpClient&&) noexcept = default;
HttpClient::~HttpClient() = default;

Result<HttpClient> HttpClient::make(const std::string& url, const std::string& roots) {
  const auto wrong = [&] {
    return Error{"client.url",
                 "a server's address is http://HOST:PORT or https://HOST:PORT, not " + in_quotes(url), ""};
  };
  const auto parsed = boost::urls::parse_uri(url);
  const bool secure = url.starts_with("https://");
  if (!parsed || !(secure || url.starts_with("http://")) || parsed->has_userinfo() || parsed->has_query() ||
      parsed->has_fragment() || parsed->encoded_path().size() > 1 || parsed->encoded_host().empty() ||
      (parsed->has_port() && parsed->port().empty())) {
    return wrong();
  }
  auto impl = std::make_unique<Impl>();
  impl->host = parsed->encoded_host();  // of an IPv6 address with its brackets
  impl->port = parsed->has_port() ? std::string(parsed->port()) : secure ? "443" : "80";
  if (secure) {
    impl->tls = TRY(client_tls(roots));
  }
  return HttpClient(std::move(impl));
}

Result<HttpReply> HttpClient::ask(const Request& request, std::chrono::seconds within) {
  HttpReply reply;
  boost::system::error_code failure;
  std::exception_ptr thrown;
  bool ended = false;
  impl_->io.restart();
  if (impl_->given_up) impl_->io.stop();  // it may have been said before the line above
  asio::co_spawn(
      impl_->io, [&]() -> asio::awaitable<void> { failure = co_await impl_->ask(request, within, reply); },
      [&](const std::exception_ptr& what) {
        thrown = what;
        ended = true;
      });
  impl_->io.run();
  const std::string place = impl_->host + ":" + impl_->port;
  if (!ended) return Error{"client.given_up", "nobody waits for the answer", place, ErrorKind::kCancelled};
  if (thrown) {
    return Error{"client.failed", "asking broke off: " + words_of(thrown), place, ErrorKind::kSystem};
  }
  if (!failure) return reply;
  if (failure.category() == asio::error::get_ssl_category()) {
    return Error{"client.tls", "the server is not believed to be who it says: " + failure.message(), place,
                 ErrorKind::kSystem};
  }
  if (impl_->led_astray) {
    return Error{"client.private_address",
                 "this leads to the loopback or a private network, where nothing is sent", place};
  }
  if (failure == beast::error::timeout)
    return Error{"client.timeout", "the server does not answer", place, ErrorKind::kSystem};
  if (failure == http::error::partial_message || failure == http::error::end_of_stream) {
    return Error{"client.cut_off", "the line broke off before the whole answer was there", place,
                 ErrorKind::kUnavailable};
  }
  if (failure.category() == http::make_error_code(http::error::bad_version).category()) {
    return Error{"client.malformed", "what answers there is no Toile server: " + failure.message(), place,
                 ErrorKind::kSystem};
  }
  return Error{"client.unreachable", "the server cannot be reached: " + failure.message(), place,
               ErrorKind::kUnavailable};
}

void HttpClient::keep_to_public() { impl_->public_only = true; }

void HttpClient::give_up() {
  impl_->given_up = true;
  impl_->io.stop();
}

bool HttpClient::tells_others() const {
  const std::string& host = impl_->host;
  const bool six = host.starts_with('[');
  return !impl_->tls && !is_loopback_name(six ? host.substr(1, host.size() - 2) : host);
}

}  // namespace toile::http
