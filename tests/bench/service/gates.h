#pragma once
// The gates of the service that are figures. Each starts servers of its own and ends them.

#include "tests/bench/service/figure.h"

namespace toile::bench {

/// How thoroughly: `times` as many tries, `soak_minutes` of load for the slope of memory.
struct Scale {
  int times = 1;
  double soak_minutes = 3;
};

/// How long submitting takes with 50 clients at once: on a server that drapes nothing, and where two workers
/// drape what comes.
Figures submit_gate(const Scale& scale);
/// Tiny drapes without pictures, in seconds by the clock on one worker and in processor seconds.
Figures light_gate(const Scale& scale);
/// When an interactive drape makes its first steps, among 20 of batch on two workers.
Figures interactive_gate(const Scale& scale);
/// What 50 owners have had of two workers, with drapes of different lengths: short ones, and some that never
/// end.
Figures fairness_gate(const Scale& scale);
/// Eight drapes on one worker and on two.
Figures workers_gate(const Scale& scale);
/// 50 viewers of a drape, and 50 more that do not read.
Figures viewers_gate(const Scale& scale);
/// How the server's memory grows while it is used.
Figures memory_gate(const Scale& scale);

}  // namespace toile::bench
