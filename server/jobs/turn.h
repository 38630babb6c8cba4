#pragma once
// Whose turn it is when several drapes want a worker. Pure.

#include <cstddef>
#include <optional>
#include <span>

#include "server/store/job_priority.h"

namespace toile::jobs {

/// A drape that wants a worker, or has one.
struct Claim {
  double had = 0;  ///< s of processor time that its owner has had (server/shares)
  store::JobPriority priority = store::JobPriority::kBatch;
};

/// An interactive drape goes before another owner's batch work unless its owner has had so much more, s: who
/// calls all that he asks for interactive holds the others up no longer than that.
inline constexpr double kHeadStart = 60;
/// A drape makes room for one that stands better by this much, s: less would change drapes all the time.
inline constexpr double kQuantum = 1;

/// Who is to have a worker next, by their place among `waiting`; of equals the first. Nothing when nobody
/// waits.
std::optional<std::size_t> next_turn(std::span<const Claim> waiting);

/// Whether whoever runs is to make room for `waiting`.
bool makes_room(const Claim& running, const Claim& waiting);

}  // namespace toile::jobs
