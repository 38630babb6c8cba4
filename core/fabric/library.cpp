#include "core/fabric/library.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/base/names.h"

namespace toile::fabric {
namespace {

/// The files are part of the program, and tests read each of them: one that is no fabric is a bug.
std::vector<FabricCard> read_all() {
  std::vector<FabricCard> cards;
  for (const FabricFile& file : fabric_files()) {
    Result<FabricCard> card = parse_fabric(file.text);
    TOILE_CHECK(card);
    cards.push_back(std::move(*card));
  }
  std::sort(cards.begin(), cards.end(),
            [](const FabricCard& a, const FabricCard& b) { return a.name < b.name; });
  return cards;
}

}  // namespace

const std::vector<FabricCard>& library() {
  static const std::vector<FabricCard> cards = read_all();
  return cards;
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const FabricCard& card : library()) out.push_back(card.name);
  return out;
}

const FabricCard* find(std::string_view name) {
  const std::vector<FabricCard>& cards = library();
  const auto found =
      std::find_if(cards.begin(), cards.end(), [&](const FabricCard& card) { return card.name == name; });
  return found == cards.end() ? nullptr : &*found;
}

Result<const FabricCard*> named(const std::string& name, const std::string& where) {
  if (const FabricCard* card = find(name)) return card;
  const std::vector<std::string> all = names();
  return Error{
      "project.unknown_fabric",
      "there is no fabric " + in_quotes(name) + "; " + advice(name, all) + " (toile fabric list has all)",
      where};
}

}  // namespace toile::fabric
