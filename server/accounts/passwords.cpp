#include "server/accounts/passwords.h"

#include <sodium.h>

#include <array>

#include "core/base/check.h"

namespace toile::accounts {
namespace {

// What OWASP asks of argon2id at the least.
constexpr unsigned long long kPasses = 2;
constexpr std::size_t kMemory = std::size_t{19} << 20;

using Text = std::array<char, crypto_pwhash_STRBYTES>;

bool make_hash(const std::string& password, Text& hash) {
  TOILE_CHECK(sodium_init() >= 0);
  return crypto_pwhash_str_alg(hash.data(), password.data(), password.size(), kPasses, kMemory,
                               crypto_pwhash_ALG_ARGON2ID13) == 0;
}

}  // namespace

Result<std::string> hash_of_password(const std::string& password) {
  if (password.size() < kShortestPassword || password.size() > kLongestPassword) {
    return Error{"accounts.password",
                 "a password has " + std::to_string(kShortestPassword) + " to " +
                     std::to_string(kLongestPassword) + " bytes",
                 "/password"};
  }
  Text hash{};
  if (make_hash(password, hash)) return std::string(hash.data());
  return Error{"internal.memory", "there is not enough memory for this", "", ErrorKind::kInternal};
}

bool is_password(const std::string& password, const std::string& hash) {
  TOILE_CHECK(sodium_init() >= 0);
  if (password.size() > kLongestPassword) return false;
  if (hash.empty()) {
    Text nobodys{};
    make_hash(password, nobodys);
    return false;
  }
  return crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

}  // namespace toile::accounts
