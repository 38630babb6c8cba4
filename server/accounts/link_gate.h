#pragma once
// Lets in who has a share link, to what it shows and nothing else.

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
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
  static constexpr int kMostWrong = 10;    ///< secrets a minute, of an address
  static constexpr int kMostViewers = 50;  ///< streams of a link at once

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

  /// A seat among those who follow a link's stream: so many people do, and who passes a link on to all the
  /// world does not use up the server's connections. It is given back when the last copy goes, be it after
  /// the gate. Null when all are taken.
  std::shared_ptr<const store::LinkRow> seat(const store::LinkRow& link);

 private:
  /// How many look on, by link.
  struct Seats {
    std::mutex mutex;
    std::map<std::string, int> taken;
  };
  Opened link_of(const std::string& hash);

  store::Links& links_;
  const bool with_accounts_;
  Guesses wrong_{kMostWrong};  // by address
  const std::shared_ptr<Seats> seats_ = std::make_shared<Seats>();
};

}  // namespace toile::accounts
