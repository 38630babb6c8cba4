#pragma once
// What one sees of pieces on the cloth: their colours and prints, without their outlines.

#include <string>
#include <vector>

#include "core/json/tree.h"
#include "server/documents/read_cloth.h"

namespace toile::documents {

struct SeenPieces {
  json::JsonValue pieces;  ///< [{"id", "fabric", "colour", "grain", "texture"}], as pieces_json() has them
  std::vector<std::string> fabrics;   ///< ids, each once
  std::vector<std::string> pictures;  ///< file names in the document
};
SeenPieces seen_pieces(const ReadCloth& read);

}  // namespace toile::documents
