#pragma once
// Work counted instead of timed: how often this program's thread has asked for memory. The same on every
// machine, whatever else runs there.

#include <cstddef>

namespace toile::test {

/// Since the thread's start.
std::size_t allocations();

}  // namespace toile::test
