// /api/v1/links and /api/v1/jobs/{id}/links: links by which an owner shows a job to whoever has them.

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "server/accounts/secrets.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/link_answer.h"
#include "server/http/problem.h"
#include "server/store/now.h"

namespace toile::handlers {
namespace {

constexpr double kMostDays = 3660;

json::JsonValue members_of(const store::LinkRow& link) {
  return std::vector<json::JsonMember>{
      {"id", link.id},
      {"job", link.job},
      {"label", link.label},
      {"take", takes_list(link.takes)},
      {"created_ms", static_cast<double>(link.created_ms)},
      {"expires_ms", static_cast<double>(link.expires_ms)},
      {"expired", link.expires_ms > 0 && link.expires_ms <= store::now_ms()}};
}

/// Error: links.take at its place.
Result<store::LinkTakes> read_takes(const json::JsonValue& given) {
  const json::JsonValue* take = given.find("take");
  if (!take) return store::LinkTakes{};
  if (!take->array()) return Error{"links.take", "\"take\" is a list of what may be taken", "/take"};
  std::string words;
  for (const json::JsonValue& word : *take->array()) {
    if (!word.text() || word.text()->empty())
      return Error{"links.take", "\"take\" is a list of words", "/take"};
    words += (words.empty() ? "" : ",") + *word.text();
  }
  Result<store::LinkTakes> takes = store::takes_from(words);
  return takes ? takes : Result<store::LinkTakes>(placed_at(takes.error(), "/take"));
}

/// Errors: links.label, links.days, links.take.
Result<store::LinkRow> read_link(const json::JsonValue& given) {
  store::LinkRow link;
  if (const json::JsonValue* label = given.find("label")) {
    if (!label->text() || label->text()->size() > kLongestLabel)
      return Error{"links.label", "\"label\" is a text of at most 80 bytes", "/label"};
    link.label = *label->text();
  }
  const json::JsonValue* days = given.find("days");
  if (days && !std::holds_alternative<std::nullptr_t>(days->data)) {
    const double* number = days->number();
    if (!number || !(*number > 0) || *number > kMostDays)
      return Error{"links.days", "\"days\" is a number over 0 and up to 3660, or null for ever", "/days"};
    constexpr double kDayMs = 24.0 * 3600 * 1000;
    link.expires_ms = store::now_ms() + static_cast<std::int64_t>(std::ceil(*number * kDayMs));
  }
  link.takes = TRY(read_takes(given));
  return link;
}

/// The one answer that has the secret: it is kept nowhere.
http::HttpResponse make_link(const Api& api, const store::RequestContext& context,
                             const http::HttpRequest& request) {
  const Result<json::JsonValue> given =
      read_object(request, {"label", "days", "take"}, {.bytes = http::kSmallBody, .depth = 8});
  if (!given) return http::problem(given.error());
  Result<store::LinkRow> wish = read_link(*given);
  if (!wish) return http::problem(422, wish.error());
  wish->owner = context.owner;
  wish->job = request.captures[0];
  const std::string secret = accounts::new_secret();
  const Result<store::LinkRow> link =
      api.store.links()->add_link(std::move(*wish), accounts::hash_of_secret(secret));
  if (!link) return http::problem(link.error());
  context.log.info("link made", LogFields{{"link", link->id}, {"job", link->job}});
  http::HttpResponse response =
      json_answer(200, {{"link", members_of(*link)}, {"secret", secret}, {"page", "/#/shared/" + secret}});
  for (auto& [name, value] : response.headers)
    if (name == "Cache-Control") value = "no-store";
  return created(std::move(response), "/api/v1/links/" + link->id);
}

http::HttpResponse listed(const Api& api, const store::RequestContext& context, const std::string& job) {
  const Result<std::vector<store::LinkRow>> links = api.store.links()->links(context.owner, job);
  if (!links) return http::problem(links.error());
  std::vector<json::JsonValue> list;
  for (const store::LinkRow& link : *links) list.push_back(members_of(link));
  return json_answer(200, {{"links", std::move(list)}});
}

http::HttpResponse list_links(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest&) {
  return listed(api, context, "");
}

http::HttpResponse list_of_job(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  return job ? listed(api, context, job->id) : http::problem(job.error());
}

http::HttpResponse revoke_link(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  const Status gone = api.store.links()->revoke_link(context.owner, request.captures[0]);
  if (!gone) return http::problem(gone.error());
  context.log.info("link taken back", LogFields{{"link", request.captures[0]}});
  return no_content();
}

}  // namespace

ApiRoutes link_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/jobs/{id}/links",
       .handler = make_link,
       .body = http::BodyKind::kJson},
      {.pattern = "/api/v1/jobs/{id}/links", .handler = list_of_job},
      {.pattern = "/api/v1/links", .handler = list_links},
      {.method = "DELETE", .pattern = "/api/v1/links/{id}", .handler = revoke_link},
  };
}

}  // namespace toile::handlers
