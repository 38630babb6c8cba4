#pragma once
// One attempt to tell something to a webhook, and what follows from how it went.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "server/store/webhooks.h"

namespace toile::webhooks {

/// What is sent.
struct Told {
  std::string body;  ///< JSON
  std::vector<std::pair<std::string, std::string>> headers;
};

/// The event with its number and that of the delivery, signed at `now_ms` (Unix time): Toile-Signature is
/// "t=SECONDS,v1=HEX", an HMAC-SHA256 under the webhook's secret of "SECONDS.BODY".
Told told(const store::DueDelivery& due, std::int64_t now_ms);

/// Waits between attempts, ms: after the first, the second, … Once they are over it is given up.
std::vector<std::int64_t> usual_waits();

/// The row after an attempt that was answered with `status`, or went wrong. 2xx is delivered; 410 is given
/// up, and so is what leads where nobody may be told (client.private_address, client.url).
store::DeliveryRow after_attempt(const store::DeliveryRow& before, const Result<int>& status,
                                 std::int64_t now_ms, const std::vector<std::int64_t>& waits);

}  // namespace toile::webhooks
