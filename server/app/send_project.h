#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "server/app/remote.h"

namespace toile::app {

/// Sends the document at `path` and the files that it names, as far as the server has them not; the new
/// project's id. Errors: those of the calls; json.*, project.*.
Result<std::string> send_project(Remote& remote, const std::string& path);

/// A file as it goes to a server. Errors, at `where`: project.too_large, project.file.
Result<std::string> read_upload(const std::filesystem::path& path, const std::string& where);

}  // namespace toile::app
