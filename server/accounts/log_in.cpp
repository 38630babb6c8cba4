#include "server/accounts/log_in.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "server/accounts/passwords.h"
#include "server/accounts/secrets.h"

namespace toile::accounts {
namespace {

std::int64_t session_end_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>((system_clock::now() + LogIn::kSession).time_since_epoch()).count();
}

Begun too_many_wrong(std::chrono::seconds wait) {
  return {Error{"auth.guesses", "too many passwords were wrong; try again later", "", ErrorKind::kTooMany},
          false, wait};
}

store::Scopes scopes_of(const store::AccountRow& account) {
  const store::Scopes usual = store::Scopes().with(store::Scope::kRead).with(store::Scope::kSubmit);
  return account.admin ? usual.with(store::Scope::kAdmin) : usual;
}

}  // namespace

Begun LogIn::begin(const store::AccountRow& account, store::Scopes scopes, std::int64_t until_ms) {
  store::KeyRow key;
  key.owner = account.id;
  key.kind = store::KeyKind::kSession;
  key.scopes = scopes;
  key.expires_ms = until_ms;
  std::string secret = new_secret();
  const Result<store::KeyRow> kept = accounts_.add_key(std::move(key), hash_of_secret(secret));
  if (!kept) return {kept.error()};
  return {std::move(secret)};
}

Begun LogIn::with_password(const std::string& name, const std::string& password, const std::string& address) {
  const std::string network = network_of(address), both = name.substr(0, 64) + '@' + network;
  const std::chrono::seconds wait = std::max(of_account_.wait(both), of_address_.wait(network));
  if (wait.count() > 0) return too_many_wrong(wait);
  const Result<store::AccountRow> account = accounts_.account_named(name);
  if (!account && account.error().kind != ErrorKind::kNotFound) return {account.error()};
  if (!hashing_.try_acquire_for(std::chrono::seconds(5))) {
    return {
        Error{"server.busy", "many log in at once; try again in a few seconds", "", ErrorKind::kUnavailable}};
  }
  const bool right = is_password(password, account ? account->password : "");
  hashing_.release();
  if (right && !account->locked) {
    of_account_.met(both);
    return begin(*account, scopes_of(*account), session_end_ms());
  }
  of_account_.missed(both);
  of_address_.missed(network);
  return {Error{"auth.password", "name and password do not belong together", ""}, true};
}

Begun LogIn::with_token(const std::string& token, const std::string& address) {
  const Answer answer = gate_.who({.token = token, .cookie = {}, .address = address});
  if (!answer.caller) return {answer.caller.error(), answer.unknown, answer.wait};
  const Caller& caller = *answer.caller;
  const std::int64_t end = session_end_ms(), of_key = caller.key.expires_ms;
  return begin(caller.account, caller.scopes, of_key > 0 ? std::min(end, of_key) : end);
}

}  // namespace toile::accounts
