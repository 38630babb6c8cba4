#pragma once
// Names of files that strangers give.

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::store {

/// A name that stands for one file within one folder: 1 to 255 bytes of UTF-8, no slash or backslash, no
/// leading dot, no control character. Error: store.bad_name.
Status check_name(std::string_view name);

/// ".obj" of "Body.OBJ": readers of meshes go by it. ".bin" where there is none that is short and plain.
std::string ending_of(std::string_view file_name);

}  // namespace toile::store
