#include "server/http/request_work.h"

#include <boost/asio/steady_timer.hpp>

#include <sys/socket.h>

#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "server/http/problem.h"
#include "server/ws/on_pool.h"

namespace toile::http {
namespace {

namespace asio = boost::asio;

// In this file nothing that must be destroyed is made within an awaited call: GCC 12 destroys such
// temporaries twice.

HttpResponse broke(const char* code, const char* words) { return problem(500, {code, words, ""}); }

HttpResponse gave_up() {
  return problem(
      503, {"server.gave_up", "this took too long, or the server is stopping", "", ErrorKind::kUnavailable});
}

/// On a thread of the route's kind of work. What waited so long for one that nobody waits for it is not
/// begun.
HttpResponse work_on(const Route& route, const HttpRequest& request, const store::RequestContext& asked) {
  try {
    if (asked.is_given_up()) return gave_up();
    HttpResponse response = route.handler(asked, request);
    return asked.is_given_up() && response.status >= 500 ? gave_up() : response;
  } catch (const std::bad_alloc&) {
    asked.log.error("handler ran out of memory", LogFields{{"route", route.pattern}});
    return broke("internal.memory", "there is not enough memory for this");
  } catch (const std::exception& e) {
    asked.log.error("handler threw", LogFields{{"route", route.pattern}, {"what", e.what()}});
    return broke("internal.exception", e.what());
  } catch (...) {  // it must not leave a thread of a pool
    asked.log.error("handler threw what is no exception", LogFields{{"route", route.pattern}});
    return broke("internal.unknown", "the handler broke off for a reason that it did not name");
  }
}

}  // namespace

RequestWork::RequestWork(ws::Line line, const ConnectionContext& context)
    : line_(std::move(line)), context_(context) {}

asio::awaitable<HttpResponse> RequestWork::answer(const Route& route, const HttpRequest& request,
                                                  store::RequestContext& asked, bool stopping) {
  const auto given_up = std::make_shared<std::atomic<bool>>(stopping);
  given_up_ = given_up;
  asked.given_up = given_up;
  asio::steady_timer limit(line_.get_executor(), context_.settings.work_within);
  limit.async_wait([given_up](boost::system::error_code cancelled) {
    if (!cancelled) given_up->store(true);
  });
  const bool watched = route.work != Work::kStore;
  if (watched) watch_for_end();
  HttpResponse response = co_await have_done(route, request, asked);
  boost::system::error_code ignored;
  if (watched) line_.socket().cancel(ignored);
  given_up_ = nullptr;
  co_return response;
}

void RequestWork::give_up() {
  if (given_up_) given_up_->store(true);
}

/// Heavy work waits its owner's turn.
asio::awaitable<HttpResponse> RequestWork::have_done(const Route& route, const HttpRequest& request,
                                                     const store::RequestContext& asked) {
  const auto work = [&route, &request, &asked] { return work_on(route, request, asked); };
  FairPool* const fair = context_.pools.fair(route.work);
  if (fair == nullptr) co_return co_await ws::on_pool(context_.pools.light(route.work), work);
  std::optional<HttpResponse> response;
  const bool taken = co_await on_fair_pool(*fair, asked.owner, [&] { response = work(); });
  if (taken) co_return std::move(*response);
  co_return problem({"server.too_much_at_once",
                     "too much that you have asked for waits already; try again when some of it is done", "",
                     ErrorKind::kTooMany});
}

/// Looks whether the other side has gone while its request is worked on. One that has sent its next request
/// already is not watched any further.
void RequestWork::watch_for_end() {
  auto readable = [line = line_, given_up = given_up_](boost::system::error_code cancelled) mutable {
    if (cancelled) return;
    char byte = 0;
    const int socket = line.socket().native_handle();
    if (::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0) given_up->store(true);
  };
  line_.socket().async_wait(asio::ip::tcp::socket::wait_read, std::move(readable));
}

}  // namespace toile::http
