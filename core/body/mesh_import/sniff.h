#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::mesh_import {

/// Looks at a mesh file before the reader does, which trusts its input too much: it runs past the end of text
/// without line ends and works through whatever counts a header claims. The name's ending must be that of a
/// format of mesh_formats() (with `any_format` others pass unseen), and the first bytes must fit it. Errors:
/// "mesh.unreadable".
Status sniff_mesh(const std::filesystem::path& path, bool any_format);
Status sniff_mesh_bytes(const std::string& name, std::string_view bytes, bool any_format);

}  // namespace toile::mesh_import
