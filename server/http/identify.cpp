#include "server/http/identify.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <string_view>

#include "core/base/text.h"
#include "server/http/problem.h"

namespace toile::http {
namespace {

bool is_plain_id(const std::string& id) {
  constexpr std::size_t kLongest = 64;
  return !id.empty() && id.size() <= kLongest && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  });
}

/// The value of a cookie (RFC 6265, 4.2.1); empty when it is not there.
std::string cookie_of(const HttpRequest& request, const std::string& name) {
  const std::string all = request.header("cookie");
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(';', at), all.size());
    const std::size_t begin = std::min(all.find_first_not_of(' ', at), end);
    const std::string_view pair = std::string_view(all).substr(begin, end - begin);
    if (pair.size() > name.size() && pair.starts_with(name) && pair[name.size()] == '=')
      return std::string(pair.substr(name.size() + 1));
    at = end + 1;
  }
  return "";
}

/// The token of "Authorization: Bearer …"; empty: none.
std::string bearer_of(const HttpRequest& request) {
  constexpr std::string_view kScheme = "bearer ";
  const std::string given = request.header("authorization");
  const bool bearer = lower_case(given.substr(0, kScheme.size())) == kScheme;
  return bearer ? given.substr(kScheme.size()) : "";
}

}  // namespace

RequestIds::RequestIds() {
  std::array<char, 16> text;
  std::snprintf(text.data(), text.size(), "r_%08x_", static_cast<unsigned>(std::random_device()()));
  prefix_ = text.data();
}

std::string RequestIds::next() { return prefix_ + std::to_string(++count_); }

store::RequestContext local_user(const std::string& request_id, const Log& log) {
  return store::RequestContext(store::kSingleUser, request_id, log);
}

std::string request_id_of(const HttpRequest& request, RequestIds& ids) {
  const std::string given = request.header("x-request-id");
  return is_plain_id(given) ? given : ids.next();
}

store::RequestContext nobody(const std::string& request_id, const Log& log) {
  store::RequestContext context("", request_id, log);
  context.scopes = {};
  return context;
}

store::RequestContext context_of(const accounts::Caller& caller, const std::string& request_id,
                                 const Log& log) {
  store::RequestContext context(caller.account.id, request_id, log);
  context.scopes = caller.scopes;
  context.key = caller.key_hash;
  return context;
}

std::optional<std::string> forwarded_for(const HttpRequest& request) {
  const std::string hops = request.header("x-forwarded-for");
  const std::size_t comma = hops.rfind(',');
  std::string last = comma == std::string::npos ? hops : hops.substr(comma + 1);
  std::erase(last, ' ');
  constexpr std::size_t kLongestAddress = 45;
  if (last.empty() || last.size() > kLongestAddress) return std::nullopt;
  return last;
}

std::string cookie_name(bool secure) { return secure ? "__Host-toile" : "toile"; }

std::string session_cookie(const std::string& name, const std::string& secret, std::chrono::seconds lasts) {
  const std::string secure = name.starts_with("__Host-") ? "; Secure" : "";
  return name + "=" + secret +
         "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(lasts.count()) + secure;
}

std::string link_cookie_name(const std::string& link, bool secure) {
  return (secure ? "__Secure-toile-" : "toile-") + link;
}

std::string link_cookie(const std::string& link, bool secure, const std::string& secret) {
  return link_cookie_name(link, secure) + "=" + secret + "; Path=/api/v1/shared/" + link +
         "; HttpOnly; SameSite=Strict" + (secure ? "; Secure" : "");
}

std::string link_secret_of(const HttpRequest& request, const std::string& link, bool secure) {
  const std::string token = bearer_of(request);
  return token.empty() ? cookie_of(request, link_cookie_name(link, secure)) : token;
}

accounts::Credentials credentials_of(const HttpRequest& request, const std::string& cookie) {
  return {.token = bearer_of(request), .cookie = cookie_of(request, cookie), .address = request.sender};
}

HttpResponse not_let_in(const Error& error, bool unknown, std::chrono::seconds wait) {
  if (unknown) {
    HttpResponse response = problem(401, error);
    response.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"toile\"");
    return response;
  }
  HttpResponse response = problem(error);
  for (auto& [name, value] : response.headers)
    if (name == "Retry-After" && wait.count() > 0) value = std::to_string(wait.count());
  return response;
}

std::optional<HttpResponse> not_allowed(const accounts::Caller& caller, Access access,
                                        const HttpRequest& request, bool websocket) {
  const bool looks = request.method == "GET" || request.method == "HEAD";
  const bool by_cookie = caller.key.kind == store::KeyKind::kSession;
  if (by_cookie && (!looks || websocket) && request.header("origin").empty())
    return problem(403, {"http.origin", "with a cookie a request says whose page it is of", "Origin"});
  const store::Scope needed = access == Access::kAdmin    ? store::Scope::kAdmin
                              : access == Access::kSubmit ? store::Scope::kSubmit
                                                          : store::Scope::kRead;
  if (caller.scopes.has(needed)) return std::nullopt;
  return problem(403, {"auth.scope",
                       "this wants a key of scope " + std::string(store::name_of(needed)) +
                           ", and yours has " + (caller.scopes.none() ? "none" : to_text(caller.scopes)),
                       "Authorization"});
}

}  // namespace toile::http
