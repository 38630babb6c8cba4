#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/types.h"

namespace toile {

/// 128-bit XXH3 of the positions' bytes (IEEE doubles, little endian), as 32 hex digits. Equal input
/// gives an equal hash on every machine; -0 and 0 count as the same.
std::string hash_of(std::span<const Vec3> positions);

/// 128-bit XXH3 of the bytes, as 32 hex digits.
std::string hash_of(std::string_view bytes);

}  // namespace toile
