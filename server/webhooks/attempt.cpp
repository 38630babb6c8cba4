#include "server/webhooks/attempt.h"

#include <cstddef>

#include "core/base/names.h"
#include "core/json/tree.h"
#include "server/accounts/signature.h"

namespace toile::webhooks {
namespace {

constexpr int kGone = 410;
constexpr std::size_t kLongestError = 300;  // bytes

std::string words_of(const Result<int>& status) {
  if (status) return "the answer was " + std::to_string(*status);
  return clipped(status.error().code + ": " + status.error().message, kLongestError);
}

bool is_hopeless(const Result<int>& status) {
  if (status) return *status == kGone;
  return status.error().code == "client.private_address" || status.error().code == "client.url";
}

}  // namespace

Told told(const store::DueDelivery& due, std::int64_t now_ms) {
  const store::EventRow& event = due.event;
  Told message;
  message.body =
      json::write_json_line(std::vector<json::JsonMember>{{"delivery", static_cast<double>(due.number)},
                                                          {"event", static_cast<double>(event.number)},
                                                          {"job", event.job},
                                                          {"sweep", event.sweep},
                                                          {"project_id", event.project_id},
                                                          {"name", event.name},
                                                          {"state", event.state},
                                                          {"reason_code", event.reason_code},
                                                          {"at_ms", static_cast<double>(event.at_ms)}});
  const std::string seconds = std::to_string(now_ms / 1000);
  const std::string sum = accounts::hmac_sha256(due.secret, seconds + "." + message.body);
  message.headers = {{"Toile-Delivery", std::to_string(due.number)},
                     {"Toile-Signature", "t=" + seconds + ",v1=" + sum}};
  return message;
}

std::vector<std::int64_t> usual_waits() {
  constexpr std::int64_t kMinute = 60'000, kHour = 60 * kMinute;
  return {10'000, kMinute, 5 * kMinute, 30 * kMinute, 2 * kHour, 6 * kHour, 12 * kHour};
}

store::DeliveryRow after_attempt(const store::DeliveryRow& before, const Result<int>& status,
                                 std::int64_t now_ms, const std::vector<std::int64_t>& waits) {
  store::DeliveryRow after = before;
  after.status = status ? *status : 0;
  after.attempts = before.attempts + 1;
  after.next_ms = now_ms;
  after.error.clear();
  after.outcome = store::Outcome::kDelivered;
  if (status && *status >= 200 && *status < 300) return after;
  after.error = words_of(status);
  const auto made = static_cast<std::size_t>(before.attempts);
  const bool again = !is_hopeless(status) && made < waits.size();
  after.outcome = again ? store::Outcome::kWaiting : store::Outcome::kGivenUp;
  if (again) after.next_ms = now_ms + waits[made];
  return after;
}

}  // namespace toile::webhooks
