#pragma once
// Lets in who is known, and nobody else.

#include <chrono>
#include <string>

#include "core/base/result.h"
#include "server/accounts/guesses.h"
#include "server/store/accounts.h"

namespace toile::accounts {

/// What a request shows of who sends it.
struct Credentials {
  std::string token;    ///< of "Authorization: Bearer"; empty: none
  std::string cookie;   ///< of a session; looked at where there is no token
  std::string address;  ///< where it comes from
};

/// Somebody who is known.
struct Caller {
  store::AccountRow account;
  store::KeyRow key;
  std::string key_hash;
  store::Scopes scopes;  ///< of the key, as far as the account's rights go
};

/// Who it is, or why nobody.
struct Answer {
  Result<Caller> caller;
  bool unknown = false;          ///< nobody is known by what was shown, or nothing was
  std::chrono::seconds wait{0};  ///< over 0: this address was wrong too often, and may try again then
};

/// Calls are thread-safe and may block.
class Gate {
 public:
  static constexpr int kMostWrongTokens = 10;  ///< a minute, of an address

  explicit Gate(store::Accounts& accounts) : accounts_(accounts) {}

  /// Errors: auth.required when nothing is shown, auth.token when what is shown is no key of anybody, or none
  /// any more; auth.guesses, kind kTooMany, when an address was wrong too often; and those of the store. A
  /// key that is good is let in however often others of its address were wrong: 256 bits of chance are not
  /// guessed, and the limit bounds the noise.
  Answer who(const Credentials& shown);

  /// Whether a caller's key is still good: while a stream goes on it can be revoked, expire, or its account
  /// be locked. True also when the store cannot say.
  bool is_still_good(const std::string& key_hash);

 private:
  Answer caller_of(const std::string& key_hash);
  Answer shown_by(const Credentials& shown);

  store::Accounts& accounts_;
  Guesses wrong_tokens_{kMostWrongTokens};  // by address
};

}  // namespace toile::accounts
