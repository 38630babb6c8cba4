#include "server/webhooks/deliverer.h"

#include <utility>

#include "server/http/remote_url.h"

namespace toile::webhooks {
namespace {

constexpr std::size_t kMostReplyBytes = 64 << 10;  // of an answer, which nobody reads

std::int64_t unix_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

Deliverer::Deliverer(store::Webhooks& store, DeliverySettings settings, const Log& log)
    : store_(store), settings_(std::move(settings)), log_(log) {
  for (int i = 0; i < settings_.threads; ++i) threads_.emplace_back([this] { work(); });
}

Deliverer::~Deliverer() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (http::HttpClient* client : asking_) client->give_up();
  }
  bell_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Deliverer::work() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const std::optional<store::DueDelivery> due = next();
    if (!due) {
      bell_.wait_for(lock, settings_.look_every);
      continue;
    }
    busy_.insert(due->owner);
    lock.unlock();
    const Result<int> status = tell(*due);
    lock.lock();
    if (!stopping_ || status) keep(lock, after_attempt(*due, status, unix_ms(), settings_.waits_ms));
    busy_.erase(due->owner);
  }
}

/// REQUIRES mutex_.
std::optional<store::DueDelivery> Deliverer::next() {
  Result<std::vector<store::DueDelivery>> due = store_.due_deliveries(unix_ms());
  if (!due) {
    log_.warn("webhooks wait: the store tells nothing", due.error());
    return std::nullopt;
  }
  for (store::DueDelivery& one : *due)
    if (!busy_.contains(one.owner)) return std::move(one);
  return std::nullopt;
}

Result<int> Deliverer::tell(const store::DueDelivery& due) {
  const http::RemoteUrl url = TRY(http::read_remote_url(due.url));
  http::HttpClient client = TRY(http::HttpClient::make(url.origin, settings_.roots));
  if (!settings_.to_private) client.keep_to_public();
  Told message = told(due, unix_ms());
  http::HttpClient::Request request;
  request.method = "POST";
  request.target = url.target;
  request.body = std::move(message.body);
  request.content_type = "application/json";
  request.headers = std::move(message.headers);
  request.most_reply_bytes = kMostReplyBytes;
  return ask(client, request);
}

Result<int> Deliverer::ask(http::HttpClient& client, const http::HttpClient::Request& request) {
  {
    const std::lock_guard lock(mutex_);
    if (stopping_) return Error{"client.given_up", "the service is stopping", "", ErrorKind::kCancelled};
    asking_.insert(&client);
  }
  const Result<http::HttpReply> reply = client.ask(request, settings_.within);
  const std::lock_guard lock(mutex_);
  asking_.erase(&client);
  if (!reply) return reply.error();
  return reply->status;
}

/// Where the store takes no word, nothing more is told to that owner for a while: it would be told again and
/// again.
void Deliverer::keep(std::unique_lock<std::mutex>& lock, const store::DeliveryRow& row) {
  const Status kept = store_.change_delivery(row);
  if (row.outcome == store::Outcome::kGivenUp) {
    log_.info("webhook not told", {{"owner", row.owner},
                                   {"webhook", row.webhook},
                                   {"delivery", std::to_string(row.number)},
                                   {"error", row.error}});
  }
  if (kept) return;
  log_.warn("what a webhook was told is not written down", kept.error());
  bell_.wait_for(lock, std::chrono::seconds(30), [this] { return stopping_; });
}

}  // namespace toile::webhooks
