#pragma once
// Lets in who has a share link, to what it shows and nothing else.

#include <chrono>
#include <string>

#include "core/base/result.h"
#include "server/accounts/guesses.h"
#include "server/store/links.h"

namespace toile::accounts {

/// The link that was shown, or why it opens nothing.
struct Opened {
  Result<store::LinkRow> link;
  bool unknown = false;          ///< nothing was shown, or no link
  bool over = false;             ///< it was good once
  std::chrono::seconds wait{0};  ///< over 0: this address was wrong too often, and may try again then
};

/// Calls are thread-safe and may block.
class LinkGate {
 public:
  static constexpr int kMostWrong = 10;  ///< secrets a minute, of an address

  /// `with_accounts`: only what somebody has who has an account is shown.
  LinkGate(store::Links& links, bool with_accounts) : links_(links), with_accounts_(with_accounts) {}

  /// Errors: auth.required when nothing is shown; links.unknown when it is no link's secret; links.expired
  /// and links.revoked, which only who has it is told; auth.guesses, kind kTooMany, when an address was wrong
  /// too often; and those of the store. A link that is good opens however often others of its address were
  /// wrong.
  Opened open(const std::string& secret, const std::string& address);

  /// Whether a link still shows something: while a stream goes on it can expire or be taken back. `hash` is
  /// of its secret. True also when the store cannot say.
  bool is_still_good(const std::string& hash);

 private:
  Opened link_of(const std::string& hash);

  store::Links& links_;
  const bool with_accounts_;
  Guesses wrong_{kMostWrong};  // by address
};

}  // namespace toile::accounts
