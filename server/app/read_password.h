#pragma once

#include <string>

#include "core/base/result.h"

namespace toile::app {

/// A password from stdin: from a terminal it is asked for twice and not shown, else the first line is it.
/// Error: usage.password.
Result<std::string> read_password();

}  // namespace toile::app
