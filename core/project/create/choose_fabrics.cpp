#include "core/project/create/choose_fabrics.h"

#include <algorithm>

#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::create {
namespace {

struct GarmentWord {
  const char* word;
  const char* fabric;
};

/// The first that the name has counts, so that a sweatshirt dress is of fleece and a shirt dress of shirting.
constexpr GarmentWord kGarments[] = {
    {"tshirt", "single-jersey"},
    {"tee", "single-jersey"},
    {"jersey", "single-jersey"},
    {"polo", "interlock"},
    {"hoodie", "sweatshirt-fleece"},
    {"hoody", "sweatshirt-fleece"},
    {"jeans", "denim-10oz"},
    {"leggings", "ponte"},
    {"legging", "ponte"},
    {"yoga", "ponte"},
    {"tights", "ponte"},
    {"leotard", "ponte"},
    {"bodysuit", "ponte"},
    {"swimsuit", "ponte"},
    {"swimwear", "ponte"},
    {"bikini", "ponte"},
    {"rashguard", "ponte"},
    {"underwear", "single-jersey"},
    {"briefs", "single-jersey"},
    {"cardigan", "interlock"},
    {"sweater", "interlock"},
    {"pyjama", "poplin"},
    {"pyjamas", "poplin"},
    {"pajama", "poplin"},
    {"pajamas", "poplin"},
    {"blazer", "wool-suiting"},
    {"suit", "wool-suiting"},
    {"coat", "wool-flannel"},
    {"sweatshirt", "sweatshirt-fleece"},
    {"trousers", "twill"},
    {"trouser", "twill"},
    {"pants", "twill"},
    {"pant", "twill"},
    {"shorts", "twill"},
    {"chinos", "twill"},
    {"shirt", "shirting"},
    {"blouse", "shirting"},
    {"dress", "shirting"},
    {"top", "single-jersey"},
};

bool has(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Words of a garment's name; "T-shirt" is one.
std::vector<std::string> garment_words(const std::string& name) {
  std::vector<std::string> words = seams::words_of_piece(name);
  for (std::size_t k = 1; k < words.size(); ++k)
    if (words[k - 1] == "t" && words[k] == "shirt") words[k] = "tshirt";
  return words;
}

/// What garments of such a name are made of; null where the words name none.
const char* fabric_of(const std::vector<std::string>& words) {
  for (const GarmentWord& known : kGarments)
    if (has(words, known.word)) return known.fabric;
  return nullptr;
}

bool are_trousers(const std::vector<std::string>& pieces) {
  const auto any = [&](seams::PieceKind kind) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const std::string& piece) { return seams::words_of(piece).kind == kind; });
  };
  return any(seams::PieceKind::kLegs) && !any(seams::PieceKind::kTorso);
}

/// A neckband that no collar is sewn to is a rib: knits have one, since nothing else closes their neck.
bool are_of_a_knit(const std::vector<std::string>& pieces) {
  bool band = false, collar = false;
  for (const std::string& piece : pieces) {
    const seams::PieceWords words = seams::words_of(piece);
    if (words.kind == seams::PieceKind::kCollar) (words.stand ? band : collar) = true;
  }
  return band && !collar;
}

}  // namespace

std::string garment_fabric(const std::string& name, const std::vector<std::string>& pieces) {
  if (const char* fabric = fabric_of(garment_words(name))) return fabric;
  if (are_of_a_knit(pieces)) return "single-jersey";
  if (!are_trousers(pieces)) return "shirting";
  // Legs say by their own names what trousers they are: "LEGGING LEG", "JEANS BACK".
  for (const std::string& piece : pieces)
    if (const char* fabric = fabric_of(garment_words(piece))) return fabric;
  return "twill";
}

std::string piece_fabric(const std::string& piece) {
  const std::vector<std::string> words = seams::words_of_piece(piece);
  for (const char* word : {"interlining", "interfacing", "fusing", "fusible"})
    if (has(words, word)) return "interlining";
  return has(words, "lining") || has(words, "underlining") ? "lining" : "";
}

void choose_fabrics(project::Project& project) {
  std::vector<std::string> pieces;
  for (project::ProjectPiece& piece : project.pieces) {
    pieces.push_back(piece.id);
    piece.fabric = piece_fabric(piece.id);
  }
  project.fabric = garment_fabric(project.name, pieces);
}

}  // namespace toile::create
