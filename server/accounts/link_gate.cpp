#include "server/accounts/link_gate.h"

#include <cstdint>
#include <utility>

#include "server/accounts/secrets.h"
#include "server/store/now.h"

namespace toile::accounts {
namespace {

Opened no_link() {
  return {Error{"links.unknown", "this link opens nothing here; perhaps it was not copied whole", ""}, true};
}

Opened revoked() {
  return {Error{"links.revoked", "this link was taken back by whoever shared it; ask them for another", "",
                ErrorKind::kNotFound},
          false, true};
}

}  // namespace

/// A locked account has nothing to show, and where there are accounts what belongs to none is nobody's.
Opened LinkGate::link_of(const std::string& hash) {
  Result<store::KnownLink> known = links_.link_of_secret(hash);
  if (!known && known.error().kind == ErrorKind::kNotFound) return no_link();
  if (!known) return {known.error()};
  const bool of_nobody = with_accounts_ && !known->has_account;
  if (known->link.revoked_ms > 0 || known->locked || of_nobody) return revoked();
  if (known->link.expires_ms > 0 && known->link.expires_ms <= store::now_ms()) {
    return {Error{"links.expired", "this link was good for a time that is over; ask for another", "",
                  ErrorKind::kNotFound},
            false, true};
  }
  return {std::move(known->link)};
}

Opened LinkGate::open(const std::string& secret, const std::string& address) {
  if (secret.empty()) {
    return {Error{"auth.required", "this is for whoever has a link to it; show its secret as a token", ""},
            true};
  }
  Opened opened = link_of(hash_of_secret(secret));
  if (!opened.unknown) return opened;
  const std::string network = network_of(address);
  const std::chrono::seconds wait = wrong_.wait(network);
  if (wait.count() > 0) {
    return {Error{"auth.guesses", "too many links from here were wrong; try again later", "",
                  ErrorKind::kTooMany},
            false, false, wait};
  }
  wrong_.missed(network);
  return opened;
}

bool LinkGate::is_still_good(const std::string& hash) {
  const Opened opened = link_of(hash);
  return !opened.unknown && !opened.over;
}

std::shared_ptr<const store::LinkRow> LinkGate::seat(const store::LinkRow& link) {
  const std::lock_guard hold(seats_->mutex);
  int& taken = seats_->taken[link.id];
  if (taken >= kMostViewers) return nullptr;
  const auto leave = [seats = seats_](const store::LinkRow* left) {
    const std::lock_guard again(seats->mutex);
    const auto found = seats->taken.find(left->id);
    if (--found->second == 0) seats->taken.erase(found);
    delete left;
  };
  ++taken;
  return {new store::LinkRow(link), leave};
}

}  // namespace toile::accounts
