#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace toile {

/// The whole file's bytes; nothing where it cannot be opened or read to its end (a folder, for one).
std::optional<std::string> read_file(const std::filesystem::path& path);

}  // namespace toile
