#pragma once

#include <string>

#include "core/base/result.h"

namespace toile::app {

/// A pattern file's bytes, of at most 64 MiB. Errors: pattern.file (not there, or nothing that can be read),
/// pattern.too_large.
Result<std::string> pattern_bytes(const std::string& path);

}  // namespace toile::app
