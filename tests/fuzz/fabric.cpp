// Fabric files.

#include <fstream>
#include <iterator>

#include "core/fabric/card.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {
namespace {

std::string file_of(const std::string& name) {
  std::ifstream file(std::string(TOILE_SOURCE_DIR) + "/fabrics/" + name + ".json", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<std::string> seeds() { return {file_of("shirting"), file_of("single-jersey"), "{}"}; }

void try_input(std::string_view bytes) {
  const Result<fabric::FabricCard> card = fabric::parse_fabric(bytes);
  if (!card) return;
  const Result<fabric::FabricCard> again = fabric::parse_fabric(fabric::write_fabric(*card));
  expect(again.ok() && *again == *card, "what is written is read again");
  const double distance = fabric::fitting_distance(fabric::fabric_of(*card));
  expect(distance >= 0.006 && distance <= 0.015, "a card's cloth has a fitting distance");
}

}  // namespace toile::fuzz
