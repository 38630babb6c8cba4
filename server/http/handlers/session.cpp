// /api/v1/session and /api/v1/keys: how a browser comes in and goes, and the keys of whoever asks.

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "server/accounts/secrets.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/identify.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

http::HttpResponse no_accounts() {
  return http::problem(
      409, {"auth.no_accounts", "this server has no accounts: whoever comes is its one user", ""});
}

std::vector<json::JsonValue> list_of(store::Scopes scopes) {
  std::vector<json::JsonValue> names;
  for (const store::Scope scope : {store::Scope::kRead, store::Scope::kSubmit, store::Scope::kAdmin})
    if (scopes.has(scope)) names.emplace_back(std::string(store::name_of(scope)));
  return names;
}

std::string text_member(const json::JsonValue& given, const char* key) {
  const json::JsonValue* found = given.find(key);
  return found && found->text() ? *found->text() : "";
}

/// Who asks, and by what right.
http::HttpResponse show_session(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest&) {
  if (!api.doors) {
    return json_answer(200, {{"accounts", false},
                             {"name", json::JsonValue()},
                             {"scopes", list_of(context.scopes)},
                             {"expires_ms", 0.0}});
  }
  const Result<store::KnownKey> known = api.store.accounts()->key_of_secret(context.key);
  if (!known) return http::problem(known.error());
  return json_answer(200, {{"accounts", true},
                           {"name", known->account.name},
                           {"scopes", list_of(context.scopes)},
                           {"expires_ms", static_cast<double>(known->key.expires_ms)}});
}

/// A session, for a name and a password or for a token.
http::HttpResponse begin(const Api& api, const store::RequestContext&, const http::HttpRequest& request) {
  if (!api.doors) return no_accounts();
  const Result<json::JsonValue> given = read_object(request, {"name", "password", "token"}, kStrangerLimits);
  if (!given) return http::problem(given.error());
  const std::string token = text_member(*given, "token"), name = text_member(*given, "name");
  const accounts::Begun begun =
      token.empty() ? api.doors->log_in.with_password(name, text_member(*given, "password"), request.sender)
                    : api.doors->log_in.with_token(token, request.sender);
  if (!begun.secret) return http::not_let_in(begun.secret.error(), begun.unknown, begun.wait);
  http::HttpResponse response = no_content();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(accounts::LogIn::kSession);
  response.headers.emplace_back("Set-Cookie",
                                http::session_cookie(api.doors->cookie, *begun.secret, seconds));
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

/// The session ends, here and for whoever else has its cookie.
http::HttpResponse end(const Api& api, const store::RequestContext& context, const http::HttpRequest&) {
  if (!api.doors) return no_accounts();
  store::Accounts& kept = *api.store.accounts();
  const Result<store::KnownKey> known = kept.key_of_secret(context.key);
  if (!known) return http::problem(known.error());
  if (known->key.kind != store::KeyKind::kSession)
    return http::problem(409,
                         {"auth.no_session", "this is no session but a token; revoke it among the keys", ""});
  if (Status ended = kept.remove_key(context.owner, known->key.id); !ended)
    return http::problem(ended.error());
  http::HttpResponse response = no_content();
  response.headers.emplace_back("Set-Cookie",
                                http::session_cookie(api.doors->cookie, "", std::chrono::seconds(0)));
  return response;
}

json::JsonValue members_of(const store::KeyRow& key) {
  const bool session = key.kind == store::KeyKind::kSession;
  return std::vector<json::JsonMember>{{"id", key.id},
                                       {"kind", std::string(session ? "session" : "token")},
                                       {"label", key.label},
                                       {"scopes", list_of(key.scopes)},
                                       {"created_ms", static_cast<double>(key.created_ms)},
                                       {"expires_ms", static_cast<double>(key.expires_ms)}};
}

http::HttpResponse list_keys(const Api& api, const store::RequestContext& context, const http::HttpRequest&) {
  if (!api.doors) return no_accounts();
  const Result<std::vector<store::KeyRow>> keys = api.store.accounts()->keys(context.owner);
  if (!keys) return http::problem(keys.error());
  std::vector<json::JsonValue> list;
  for (const store::KeyRow& key : *keys) list.push_back(members_of(key));
  return json_answer(200, {{"keys", std::move(list)}});
}

http::HttpResponse revoke_key(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  if (!api.doors) return no_accounts();
  const Status gone = api.store.accounts()->remove_key(context.owner, request.captures[0]);
  return gone ? no_content() : http::problem(gone.error());
}

}  // namespace

ApiRoutes session_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/session",
       .handler = begin,
       .body = http::BodyKind::kJson,
       .limit = [](const http::HttpRequest&) { return kStrangerBytes; },
       .work = http::Work::kDocument,
       .access = http::Access::kOpen},
      {.pattern = "/api/v1/session", .handler = show_session},
      {.method = "DELETE", .pattern = "/api/v1/session", .handler = end, .access = http::Access::kRead},
      {.pattern = "/api/v1/keys", .handler = list_keys},
      {.method = "DELETE", .pattern = "/api/v1/keys/{id}", .handler = revoke_key},
  };
}

}  // namespace toile::handlers
