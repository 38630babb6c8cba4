#pragma once
// Has a route's handler answer a request, off the threads of the sockets. Internal to http.

#include <boost/asio/awaitable.hpp>

#include <atomic>
#include <memory>

#include "server/http/connection_context.h"
#include "server/http/message.h"
#include "server/http/router.h"
#include "server/store/request_context.h"
#include "server/ws/line.h"

namespace toile::http {

/// Work is given up when the other side ends the connection, when it takes too long, and when somebody says
/// so. One request at a time; all functions run on the socket's strand.
class RequestWork {
 public:
  RequestWork(ws::Line line, const ConnectionContext& context);

  /// Sets `asked.given_up`. `stopping`: it is given up from the beginning.
  boost::asio::awaitable<HttpResponse> answer(const Route& route, const HttpRequest& request,
                                              store::RequestContext& asked, bool stopping);
  /// Nobody waits any more for what is worked on, if anything is.
  void give_up();

 private:
  boost::asio::awaitable<HttpResponse> have_done(const Route& route, const HttpRequest& request,
                                                 const store::RequestContext& asked);
  void watch_for_end();

  ws::Line line_;
  const ConnectionContext& context_;
  std::shared_ptr<std::atomic<bool>> given_up_;  ///< the request at hand; null: none
};

}  // namespace toile::http
