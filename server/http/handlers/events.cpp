// /api/v1/events: what becomes of all jobs of whoever asks, as server-sent events.

#include "server/http/handlers/events.h"

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "server/http/event_text.h"
#include "server/http/problem.h"
#include "server/store/events.h"

namespace toile::handlers {
namespace {

/// The number that the client has heard last: of the header, which browsers send when they come back, or of
/// ?after, for the first time. Nothing: it wants what comes from now on. Error: request.after.
Result<std::optional<std::int64_t>> read_after(const http::HttpRequest& request) {
  std::string given = request.header("last-event-id");
  if (given.empty()) given = request.parameter("after");
  if (given.empty()) return std::optional<std::int64_t>();
  const std::optional<std::int64_t> number = number_in<std::int64_t>(given);
  if (number && *number >= 0) return number;
  return Error{"request.after", "Last-Event-ID and after are the number of an event", "after"};
}

http::HttpResponse feed(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<std::optional<std::int64_t>> after = read_after(request);
  if (!after) return http::problem(400, after.error());
  store::Events* const events = store::events_of(api.store);
  if (!events) {
    return http::problem(
        {"events.not_kept", "this server's store keeps no events", "", ErrorKind::kUnavailable});
  }
  const Result<std::int64_t> newest = events->newest_event(context.owner);
  if (!newest) return http::problem(newest.error());
  if (!*after) return http::event_stream(*newest, false);
  const bool other_store = **after > *newest;  // no event of that number was ever written here
  return http::event_stream(other_store ? *newest : **after, other_store);
}

}  // namespace

ApiRoutes event_routes() { return {{.pattern = "/api/v1/events", .handler = feed, .parameters = {"after"}}}; }

}  // namespace toile::handlers
