#pragma once

#include "server/app/commands.h"

namespace toile::app {

/// Has a server drape the sweep, follows it, and brings table, sheet and results home.
ExitCode sweep_afar(const SweepOptions& options);

}  // namespace toile::app
