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

accounts::Credentials credentials_of(const HttpRequest& request, const std::string& address) {
  constexpr std::string_view kScheme = "bearer ";
  const std::string given = request.header("authorization");
  const bool bearer = lower_case(given.substr(0, kScheme.size())) == kScheme;
  return {bearer ? given.substr(kScheme.size()) : "", address};
}

HttpResponse not_let_in(const accounts::Answer& answer) {
  const Error& error = answer.caller.error();
  if (!answer.unknown) {
    HttpResponse response = problem(error);
    for (auto& [name, value] : response.headers)
      if (name == "Retry-After" && answer.wait.count() > 0) value = std::to_string(answer.wait.count());
    return response;
  }
  HttpResponse response = problem(401, error);
  response.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"toile\"");
  return response;
}

std::optional<HttpResponse> not_allowed(const accounts::Caller& caller, Access access) {
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
