#pragma once
// A file is either whole or not there: bytes go to a temporary name beside it, then take its name.

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace toile {

/// Replaces `path` by a file of `bytes`. On failure the old file, if there was one, is as it was, and no
/// temporary file is left. Errors: "export.write" with the path as place and the system's reason.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace toile
