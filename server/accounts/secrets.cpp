#include "server/accounts/secrets.h"

#include <sodium.h>

#include <array>

#include "core/base/check.h"

namespace toile::accounts {
namespace {

constexpr std::size_t kBytes = 32;
using Bytes = std::array<unsigned char, kBytes>;

std::string hex_of(const Bytes& bytes) {
  std::array<char, 2 * kBytes + 1> text{};
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  return text.data();
}

/// The library wants to be begun; it may be begun often, from any thread.
void begin() { TOILE_CHECK(sodium_init() >= 0); }

}  // namespace

std::string new_secret() {
  begin();
  Bytes bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return "toile_" + hex_of(bytes);
}

std::string hash_of_secret(std::string_view secret) {
  begin();
  Bytes hash{};
  const auto* text = reinterpret_cast<const unsigned char*>(secret.data());
  crypto_generichash(hash.data(), hash.size(), text, secret.size(), nullptr, 0);
  return hex_of(hash);
}

}  // namespace toile::accounts
