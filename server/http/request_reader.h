#pragma once
// Reads requests off a connection. Internal to http.

#include <boost/asio/awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/system/error_code.hpp>

#include <cstddef>
#include <optional>

#include "server/http/body_budget.h"
#include "server/http/message.h"
#include "server/http/server_settings.h"
#include "server/ws/line.h"

namespace toile::http {

using RequestParser = boost::beast::http::request_parser<boost::beast::http::string_body>;

/// Each function ends within its time of the settings. All of them run on the socket's strand, one at a time.
class RequestReader {
 public:
  RequestReader(ws::Line line, const ServerSettings& settings);

  /// Whether bytes of the next request are there already.
  bool has_bytes() const { return buffer_.size() > 0; }
  /// Until the first byte of a request is there; false when none comes.
  boost::asio::awaitable<bool> wait();
  /// Up to the end of the header; no body is limited yet.
  boost::asio::awaitable<boost::system::error_code> read_header(RequestParser& parser);
  /// Until the body is whole, of at most `most` bytes. What comes counts against the budget as it comes: who
  /// announces much and sends nothing takes nothing from others, and is not waited for.
  boost::asio::awaitable<boost::system::error_code> read_body(RequestParser& parser, std::size_t most,
                                                              Taken& taken);
  /// Reads away what the other side still sends, for a while: closing on unread bytes would reset the
  /// connection and could take the answer with it.
  boost::asio::awaitable<void> linger();

 private:
  boost::asio::awaitable<boost::system::error_code> read_all(RequestParser& parser, Taken& taken);

  ws::Line line_;
  const ServerSettings& settings_;
  boost::beast::flat_buffer buffer_;
};

/// What is answered when a header could not be read: 400 or 431. Nothing: the other side is gone, or too
/// slow.
std::optional<HttpResponse> header_refusal(const boost::system::error_code& failure);
/// The same for a body of at most `most` bytes: 400, 408, 413 or 503.
std::optional<HttpResponse> body_refusal(const boost::system::error_code& failure, std::size_t most);

}  // namespace toile::http
