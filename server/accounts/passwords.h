#pragma once
// Passwords, kept as what it takes long and much memory to come to.

#include <mutex>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace toile::accounts {

inline constexpr std::size_t kShortestPassword = 10, kLongestPassword = 256;  // bytes

/// argon2id with 19 MiB and two passes, and a salt of its own, as text. Errors: accounts.password when it is
/// too short or too long, internal.memory.
Result<std::string> hash_of_password(const std::string& password);

/// Whether it is the password of `hash`. Takes as long where `hash` is empty, so that nobody learns from the
/// time whether there is such an account.
bool is_password(const std::string& password, const std::string& hash);

}  // namespace toile::accounts
