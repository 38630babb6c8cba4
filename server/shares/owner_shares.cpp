#include "server/shares/owner_shares.h"

#include <algorithm>
#include <limits>

namespace toile::shares {

/// Of those who want something; as it was last when nobody does.
double OwnerShares::least() const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [owner, account] : accounts_) {
    if (account.wants > 0) least = std::min(least, account.had);
  }
  return std::max(floor_, least < std::numeric_limits<double>::infinity() ? least : floor_);
}

void OwnerShares::enter(const store::OwnerId& owner) {
  floor_ = least();
  Account& account = accounts_[owner];
  if (account.wants++ == 0) account.had = std::max(account.had, floor_);
}

void OwnerShares::leave(const store::OwnerId& owner) {
  floor_ = least();
  const auto found = accounts_.find(owner);
  if (found == accounts_.end() || found->second.wants == 0) return;
  --found->second.wants;
  forget_the_idle();
}

void OwnerShares::charge(const store::OwnerId& owner, double amount) {
  const auto found = accounts_.find(owner);
  if (found != accounts_.end()) found->second.had += amount;
}

double OwnerShares::had(const store::OwnerId& owner) const {
  const auto found = accounts_.find(owner);
  return found == accounts_.end() ? 0 : found->second.had;
}

/// Who is not ahead of the floor would be set on it when he comes again. The others stay, so that nobody gets
/// rid of what he has had by going for a moment.
void OwnerShares::forget_the_idle() {
  std::erase_if(accounts_,
                [this](const auto& entry) { return entry.second.wants == 0 && entry.second.had <= floor_; });
}

}  // namespace toile::shares
