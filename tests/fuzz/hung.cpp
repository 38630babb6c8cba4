// How garments hung at the end of a drape (proto/hung.md).

#include "core/warm/hung_garment.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/sealed.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  warm::HungPiece piece;
  piece.id = "front";
  piece.rest = {{0, 0}, {0.1, 0}, {0, 0.1}};
  piece.triangles = {{0, 1, 2}};
  piece.edges = {{"hem", {0, 1}}, {"side", {1, 2}}};
  piece.positions = {{0, 1, 0}, {0.1, 1, 0}, {0, 1.1, 0}};
  piece.preloads = {{0, 0, 0}};
  return {unsealed(warm::encode_hung({{piece}})), unsealed(warm::encode_hung({{piece, piece}})),
          unsealed(warm::encode_hung({{piece}, {{"front", {0.02, 0.03}}}}))};
}

void try_input(std::string_view bytes) {
  const std::string file = sealed(bytes);
  const Result<warm::HungGarment> hung = warm::decode_hung(file);
  if (!hung) return;
  for (const warm::HungPiece& piece : hung->pieces) {
    expect(piece.positions.size() == piece.rest.size(), "every vertex hangs somewhere");
    expect(piece.preloads.size() == piece.triangles.size(), "every triangle has its preloads");
  }
  expect(hung->pins.size() <= warm::kMostHungPins, "no more pins than hands may set");
  expect(warm::encode_hung(*hung) == file, "what is written is read again");
}

}  // namespace toile::fuzz
