#include "server/store/scopes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/names.h"

namespace toile::store {
namespace {

constexpr std::array<std::pair<Scope, std::string_view>, 3> kNames{
    {{Scope::kRead, "read"}, {Scope::kSubmit, "submit"}, {Scope::kAdmin, "admin"}}};

std::optional<Scope> scope_from(std::string_view name) {
  for (const auto& [scope, its_name] : kNames) {
    if (its_name == name) return scope;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name_of(Scope scope) { return kNames.at(static_cast<std::size_t>(scope)).second; }

std::string to_text(Scopes scopes) {
  std::string text;
  for (const auto& [scope, name] : kNames) {
    if (!scopes.has(scope)) continue;
    if (!text.empty()) text += ',';
    text += name;
  }
  return text;
}

Result<Scopes> scopes_from(std::string_view text) {
  Scopes scopes;
  for (;;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::optional<Scope> scope = scope_from(text.substr(0, comma));
    if (!scope) {
      return Error{"accounts.scope",
                   in_quotes(text.substr(0, comma)) + " is no scope; there are read, submit and admin", ""};
    }
    scopes = scopes.with(*scope);
    if (comma == text.size()) return scopes;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace toile::store
