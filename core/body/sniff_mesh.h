#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace toile {

/// Looks at a mesh file before the reader does, which trusts its input too much: it runs past the end of text
/// without line ends and works through whatever counts a header claims. The name's ending must be that of a
/// format we take, and the first bytes must fit it. Errors: "mesh.unreadable".
Status sniff_mesh(const std::filesystem::path& path);

}  // namespace toile
