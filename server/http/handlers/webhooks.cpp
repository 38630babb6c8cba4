// /api/v1/webhooks: addresses that are told when a drape has ended, and what they were told.

#include "server/http/handlers/webhooks.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "server/accounts/secrets.h"
#include "server/http/handlers/answer.h"
#include "server/http/problem.h"
#include "server/http/remote_url.h"
#include "server/store/webhooks.h"

namespace toile::handlers {
namespace {

std::vector<std::string> final_states() {
  std::vector<std::string> words;
  for (const store::JobState state :
       {store::JobState::kSucceeded, store::JobState::kFailed, store::JobState::kCancelled})
    words.emplace_back(store::name_of(state));
  return words;
}

json::JsonValue members_of(const store::WebhookRow& webhook) {
  std::vector<json::JsonValue> states;
  for (const std::string& state : webhook.states) states.emplace_back(state);
  return std::vector<json::JsonMember>{{"id", webhook.id},
                                       {"url", webhook.url},
                                       {"states", std::move(states)},
                                       {"label", webhook.label},
                                       {"created_ms", static_cast<double>(webhook.created_ms)}};
}

json::JsonValue members_of(const store::DeliveryRow& delivery) {
  const bool waits = delivery.outcome == store::Outcome::kWaiting;
  return std::vector<json::JsonMember>{{"delivery", static_cast<double>(delivery.number)},
                                       {"event", static_cast<double>(delivery.event.number)},
                                       {"job", delivery.event.job},
                                       {"state", delivery.event.state},
                                       {"at_ms", static_cast<double>(delivery.event.at_ms)},
                                       {"outcome", std::string(store::word_of(delivery.outcome))},
                                       {"attempts", static_cast<double>(delivery.attempts)},
                                       {"next_ms", waits ? static_cast<double>(delivery.next_ms) : 0.0},
                                       {"status", static_cast<double>(delivery.status)},
                                       {"error", delivery.error}};
}

/// Error: webhooks.states.
Result<std::vector<std::string>> read_states(const json::JsonValue& given) {
  const std::vector<std::string> known = final_states();
  const json::JsonValue* list = given.find("states");
  if (!list) return known;
  const Error wrong{"webhooks.states",
                    "\"states\" is a list of succeeded, failed and cancelled, one at least", "/states"};
  if (!list->array() || list->array()->empty()) return wrong;
  std::vector<std::string> states;
  for (const json::JsonValue& word : *list->array()) {
    if (!word.text() || std::find(known.begin(), known.end(), *word.text()) == known.end()) return wrong;
    if (std::find(states.begin(), states.end(), *word.text()) == states.end()) states.push_back(*word.text());
  }
  return states;
}

/// Errors: webhooks.url, webhooks.label, webhooks.states.
Result<store::WebhookRow> read_webhook(const json::JsonValue& given) {
  store::WebhookRow webhook;
  const json::JsonValue* url = given.find("url");
  if (url && url->text()) webhook.url = *url->text();
  const Result<http::RemoteUrl> parts = http::read_remote_url(webhook.url);
  if (!parts) return Error{"webhooks.url", parts.error().message, "/url"};
  webhook.states = TRY(read_states(given));
  if (const json::JsonValue* label = given.find("label")) {
    if (!label->text() || label->text()->size() > kLongestLabel)
      return Error{"webhooks.label", "\"label\" is a text of at most 80 bytes", "/label"};
    webhook.label = *label->text();
  }
  return webhook;
}

/// Those of the store.
store::Webhooks& webhooks_in(const Api& api) {
  store::Webhooks* const webhooks = store::webhooks_of(api.store);
  TOILE_CHECK(webhooks != nullptr);
  return *webhooks;
}

/// The one answer that tells the secret.
http::HttpResponse make_webhook(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Result<json::JsonValue> given =
      read_object(request, {"url", "states", "label"}, {.bytes = http::kSmallBody, .depth = 8});
  if (!given) return http::problem(given.error());
  Result<store::WebhookRow> wish = read_webhook(*given);
  if (!wish) return http::problem(422, wish.error());
  wish->owner = context.owner;
  wish->secret = accounts::new_secret();
  const Result<store::WebhookRow> webhook = webhooks_in(api).add_webhook(std::move(*wish));
  if (!webhook) return http::problem(webhook.error());
  context.log.info("webhook made", LogFields{{"webhook", webhook->id}});
  http::HttpResponse response =
      json_answer(200, {{"webhook", members_of(*webhook)}, {"secret", webhook->secret}});
  for (auto& [name, value] : response.headers)
    if (name == "Cache-Control") value = "no-store";
  return created(std::move(response), "/api/v1/webhooks/" + webhook->id);
}

http::HttpResponse list_webhooks(const Api& api, const store::RequestContext& context,
                                 const http::HttpRequest&) {
  const Result<std::vector<store::WebhookRow>> webhooks = webhooks_in(api).webhooks(context.owner);
  if (!webhooks) return http::problem(webhooks.error());
  std::vector<json::JsonValue> items;
  for (const store::WebhookRow& webhook : *webhooks) items.push_back(members_of(webhook));
  return json_answer(200, {{"webhooks", std::move(items)}});
}

http::HttpResponse remove_webhook(const Api& api, const store::RequestContext& context,
                                  const http::HttpRequest& request) {
  const Status gone = webhooks_in(api).remove_webhook(context.owner, request.captures[0]);
  if (!gone) return http::problem(gone.error());
  context.log.info("webhook removed", LogFields{{"webhook", request.captures[0]}});
  return no_content();
}

http::HttpResponse ping(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Status asked = webhooks_in(api).ping_webhook(context.owner, request.captures[0]);
  if (!asked) return http::problem(asked.error());
  http::HttpResponse response;
  response.status = 202;
  return response;
}

http::HttpResponse list_deliveries(const Api& api, const store::RequestContext& context,
                                   const http::HttpRequest& request) {
  constexpr int kShown = 100;
  const auto deliveries = webhooks_in(api).deliveries(context.owner, request.captures[0], kShown);
  if (!deliveries) return http::problem(deliveries.error());
  std::vector<json::JsonValue> items;
  for (const store::DeliveryRow& delivery : *deliveries) items.push_back(members_of(delivery));
  return json_answer(200, {{"deliveries", std::move(items)}});
}

}  // namespace

ApiRoutes webhook_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/webhooks",
       .handler = make_webhook,
       .body = http::BodyKind::kJson},
      {.pattern = "/api/v1/webhooks", .handler = list_webhooks},
      {.method = "DELETE", .pattern = "/api/v1/webhooks/{id}", .handler = remove_webhook},
      {.method = "POST", .pattern = "/api/v1/webhooks/{id}/ping", .handler = ping},
      {.pattern = "/api/v1/webhooks/{id}/deliveries", .handler = list_deliveries},
  };
}

}  // namespace toile::handlers
