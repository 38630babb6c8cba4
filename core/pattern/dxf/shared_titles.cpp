#include "core/pattern/dxf/shared_titles.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace toile::dxf {
namespace {

/// How many pieces have each title.
std::map<std::string, std::size_t> uses_of(const std::vector<DxfFound>& pieces) {
  std::map<std::string, std::size_t> uses;
  for (const DxfFound& found : pieces) {
    std::set<std::string> own;
    for (const DxfTitle& title : found.titles)
      if (own.insert(title.text).second) ++uses[title.text];
  }
  return uses;
}

}  // namespace

DxfNamed named_by_what_differs(std::vector<DxfFound> pieces) {
  constexpr std::size_t kSeveral = 3;  // pieces
  DxfNamed named{std::move(pieces), {}};
  const std::map<std::string, std::size_t> uses = uses_of(named.pieces);
  const auto is_shared = [&](const std::string& text) {
    const auto met = uses.find(text);
    return met != uses.end() && met->second >= kSeveral && 2 * met->second > named.pieces.size();
  };
  for (DxfFound& found : named.pieces) {
    if (!is_shared(found.piece.name)) continue;
    for (const DxfTitle& title : found.titles) {
      if (is_shared(title.text)) continue;
      found.piece.name = title.text;
      if (title.entity) named.notes.mark(*title.entity, DxfFate::kConverted, "name of the piece", found.id);
      break;
    }
  }
  return named;
}

}  // namespace toile::dxf
