#pragma once
// Who has had how much of something that all share, so that whoever has had least is served next.

#include <map>

#include "server/store/request_context.h"

namespace toile::shares {

/// Start-time fair queueing (Goyal, Vin, Cheng 1996): what somebody has had is counted up, and whoever begins
/// to want something counts as having had at least as much as anybody who wants something then. So nobody
/// saves anything up by staying away, and nobody is owed for the past. Not thread-safe.
class OwnerShares {
 public:
  /// Somebody wants something more; each call is taken back by leave().
  void enter(const store::OwnerId& owner);
  void leave(const store::OwnerId& owner);
  /// REQUIRES that they have entered.
  void charge(const store::OwnerId& owner, double amount);
  /// 0 for who has not entered.
  double had(const store::OwnerId& owner) const;

 private:
  struct Account {
    double had = 0;
    int wants = 0;
  };
  double least() const;
  void forget_the_idle();

  std::map<store::OwnerId, Account> accounts_;
  double floor_ = 0;  ///< what whoever comes counts as having had, when nobody else wants anything
};

}  // namespace toile::shares
