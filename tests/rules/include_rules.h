#pragma once
// Who may include whom: the table of ARCHITECTURE.md as data, and the check of a source tree against it.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace toile::rules {

/// What an #include breaks, "path:line: reason".
using Violations = std::vector<std::string>;

/// Checks one file's includes. `path` is relative to the repo root; `sibling_header` says whether a header of
/// the same name stands beside it, which then must be included first.
Violations check_file(const std::string& path, std::string_view text, bool sibling_header);

/// Checks every .h and .cpp under core/, proto/cpp/ and server/ of `root`, and that what they include is
/// there.
Violations check_tree(const std::filesystem::path& root);

/// What the table allows and nobody under `root` uses: arrows, rooms, and libraries' doors.
Violations unused_arrows(const std::filesystem::path& root);

}  // namespace toile::rules
