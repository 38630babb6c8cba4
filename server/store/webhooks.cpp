#include "server/store/webhooks.h"

namespace toile::store {

std::string_view word_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kWaiting:
      return "waiting";
    case Outcome::kDelivered:
      return "delivered";
    case Outcome::kGivenUp:
      return "given_up";
  }
  return "";
}

}  // namespace toile::store
