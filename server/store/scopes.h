#pragma once
// What a key lets its bearer do.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::store {

enum class Scope : std::uint8_t {
  kRead,    ///< look at what the account has
  kSubmit,  ///< make, change, drape and remove
  kAdmin,   ///< look after the whole service; of accounts that may
};

class Scopes {
 public:
  constexpr Scopes() = default;
  static constexpr Scopes all() {
    return Scopes().with(Scope::kRead).with(Scope::kSubmit).with(Scope::kAdmin);
  }
  constexpr Scopes with(Scope scope) const { return Scopes(bits_ | bit(scope)); }
  constexpr bool has(Scope scope) const { return (bits_ & bit(scope)) != 0; }
  constexpr bool none() const { return bits_ == 0; }
  friend bool operator==(const Scopes&, const Scopes&) = default;

 private:
  constexpr explicit Scopes(unsigned bits) : bits_(bits) {}
  static constexpr unsigned bit(Scope scope) { return 1U << static_cast<unsigned>(scope); }
  unsigned bits_ = 0;
};

std::string_view name_of(Scope scope);
/// "read,submit".
std::string to_text(Scopes scopes);
/// Of names with commas between them. Error: accounts.scope for a name that is none, and for none at all.
Result<Scopes> scopes_from(std::string_view text);

}  // namespace toile::store
