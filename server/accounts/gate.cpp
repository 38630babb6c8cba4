#include "server/accounts/gate.h"

#include <cstdint>
#include <utility>

#include "server/accounts/secrets.h"
#include "server/store/now.h"

namespace toile::accounts {
namespace {

/// In the same words whatever is the matter with it: who has found an old key need not learn that it was one.
Answer nobody_has_it() {
  return {
      Error{
          "auth.token",
          "this key is not known here, or no longer good; log in again, or ask whoever runs this for another",
          "Authorization"},
      true};
}

bool has_expired(const store::KeyRow& key) { return key.expires_ms > 0 && key.expires_ms <= store::now_ms(); }

/// An account that has lost its rights has lost them for all its keys.
store::Scopes scopes_of(const store::KnownKey& known) {
  store::Scopes scopes;
  for (const store::Scope scope : {store::Scope::kRead, store::Scope::kSubmit, store::Scope::kAdmin}) {
    const bool may = scope != store::Scope::kAdmin || known.account.admin;
    if (may && known.key.scopes.has(scope)) scopes = scopes.with(scope);
  }
  return scopes;
}

}  // namespace

Answer Gate::caller_of(const std::string& key_hash) {
  Result<store::KnownKey> known = accounts_.key_of_secret(key_hash);
  if (!known && known.error().kind == ErrorKind::kNotFound) return nobody_has_it();
  if (!known) return {known.error()};
  if (known->account.locked || has_expired(known->key)) return nobody_has_it();
  const store::Scopes scopes = scopes_of(*known);
  return {Caller{std::move(known->account), std::move(known->key), key_hash, scopes}};
}

/// A cookie's key is no token, nor the other way round: what a browser holds is of no use to a program.
Answer Gate::shown_by(const Credentials& shown) {
  const bool by_token = !shown.token.empty();
  Answer answer = caller_of(hash_of_secret(by_token ? shown.token : shown.cookie));
  if (!answer.caller) return answer;
  const store::KeyKind wanted = by_token ? store::KeyKind::kToken : store::KeyKind::kSession;
  return answer.caller->key.kind == wanted ? answer : nobody_has_it();
}

Answer Gate::who(const Credentials& shown) {
  if (shown.token.empty() && shown.cookie.empty()) {
    return {Error{"auth.required", "log in, or send a token as \"Authorization: Bearer …\"", "Authorization"},
            true};
  }
  Answer answer = shown_by(shown);
  if (!answer.unknown) return answer;
  const std::string network = network_of(shown.address);
  const std::chrono::seconds wait = wrong_tokens_.wait(network);
  if (wait.count() > 0) {
    return {Error{"auth.guesses", "too many tokens from here were wrong; try again later", "",
                  ErrorKind::kTooMany},
            false, wait};
  }
  wrong_tokens_.missed(network);
  return answer;
}

bool Gate::is_still_good(const std::string& key_hash) { return !caller_of(key_hash).unknown; }

}  // namespace toile::accounts
