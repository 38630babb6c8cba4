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
inline constexpr double kQuantum = 0.5;
/// And by this many times what it costs to take one up from its checkpoint, so that no more than about a
/// tenth of the workers' time goes there.
inline constexpr double kLoadsWorth = 9;

/// Who is to have a worker next, by their place among `waiting`; of equals the first. Nothing when nobody
/// waits.
std::optional<std::size_t> next_turn(std::span<const Claim> waiting);

/// Whether whoever runs is to make room for `waiting`. `load`: s that this costs beside; 0 where both stay in
/// memory.
bool makes_room(const Claim& running, const Claim& waiting, double load = 0);

/// How a drape makes room for another between two slices.
enum class MakeRoom {
  kNot,
  kInMemory,  ///< it waits there
  kAside,     ///< it leaves memory: its checkpoint is what waits
};

}  // namespace toile::jobs
