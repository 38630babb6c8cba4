#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace toile::app {

/// A document names files in its own folder: the file comes to lie there, under `name` or its own, whole at
/// any time: another command may read it there. Error: export.write.
Status bring_file(const std::filesystem::path& file, const std::filesystem::path& folder,
                  const std::string& name = "");

}  // namespace toile::app
