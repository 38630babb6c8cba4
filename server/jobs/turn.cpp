#include "server/jobs/turn.h"

#include <algorithm>

namespace toile::jobs {
namespace {

/// The less, the sooner, s.
double standing(const Claim& claim) {
  return claim.had - (claim.priority == store::JobPriority::kInteractive ? kHeadStart : 0);
}

}  // namespace

std::optional<std::size_t> next_turn(std::span<const Claim> waiting) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    if (!best || standing(waiting[i]) < standing(waiting[*best])) best = i;
  }
  return best;
}

bool makes_room(const Claim& running, const Claim& waiting, double load) {
  return standing(running) - standing(waiting) > std::max(kQuantum, kLoadsWorth * load);
}

}  // namespace toile::jobs
