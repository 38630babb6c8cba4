#pragma once
// How what runs until it is told to end is told so.

#include <signal.h>

#include <chrono>
#include <functional>

#include "core/base/log.h"

namespace toile::app {

/// What is done when SIGHUP comes, which ends the program where nothing is said here.
using OnHangUp = std::function<void()>;

/// SIGINT and SIGTERM, held back from every thread that is made from now on; SIGHUP too where `hang_up`.
sigset_t hold_ending_signals(bool hang_up = false);

/// Until one of them comes. From then on a second one ends the program at once. Each SIGHUP among `signals`
/// is answered by `on_hang_up`.
void wait_for_the_end(const sigset_t& signals, const OnHangUp& on_hang_up = {});

/// Ends the process by then, whatever still runs in it: a picture or an arrangement cannot be broken off. The
/// store has all that it said it had, so that this costs no more than a crash.
void end_anyway_in(std::chrono::seconds time, const Log& log);

}  // namespace toile::app
