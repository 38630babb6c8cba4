#pragma once
// Names of pieces in other languages than English, as pattern makers give them.

#include <string>
#include <string_view>
#include <vector>

namespace toile::seams {

/// The words of a piece's or a garment's name (UTF-8) as words_of_name() has them, in Latin letters without
/// accents and, where they are the trade's words of another language (piece_terms.h), in English:
/// "Ärmel_links" is "sleeve", "left", "Vorderhose" is "front", "pants", "pied de col" is "collar", "stand".
/// Articles are left out; words that are not known stay.
std::vector<std::string> words_of_piece(std::string_view name);

/// Whether such a word is the trade's, of a part of a garment in whatever language it stood.
bool tells_part(const std::string& word);

/// Whether such words tell of a piece that is cut once for each face of the body: "SKIRT FRONT / BACK".
bool tell_both_faces(const std::vector<std::string>& words);

}  // namespace toile::seams
