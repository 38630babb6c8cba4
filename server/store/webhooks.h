#pragma once
// Addresses that are told when a job has ended, and what has been told to them. What is to be told is written
// with the job itself, in the same transaction, so that no restart and no crash loses it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "server/store/events.h"
#include "server/store/store.h"

namespace toile::store {

struct WebhookRow {
  std::string id;  ///< "w_" and 20 characters
  OwnerId owner;
  std::string url;
  std::string secret;               ///< what is told is signed with; kept, for it is needed each time
  std::vector<std::string> states;  ///< words of those that are told; never empty
  std::string label;                ///< what its owner calls it
  std::int64_t created_ms = 0;
};

/// How far it has come that something is told.
enum class Outcome { kWaiting, kDelivered, kGivenUp };
/// "waiting", "delivered", "given_up".
std::string_view word_of(Outcome outcome);

/// One event to be told to one address.
struct DeliveryRow {
  std::int64_t number = 0;  ///< rises with time over all owners
  OwnerId owner;
  std::string webhook;
  EventRow event;
  Outcome outcome = Outcome::kWaiting;
  int attempts = 0;
  std::int64_t next_ms = 0;  ///< Unix time of the next attempt while it waits; else that of the last
  int status = 0;            ///< of the last answer; 0: there was none
  std::string error;         ///< what was wrong the last time
};

/// With what is needed to tell it.
struct DueDelivery : DeliveryRow {
  std::string url, secret;
};

/// Calls are thread-safe and durable, as those of Store, with its errors.
class Webhooks {
 public:
  static constexpr int kMost = 10;         ///< of an owner
  static constexpr int kKeptOfEach = 500;  ///< deliveries of a webhook, the newest

  virtual ~Webhooks() = default;
  /// Keeps the row; id and time are the store's to give. Error: webhooks.too_many.
  virtual Result<WebhookRow> add_webhook(WebhookRow row) = 0;
  /// Newest first.
  virtual Result<std::vector<WebhookRow>> webhooks(const OwnerId& owner) = 0;
  /// With what was still to be told. Error: store.not_found.
  virtual Status remove_webhook(const OwnerId& owner, const std::string& id) = 0;
  /// A delivery that no job has caused, of the state kPing. Error: store.not_found.
  virtual Status ping_webhook(const OwnerId& owner, const std::string& id) = 0;
  /// Newest first, at most `limit`. Error: store.not_found when there is no such webhook.
  virtual Result<std::vector<DeliveryRow>> deliveries(const OwnerId& owner, const std::string& id,
                                                      int limit) = 0;
  /// The oldest of each owner whose time has come; none of a locked account.
  virtual Result<std::vector<DueDelivery>> due_deliveries(std::int64_t now_ms) = 0;
  /// Writes outcome, attempts, time, status and error. One whose webhook is gone is passed over.
  virtual Status change_delivery(const DeliveryRow& row) = 0;
};

inline constexpr const char* kPing = "ping";

/// Those of a store that keeps webhooks; null else.
inline Webhooks* webhooks_of(Store& store) { return dynamic_cast<Webhooks*>(&store); }

}  // namespace toile::store
