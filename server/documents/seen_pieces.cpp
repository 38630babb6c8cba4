#include "server/documents/seen_pieces.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "server/documents/views.h"

namespace toile::documents {
namespace {

void put_once(std::vector<std::string>& list, const std::string& word) {
  if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
}

}  // namespace

SeenPieces seen_pieces(const ReadCloth& read) {
  SeenPieces seen;
  std::vector<json::JsonValue> pieces;
  for (std::size_t i = 0; i < read.cloth.pattern.panels.size(); ++i) {
    const pattern::Panel& panel = read.cloth.pattern.panels[i];
    const project::ProjectPiece& told = read.project.pieces[i];
    const material::Fabric& fabric =
        read.cloth.fabrics[static_cast<std::size_t>(read.cloth.fabric_of_panel[i])];
    std::vector<json::JsonValue> colour;
    for (const double channel : fabric.colour) colour.push_back(channel);
    pieces.push_back(
        std::vector<json::JsonMember>{{"id", panel.id},
                                      {"fabric", fabric.id},
                                      {"colour", std::move(colour)},
                                      {"grain", std::vector<json::JsonValue>{panel.grain.x, panel.grain.y}},
                                      {"texture", texture_json(told.texture)}});
    put_once(seen.fabrics, fabric.id);
    if (told.texture) put_once(seen.pictures, told.texture->image);
  }
  seen.pieces = json::JsonValue(std::move(pieces));
  return seen;
}

}  // namespace toile::documents
