#include "server/http/event_text.h"

#include <utility>

#include "core/base/text.h"
#include "core/json/tree.h"

namespace toile::http {
namespace {

/// In the answer's header, for who debugs a client as well.
constexpr const char* kAfter = "Last-Event-ID";
constexpr int kRetryMs = 2000;

/// One without data that a client passes over, but for its number.
std::string mark(std::int64_t number) { return "id: " + std::to_string(number) + "\n\n"; }

std::string gap_before(std::int64_t number) {
  return "id: " + std::to_string(number) + "\nevent: gap\ndata: {}\n\n";
}

}  // namespace

HttpResponse event_stream(std::int64_t after, bool gap) {
  HttpResponse response;
  response.content_type = std::string(kEventStream);
  response.headers = {{"Cache-Control", "no-cache"},
                      {"X-Accel-Buffering", "no"},  // a proxy is to hand events on as they come
                      {kAfter, std::to_string(after)}};
  response.body = "retry: " + std::to_string(kRetryMs) + "\n\n" + (gap ? gap_before(after) : mark(after));
  return response;
}

std::optional<std::int64_t> feed_after(const HttpResponse& response) {
  if (response.status != 200 || response.content_type != kEventStream) return std::nullopt;
  for (const auto& [name, value] : response.headers)
    if (name == kAfter) return number_in<std::int64_t>(value);
  return std::nullopt;
}

std::string event_json(const store::EventRow& event) {
  return json::write_json_line(std::vector<json::JsonMember>{{"job", event.job},
                                                             {"sweep", event.sweep},
                                                             {"project_id", event.project_id},
                                                             {"name", event.name},
                                                             {"state", event.state},
                                                             {"reason_code", event.reason_code},
                                                             {"at_ms", static_cast<double>(event.at_ms)}});
}

std::string event_text(const std::vector<store::EventRow>& events, std::int64_t after) {
  std::string text;
  for (const store::EventRow& event : events) {
    if (event.number != after + 1) text += gap_before(event.number - 1);
    after = event.number;
    text += "id: " + std::to_string(event.number) + "\nevent: " + (event.job.empty() ? "sweep" : "job") +
            "\ndata: " + event_json(event) + "\n\n";
  }
  return text;
}

}  // namespace toile::http
