#pragma once
// Files that end in the hash of all that stands before. A fuzzer never finds that hash, so that it would try
// nothing but the refusal: here inputs are the bytes before it, and each is sealed when it is tried.

#include <string>
#include <string_view>

#include "core/base/hash.h"

namespace toile::fuzz {

inline constexpr std::size_t kSealDigits = 32;

inline std::string sealed(std::string_view bytes) { return std::string(bytes) + hash_of(bytes); }

/// The seed that a whole file makes.
inline std::string unsealed(const std::string& file) { return file.substr(0, file.size() - kSealDigits); }

}  // namespace toile::fuzz
