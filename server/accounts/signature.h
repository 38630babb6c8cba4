#pragma once
// By which whoever is told something knows that we have said it.

#include <string>
#include <string_view>

namespace toile::accounts {

/// HMAC-SHA256 (RFC 2104) of a text, 64 hex digits.
std::string hmac_sha256(std::string_view secret, std::string_view text);

}  // namespace toile::accounts
