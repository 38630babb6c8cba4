#pragma once
// Secrets that nobody guesses, and what is kept of them.

#include <string>
#include <string_view>

namespace toile::accounts {

/// "toile_" and 64 hex digits: 256 bits of the system's chance.
std::string new_secret();

/// BLAKE2b of a secret, 64 hex digits. A secret that is all chance needs no salt and no slow hash; and since
/// it is looked up by this hash, how long that takes tells nothing of the secret.
std::string hash_of_secret(std::string_view secret);

}  // namespace toile::accounts
