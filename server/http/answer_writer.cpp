#include "server/http/answer_writer.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/write.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <sstream>
#include <utility>

#include "server/http/event_text.h"
#include "server/http/problem.h"
#include "server/ws/on_pool.h"
#include "server/ws/tuple.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;

constexpr std::size_t kPieceBytes = 256 << 10;  // what a connection that does not read can hold

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

/// "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7), of now.
std::string http_date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 40> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%a, %d %b %Y %H:%M:%S GMT", &utc);
  return {text.data(), size};
}

std::string header_text(const AnswerHeader& message) {
  std::ostringstream out;
  out << message.base();
  return out.str();
}

bool is_bodiless(int status) { return status == 204 || status == 304; }

}  // namespace

AnswerHeader answer_header(const HttpResponse& response, bool keep_alive, const std::string& request_id) {
  AnswerHeader message;
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
  if (!request_id.empty()) message.set("X-Request-Id", request_id);
  for (const auto& [name, value] : response.headers) message.set(name, value);
  if (!is_bodiless(response.status) && !feed_after(response))
    message.content_length(response.file ? response.file->size() : response.body.size());
  return message;
}

AnswerWriter::AnswerWriter(ws::Line line, std::chrono::milliseconds piece_within, asio::thread_pool& pool)
    : line_(std::move(line)), piece_within_(piece_within), pool_(pool) {}

void AnswerWriter::take_room(HttpResponse& response, Taken& taken) {
  if (response.body.size() > kPieceBytes && !taken.have(response.body.size())) response = no_room();
}

asio::awaitable<bool> AnswerWriter::write(AnswerHeader& header, const HttpResponse& response, bool body) {
  const bool follows = body && !is_bodiless(response.status);
  line_.expires_after(piece_within_);
  http::response_serializer<http::empty_body> serializer(header);
  // A small answer goes with its header in one piece.
  if (follows && !response.file && response.body.size() <= kPieceBytes) {
    std::string whole = header_text(header);
    whole += response.body;
    co_return co_await write_bytes(whole);
  }
  const auto [failure, size] = co_await http::async_write_header(line_, serializer, ws::kTuple);
  if (failure) co_return false;
  if (!follows) co_return true;
  if (response.file) co_return co_await write_file(*response.file);
  co_return co_await write_bytes(response.body);
}

asio::awaitable<bool> AnswerWriter::write_bytes(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::string_view piece = bytes.substr(0, kPieceBytes);
    line_.expires_after(piece_within_);
    const auto [failure, size] = co_await asio::async_write(line_, asio::buffer(piece), ws::kTuple);
    if (failure) co_return false;
    bytes.remove_prefix(piece.size());
  }
  co_return true;
}

asio::awaitable<bool> AnswerWriter::write_file(const AnswerFile& file) {
  for (std::uint64_t at = 0; at < file.size();) {
    const std::string piece = co_await ws::on_pool(pool_, [&file, at] { return file.read(at, kPieceBytes); });
    if (piece.empty()) co_return false;  // it has become shorter: the other side sees that it is cut off
    const bool written = co_await write_bytes(piece);
    if (!written) co_return false;
    at += piece.size();
  }
  co_return true;
}

}  // namespace toile::http
