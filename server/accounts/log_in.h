#pragma once
// How a person comes in by a browser: a password or a token against a session, whose key a cookie holds.

#include <chrono>
#include <semaphore>
#include <string>

#include "core/base/result.h"
#include "server/accounts/gate.h"
#include "server/accounts/guesses.h"
#include "server/store/accounts.h"

namespace toile::accounts {

/// The key of a session that has begun, or why none has.
struct Begun {
  Result<std::string> secret;
  bool unknown = false;          ///< name and password do not belong together, or the token is nobody's
  std::chrono::seconds wait{0};  ///< over 0: too many were wrong
};

/// Calls are thread-safe and may block.
class LogIn {
 public:
  static constexpr int kMostWrong = 5;            ///< passwords a minute, of an account at an address
  static constexpr int kMostWrongOfAddress = 20;  ///< and of an address, whatever the account
  static constexpr std::chrono::hours kSession{7 * 24};

  LogIn(store::Accounts& accounts, Gate& gate) : accounts_(accounts), gate_(gate) {}

  /// Errors: auth.password in the same words for a wrong name, a wrong password and an account that is locked
  /// or has none; auth.guesses, before anything is tried; server.busy, kind kUnavailable, when many try at
  /// once, since each costs 19 MiB.
  Begun with_password(const std::string& name, const std::string& password, const std::string& address);
  /// A session of the token's scopes that ends no later than the token. Errors: those of Gate::who.
  Begun with_token(const std::string& token, const std::string& address);

 private:
  Begun begin(const store::AccountRow& account, store::Scopes scopes, std::int64_t until_ms);

  store::Accounts& accounts_;
  Gate& gate_;
  Guesses of_account_{kMostWrong}, of_address_{kMostWrongOfAddress};
  std::counting_semaphore<2> hashing_{2};
};

}  // namespace toile::accounts
