#pragma once
// Writes answers to a connection. Internal to http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>

#include <chrono>
#include <string>
#include <string_view>

#include "server/http/body_budget.h"
#include "server/http/message.h"
#include "server/ws/line.h"

namespace toile::http {

using AnswerHeader = boost::beast::http::response<boost::beast::http::empty_body>;

/// What goes before the body. `request_id`: told to who gave it; empty: not told.
AnswerHeader answer_header(const HttpResponse& response, bool keep_alive, const std::string& request_id);

/// Writes piece by piece, each within a time: who does not read is not waited for. All functions run on the
/// socket's strand, one at a time.
class AnswerWriter {
 public:
  /// Files are read on `pool`, so that the disk is not waited for on a thread of the sockets.
  AnswerWriter(ws::Line line, std::chrono::milliseconds piece_within, boost::asio::thread_pool& pool);

  /// Counts what lies in memory while it is sent; where there is no room the answer becomes one that says so.
  static void take_room(HttpResponse& response, Taken& taken);
  /// False when the connection broke or the file has become shorter. Without `body` the header goes alone.
  boost::asio::awaitable<bool> write(AnswerHeader& header, const HttpResponse& response, bool body);

  /// More of a body whose length no header told.
  boost::asio::awaitable<bool> write_bytes(std::string_view bytes);

 private:
  boost::asio::awaitable<bool> write_file(const AnswerFile& file);

  ws::Line line_;
  const std::chrono::milliseconds piece_within_;
  boost::asio::thread_pool& pool_;
};

}  // namespace toile::http
