#pragma once

#include <string>

#include "core/base/result.h"

namespace toile::app {

/// The token of a file (its first line), or, where no file is named, of the environment's TOILE_TOKEN; empty
/// when there is none. Never of the command line, which everybody on a machine can read. Error: usage.token.
Result<std::string> read_token(const std::string& path);

}  // namespace toile::app
