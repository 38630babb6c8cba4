#pragma once

namespace toile::app {

/// Stands under the help of every verb.
inline constexpr const char* kExitCodes =
    "Exit codes: 0 done (a drape has settled), 1 internal error, 2 wrong arguments or bad input, 3 the "
    "drape\n"
    "ended before it settled (results are written), 4 cancelled, 5 the cloth\n"
    "came to rest but is not worn, 6 verify: not the same. Errors go to stderr as\n"
    "\"toile: code: message (where)\", with --json as {\"error\": {\"code\", \"message\", \"where\"}}.\n";

}  // namespace toile::app
